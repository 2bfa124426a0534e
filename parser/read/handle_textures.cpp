// Textures, and the targets that are drawn to.
#include <algorithm>
#include <bit>

#include "parser/commands/handlers.h"
#include "parser/read/builder.h"
#include "parser/read/match.h"

namespace snell::handle {
namespace {

constexpr int most_units = 192;         // OpenGL 4's least is 80; drivers offer up to 192
constexpr int largest_irradiance = 64;  // it is smooth: 16 are good for a thousandth
constexpr int smallest_prefilter = 16, largest_prefilter = 1024;

bool good_unit(Builder& b, const Arguments& a, std::size_t i) {
    if (a.integer(i) >= 0 && a.integer(i) < most_units) return true;
    b.report().error("unit-out-of-range", a.span(i), "texture units are 0 to " + std::to_string(most_units - 1));
    return false;
}

bool good_sizes(Builder& b, const Arguments& a, TextureTarget target) {
    const auto most = static_cast<int>(b.limits().texture_side);
    double bytes = 4;  // of 8 bits a channel
    for (std::size_t i = 1; i < a.size(); ++i) {
        bytes *= a.integer(i);
        if (a.integer(i) >= 1 && a.integer(i) <= most) continue;
        b.report().error("size-out-of-range", a.span(i),
                         "a texture has 1 to " + std::to_string(most) + " texels a side",
                         a.integer(i) > most ? limit_help(b.limits(), &Limits::texture_side) : "");
        return false;
    }
    if (target == TextureTarget::cube) bytes *= a.integer(1);
    if (bytes <= static_cast<double>(b.limits().texture_bytes)) return true;
    b.report().error("texture-too-large", a.span(), "the texture would take more memory than one may",
                     limit_help(b.limits(), &Limits::texture_bytes));
    return false;
}

// Unit and files, or unit and sizes: `sizes` is the alternative of the latter. `encoded`: an encoding may follow files.
void texture(Builder& b, const Arguments& a, TextureTarget target, std::size_t sizes, bool encoded = false) {
    if (!good_unit(b, a, 0)) return;
    Texture t;
    t.unit = a.integer(0);
    t.target = target;
    t.filter = b.filter;
    t.span = a.span();
    if (a.alternative() == sizes) {
        if (!good_sizes(b, a, target)) return;
        for (std::size_t i = 1; i < a.size(); ++i) t.size[i - 1] = a.integer(i);
    } else {
        const std::size_t files = encoded ? a.size() - 1 : a.size();
        if (encoded && a.given(files)) t.encoding = static_cast<Encoding>(a.integer(files));
        for (std::size_t i = 1; i < files; ++i) t.files.push_back({file_name(a.text(i)), a.span(i), b.from});
    }
    b.bind(std::move(t));
}

void noise(Builder& b, const Arguments& a, int& resolution, Span& span, std::uint64_t Limits::*limit) {
    span = a.span();
    const auto largest = static_cast<int>(b.limits().*limit);
    if (a.integer(0) >= 1 && a.integer(0) <= largest) {
        resolution = a.integer(0);
        return;
    }
    b.report().error("size-out-of-range", a.span(0),
                     "noise has a resolution of 1 to " + std::to_string(largest) + ": it is left as it was",
                     a.integer(0) > largest ? limit_help(b.limits(), limit) : "");
}

// Returns the texture on the unit; reports an error and returns `none` if there is none.
Index target_on(Builder& b, const Arguments& a, std::size_t i, TextureTarget target) {
    if (!good_unit(b, a, i)) return none;
    const auto index = b.bound(a.integer(i), target);
    const std::string unit = std::to_string(a.integer(i));
    const bool cube = target == TextureTarget::cube;
    if (index && b.scene().textures[*index].computed == Computed::no) return *index;
    if (index) {
        b.report().error("computed-target", a.span(i),
                         "the cube map on unit " + unit + " is computed from another and cannot be drawn to",
                         "draw to that one");
        return none;
    }
    b.report().error(
        "no-texture-on-unit", a.span(i),
        "there is no " + std::string(cube ? "cube map" : "2D texture") + " on unit " + unit + " to draw to",
        cube ? "create one before: CubeMap " + unit + " 256" : "create one before: Texture2D " + unit + " 512 512");
    return none;
}

// The cube map that another is computed from.
Index source_on(Builder& b, const Arguments& a, std::size_t i) {
    if (!good_unit(b, a, i)) return none;
    const std::string unit = std::to_string(a.integer(i));
    const auto index = b.bound(a.integer(i), TextureTarget::cube);
    if (!index) {
        b.report().error("no-texture-on-unit", a.span(i), "there is no cube map on unit " + unit + " to compute from",
                         "name one before: CubeMap " + unit + " sky.hdr");
        return none;
    }
    if (b.scene().textures[*index].computed == Computed::no) return *index;
    b.report().error("computed-source", a.span(i), "the cube map on unit " + unit + " is itself computed from another",
                     "name the unit of that one");
    return none;
}

void computed(Builder& b, const Arguments& a, Computed what, int size, Filter filter) {
    if (!good_unit(b, a, 0)) return;
    Texture t;
    t.unit = a.integer(0);
    t.target = TextureTarget::cube;
    t.computed = what;
    t.from = a.integer(1);
    t.source = source_on(b, a, 1);
    if (t.source == none) return;
    t.size[0] = size;
    t.filter = filter;
    t.span = a.span();
    b.bind(std::move(t));
}

// Of faces a frame, so that every face is as old as the others: 4 and 5 take two frames, as 3 does.
int faces_per_frame(Builder& b, const Arguments& a, std::size_t i) {
    const int faces = a.integer(i);
    if (faces == 1 || faces == 2 || faces == 3 || faces == 6) return faces;
    b.report().error("faces-per-frame", a.span(i), "a frame refreshes 1, 2, 3 or 6 faces: 6 are taken");
    return 6;
}

}  // namespace

void texture_1d(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::d1, 1); }
void texture_2d(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::d2, 0, true); }
void texture_3d(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::d3, 0); }
void cube_map(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::cube, 2, true); }

