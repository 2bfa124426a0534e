// Textures, and the targets that are drawn to.
#include <algorithm>

#include "parser/handlers.h"

namespace snell::handle {
namespace {

constexpr int most_units = 192;  // OpenGL 4's least is 80; drivers offer up to 192
constexpr int largest_side = 32768;
constexpr int largest_noise_2d = 4096, largest_noise_3d = 512;

bool good_unit(Builder& b, const Arguments& a, std::size_t i) {
    if (a.integer(i) >= 0 && a.integer(i) < most_units) return true;
    b.report().error("unit-out-of-range", a.span(i), "texture units are 0 to " + std::to_string(most_units - 1));
    return false;
}

bool good_sizes(Builder& b, const Arguments& a, std::size_t count) {
    for (std::size_t i = 1; i <= count; ++i) {
        if (a.integer(i) >= 1 && a.integer(i) <= largest_side) continue;
        b.report().error("size-out-of-range", a.span(i),
                         "a texture has 1 to " + std::to_string(largest_side) + " texels a side");
        return false;
    }
    return true;
}

// unit and files, or unit and sizes: `sizes` is the alternative of the latter.
void texture(Builder& b, const Arguments& a, TextureTarget target, std::size_t sizes) {
    if (!good_unit(b, a, 0)) return;
    Texture t;
    t.unit = a.integer(0);
    t.target = target;
    t.filter = b.filter;
    t.span = a.span();
    if (a.alternative() == sizes) {
        if (!good_sizes(b, a, a.size() - 1)) return;
        for (std::size_t i = 1; i < a.size(); ++i) t.size[i - 1] = a.integer(i);
    } else {
        for (std::size_t i = 1; i < a.size(); ++i) t.files.push_back({file_name(a.text(i)), a.span(i)});
    }
    b.bind(std::move(t));
}

void noise(Builder& b, const Arguments& a, int& resolution, int largest) {
    if (a.integer(0) >= 1 && a.integer(0) <= largest) {
        resolution = a.integer(0);
        return;
    }
    b.report().error("size-out-of-range", a.span(0),
                     "noise has a resolution of 1 to " + std::to_string(largest) + ": it is left as it was");
}

// What stands on the unit; an error and `none` when nothing does.
Index target_on(Builder& b, const Arguments& a, std::size_t i, TextureTarget target) {
    if (!good_unit(b, a, i)) return none;
    if (const auto index = b.bound(a.integer(i), target)) return *index;
    const std::string unit = std::to_string(a.integer(i));
    const bool cube = target == TextureTarget::cube;
    b.report().error(
        "no-texture-on-unit", a.span(i),
        "no " + std::string(cube ? "cube map" : "2D texture") + " stands on unit " + unit + " to draw to",
        cube ? "reserve one before: CubeMap " + unit + " 256" : "reserve one before: Texture2D " + unit + " 512 512");
    return none;
}

}  // namespace

void texture_1d(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::d1, 1); }
void texture_2d(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::d2, 0); }
void texture_3d(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::d3, 0); }
void cube_map(Builder& b, const Arguments& a) { texture(b, a, TextureTarget::cube, 2); }

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

void noise_2d(Builder& b, const Arguments& a) { noise(b, a, b.scene().noise2d, largest_noise_2d); }
void noise_3d(Builder& b, const Arguments& a) { noise(b, a, b.scene().noise3d, largest_noise_3d); }

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
    pass.center = a.alternative() == 0 ? Vec3{a.number(1), a.number(2), a.number(3)} : a.vec3(1);
    b.begin_pass(std::move(pass));
}

}  // namespace snell::handle