void filter(Builder& b, const Arguments& a) {
    b.filter.mode = static_cast<Filter::Mode>(a.integer(0));
    b.filter.anisotropy = 1;
    if (b.filter.mode != Filter::Mode::anisotropic) return;
    constexpr int most = 16;  // what every GPU clamps to
    b.filter.anisotropy = std::clamp(a.integer(1), 1, most);
    if (b.filter.anisotropy != a.integer(1))
        b.report().warning("size-out-of-range", a.span(1),
                           "anisotropy is 1 to 16: " + std::to_string(b.filter.anisotropy) + " is used");
}

void noise_2d(Builder& b, const Arguments& a) {
    noise(b, a, b.scene().noise2d, b.scene().noise_spans[0], &Limits::noise_2d);
}
void noise_3d(Builder& b, const Arguments& a) {
    noise(b, a, b.scene().noise3d, b.scene().noise_spans[1], &Limits::noise_3d);
}

void render_to_texture(Builder& b, const Arguments& a) {
    Pass pass;
    pass.span = a.span();
    pass.kind = a.size() == 0 ? Pass::Kind::window : Pass::Kind::textures;
    for (std::size_t i = 0; i < a.size(); ++i) {
        pass.units.push_back(a.integer(i));
        pass.textures.push_back(target_on(b, a, i, TextureTarget::d2));
    }
    b.begin_pass(std::move(pass));
}

void render_to_cube(Builder& b, const Arguments& a) {
    Pass pass;
    pass.span = a.span();
    pass.kind = Pass::Kind::cube;
    pass.units = {a.integer(0)};
    pass.textures = {target_on(b, a, 0, TextureTarget::cube)};
    const bool spread = a.alternative() == 0;
    pass.center = spread ? Vec3{a.number(1), a.number(2), a.number(3)} : a.vec3(1);
    pass.faces_per_frame = faces_per_frame(b, a, spread ? 4 : 2);
    b.begin_pass(std::move(pass));
}

void irradiance(Builder& b, const Arguments& a) {
    const int size = std::clamp(a.integer(2), 1, largest_irradiance);
    if (size != a.integer(2))
        b.report().warning("size-out-of-range", a.span(2),
                           "irradiance has 1 to " + std::to_string(largest_irradiance) +
                               " texels a side: " + std::to_string(size) + " are taken");
    computed(b, a, Computed::irradiance, size, {});
}

void prefilter(Builder& b, const Arguments& a) {
    int size = 0;
    if (a.given(2)) {
        const int inside = std::clamp(a.integer(2), smallest_prefilter, largest_prefilter);
        size = static_cast<int>(std::bit_floor(static_cast<unsigned>(inside)));
        if (size != a.integer(2))
            b.report().warning("size-out-of-range", a.span(2),
                               "a chain begins with a power of two from " + std::to_string(smallest_prefilter) +
                                   " to " + std::to_string(largest_prefilter) +
                                   " texels a side: " + std::to_string(size) + " are taken");
    }
    computed(b, a, Computed::prefilter, size, {Filter::Mode::mipmap, 1});
}

}  // namespace snell::handle
