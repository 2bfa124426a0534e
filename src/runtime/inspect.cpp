#include "src/runtime/inspect.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"
#include "src/gl/driver.h"
#include "src/gl/program.h"
#include "src/gl/texture.h"
#include "src/plan/view.h"
#include "src/runtime/impl.h"

namespace snell {

namespace {

// Reads a rectangle of the framebuffer that is bound for reading.
void read(const PixelRect& region, GLenum format, std::vector<float>& values) {
    const auto& [left, bottom, width, height] = region;
    const std::size_t channels = format == GL_RGBA ? 4 : 1;
    values.resize(channels * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    gl::settle();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(left, bottom, width, height, format, GL_FLOAT, values.data());
}

struct Look {
    std::string_view name;
    std::array<std::uint8_t, 3> color;
};

constexpr std::array<Look, flag_count> looks{{{"", {0, 0, 0}},
                                              {"above 1", {255, 106, 0}},
                                              {"negative", {40, 140, 255}},
                                              {"infinite", {255, 232, 0}},
                                              {"NaN", {255, 0, 220}}}};

const Look& look_of(Flag flag) { return looks[static_cast<std::size_t>(flag)]; }

constexpr const char* ids_fragment =
    "uniform sampler2D cover;\nout vec4 color;\nuniform vec4 id;\nvoid main() {\n"
    "    if (texelFetch(cover, ivec2(gl_FragCoord.xy), 0).a >= 1.) discard;\n    color = id;\n}\n";

// Each of the four samples lies between four texels: together they see all around the pixel. A dark rim around the
// bright line is seen on any picture.
constexpr const char* outline_fragment =
    "uniform sampler2D cover;\nout vec4 color;\nuniform float width;\n"
    "bool covered(float away) {\n    vec2 size = vec2(textureSize(cover, 0));\n    float least = 1.;\n"
    "    for (int i = 0; i < 4; ++i)\n"
    "        least = min(least, texture(cover, (gl_FragCoord.xy + away * vec2((i & 1) * 2 - 1, (i & 2) - 1)) / "
    "size).a);\n"
    "    return least < .998;\n}\n"
    "void main() {\n    if (texelFetch(cover, ivec2(gl_FragCoord.xy), 0).a < 1.) discard;\n"
    "    bool line = covered(width - .5);\n    if (!line && !covered(width + .5)) discard;\n"
    "    color = line ? vec4(1., .62, .05, 1.) : vec4(.1, .06, 0., 1.);\n}\n";

}  // namespace

bool FloatPicture::resize(int width, int height) {
    if (target_.framebuffer && target_.width == width && target_.height == height) return true;
    target_ = {};
    target_ = gl::make_target(width, height, 1, gl::Pixels::rgba32f);
    return static_cast<bool>(target_.framebuffer);
}

// Draws the surface's region, by default all of it, and reads it with the bottom row first.
void FloatPicture::take(Runtime& runtime, const Frame& frame, const Surface& surface, std::vector<float>& rows) {
    const auto shoot = [&](const Frame& shot, std::vector<float>& values) {
        runtime.draw(shot, surface);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, surface.framebuffer);
        read(surface.region.value_or(PixelRect{0, 0, surface.width, surface.height}), GL_RGBA, values);
        glBindFramebuffer(GL_FRAMEBUFFER, 0);
    };
    const std::uint64_t before = runtime.counters().blended_draws;
    shoot(frame, rows);
    if (runtime.counters().blended_draws == before) return;
    Frame written = frame;
    written.standing = written.unblended = true;
    shoot(written, written_);
    for (std::size_t at = 0; at < rows.size(); at += 4)
        if (const float alpha = written_[at + 3]; alpha < 0 || alpha > 1)
            std::copy_n(written_.begin() + static_cast<std::ptrdiff_t>(at), 4,
                        rows.begin() + static_cast<std::ptrdiff_t>(at));
}

void FloatPicture::draw(Runtime& runtime, const Frame& frame, std::vector<float>& rgba,
                        const std::optional<PixelRect>& part) {
    const auto at = [](int pixels, int width = 1) { return std::ptrdiff_t{4} * pixels * width; };
    const auto [left, bottom, width, height] = part.value_or(PixelRect{0, 0, target_.width, target_.height});
    take(runtime, frame, {target_.framebuffer.get(), target_.width, target_.height, part}, rows_);
    rgba.resize(static_cast<std::size_t>(at(target_.width, target_.height)));
    for (int row = 0; row < height; ++row)
        std::copy_n(rows_.begin() + at(row, width), at(width),
                    rgba.begin() + at(target_.height - 1 - bottom - row, target_.width) + at(left));
}

void FloatPicture::inspect(Runtime& runtime, const Frame& frame, int x, int y, int radius, Inspection& found) {
    const int width = target_.width, height = target_.height;
    found.x = x = std::clamp(x, 0, width - 1);
    found.y = y = std::clamp(y, 0, height - 1);
    found.radius = radius = std::max(0, radius);
    found.light = runtime.display_pixels() == gl::Pixels::srgb8;
    const int left = std::max(0, x - radius), right = std::min(width - 1, x + radius);
    const int top = std::max(0, y - radius), bottom = std::min(height - 1, y + radius);
    const PixelRect region{left, height - 1 - bottom, right - left + 1, bottom - top + 1};
    Surface surface{target_.framebuffer.get(), width, height};
    surface.region = region;
    take(runtime, frame, surface, rows_);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.framebuffer.get());
    const auto side = static_cast<std::size_t>(2 * radius + 1);
    found.rgba.assign(4 * side * side, 0);
    found.inside.assign(side * side, 0);
    for (int row = top; row <= bottom; ++row) {
        const auto from = rows_.begin() + static_cast<std::ptrdiff_t>(bottom - row) * region.width * 4;
        const std::size_t to = found.at(left - x, row - y);
        std::copy_n(from, region.width * 4, found.rgba.begin() + static_cast<std::ptrdiff_t>(4 * to));
        std::fill_n(found.inside.begin() + static_cast<std::ptrdiff_t>(to), region.width, 1);
    }
    found.depth.reset();
    found.distance.reset();
    const PixelRect middle{x, height - 1 - y, 1, 1};
    if (gl::is_desktop()) {  // OpenGL ES reads no depths
        read(middle, GL_DEPTH_COMPONENT, rows_);
        found.depth = rows_[0];
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    const std::vector<Index> drawn = runtime.pick(frame, width, height, middle);
    found.draw = drawn.empty() ? none : drawn.front();
    if (found.draw != none && found.depth && *found.depth < 1)
        found.distance = runtime.distance(found.draw, *found.depth, frame, surface);
}

std::string_view name(Flag flag) { return look_of(flag).name; }
std::array<std::uint8_t, 3> color_of(Flag flag) { return look_of(flag).color; }

Flag flag_of(float value) {
    if (std::isnan(value)) return Flag::nan;
    if (std::isinf(value)) return Flag::infinite;
    return value < 0 ? Flag::negative : value > 1 ? Flag::above_one : Flag::none;
}

Flag flag_of(std::span<const float, 4> rgba) {
    Flag worst = flag_of(rgba[3]);
    if (worst < Flag::infinite) worst = Flag::none;
    for (const float value : rgba.first<3>()) worst = std::max(worst, flag_of(value));
    return worst;
}

FlagCounts count_flags(std::span<const float> rgba) { return count_flags(rgba, 1).front(); }

std::vector<FlagCounts> count_flags(std::span<const float> rgba, int columns) {
    std::vector<FlagCounts> counts(static_cast<std::size_t>(columns));
    while (rgba.size() >= 4 * counts.size())
        for (FlagCounts& column : counts) {
            ++column.pixels[static_cast<std::size_t>(flag_of(rgba.first<4>()))];
            rgba = rgba.subspan(4);
        }
    return counts;
}

void paint_flags(std::span<const float> rgba, std::vector<std::byte>& picture) {
    picture.resize(rgba.size() / 4 * 4);
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4) {
        const Flag flag = flag_of(rgba.subspan(at).first<4>());
        const auto gray = [&] {
            const float light = .2126F * rgba[at] + .7152F * rgba[at + 1] + .0722F * rgba[at + 2];
            // The root, so that dark scenes, and light that is not encoded for the display, are recognised, too.
            constexpr float brightest = 160;
            return static_cast<std::uint8_t>(brightest * std::sqrt(std::clamp(light, 0.0F, 1.0F)));
        };
        std::array<std::uint8_t, 3> color = color_of(flag);
        if (flag == Flag::none) color.fill(gray());
        for (std::size_t c = 0; c < 3; ++c) picture[at + c] = std::byte{color[c]};
        picture[at + 3] = std::byte{255};
    }
}

namespace runtime {

bool Picker::resize(int width, int height) {
    if (cover_target_.framebuffer && width_ == width && height_ == height) return true;
    if (!nothing_) nothing_ = gl::VertexArray(gl::make(glGenVertexArrays));
    const gl::Texels empty{gl::Pixels::rgba8, width, height, 1, nullptr};
    cover_target_ = {};
    ids_target_ = {};
    cover_ = gl::make_texture(GL_TEXTURE_2D, empty, {gl::Sampling::Mode::linear, 1, true});
    ids_ = gl::make_texture(GL_TEXTURE_2D, empty, {gl::Sampling::Mode::nearest, 1, true});
    cover_target_ = gl::make_texture_target({{cover_.get(), GL_TEXTURE_2D}}, width, height);
    ids_target_ = gl::make_texture_target({{ids_.get(), GL_TEXTURE_2D}}, width, height);
    width_ = width;
    height_ = height;
    const bool whole = cover_target_.framebuffer && ids_target_.framebuffer;
    if (!whole) cover_target_.framebuffer.reset();
    return whole;
}

std::size_t Picker::bytes() const {
    return std::size_t{16} * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
}

void Picker::scissor() const {
    glEnable(GL_SCISSOR_TEST);
    glScissor(region_.left, region_.bottom, region_.width, region_.height);
}

void Picker::begin(const PixelRect& region) {
    region_ = region;
    if (!ids_program_) ids_program_ = gl::covering_program(es_, ids_fragment);
    clear();
}

void Picker::clear() {
    fresh_ = true;
    glBindFramebuffer(GL_FRAMEBUFFER, ids_target_.framebuffer.get());
    scissor();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
}

void Picker::whole() {
    region_ = {0, 0, width_, height_};
    fresh_ = true;
    cover();
}

void Picker::cover() {
    glBindFramebuffer(GL_FRAMEBUFFER, cover_target_.framebuffer.get());
    glViewport(0, 0, width_, height_);
    scissor();
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glClearColor(1, 1, 1, 1);
    glClear(fresh_ ? GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT : GL_COLOR_BUFFER_BIT);
    fresh_ = false;
}

void Picker::pass(GLuint program) {
    glViewport(0, 0, width_, height_);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    if (!es_) gl::beyond::polygon_mode(GL_FILL);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glUniform1i(glGetUniformLocation(program, "cover"), 0);
    gl::draw_covering(cover_.get(), nothing_.get());
    glUseProgram(0);
}

void Picker::commit(Index draw) {
    const Index number = draw + 1;
    glBindFramebuffer(GL_FRAMEBUFFER, ids_target_.framebuffer.get());
    glUseProgram(ids_program_.get());
    const auto byte = [number](int shift) { return static_cast<float>(number >> shift & 255) / 255.0F; };
    glUniform4f(glGetUniformLocation(ids_program_.get(), "id"), byte(0), byte(8), byte(16), byte(24));
    pass(ids_program_.get());
}

std::vector<Index> Picker::read() {
    const auto count = static_cast<std::size_t>(region_.width) * static_cast<std::size_t>(region_.height);
    std::vector<std::uint8_t> bytes(4 * count);
    gl::settle();
    glBindFramebuffer(GL_FRAMEBUFFER, ids_target_.framebuffer.get());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(region_.left, region_.bottom, region_.width, region_.height, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDisable(GL_SCISSOR_TEST);
    std::vector<Index> draws(count);
    for (std::size_t i = 0; i < count; ++i) {
        Index number = 0;
        for (std::size_t k = 4; k-- > 0;) number = number << 8 | bytes[4 * i + k];
        draws[i] = number - 1;  // of nothing: none
    }
    return draws;
}

void Picker::outline(GLuint framebuffer, float width) {
    if (!outline_program_) outline_program_ = gl::covering_program(es_, outline_fragment);
    if (!outline_program_) return;
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDisable(GL_SCISSOR_TEST);
    glUseProgram(outline_program_.get());
    glUniform1f(glGetUniformLocation(outline_program_.get(), "width"), width);
    pass(outline_program_.get());
}

void blend_into_cover(const RasterState& raster) {
    const bool by_alpha = raster.blend && raster.src == BlendFactor::src_alpha &&
                          (raster.dst == BlendFactor::one_minus_src_alpha || raster.dst == BlendFactor::one);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ZERO, by_alpha ? GL_ONE_MINUS_SRC_ALPHA : GL_ZERO);
}

}  // namespace runtime

bool Runtime::Impl::ready_picker(int width, int height) {
    if (width <= 0 || height <= 0) return false;
    if (!picker) picker = std::make_shared<runtime::Picker>(caps.es);
    counters.gpu_bytes -= picker->bytes();
    const bool ready = picker->resize(width, height);
    counters.gpu_bytes += picker->bytes();
    take_parts(false);
    state.forget();
    if (!caps.es) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    return ready;
}

void Runtime::Impl::draw_cover(const runtime::ReadyDraw& ready, const Frame& frame, PassView& view, bool depth) {
    set_up(ready, frame, view);
    runtime::blend_into_cover(plan.scene.rasters[plan.scene.draws[ready.draw].raster]);
    if (!depth) glDisable(GL_DEPTH_TEST);
    draw_mesh(ready);
    state.forget();
}

void Runtime::Impl::pick_window(Index pass, const Frame& frame, PassView& view) {
    const Pass& declared = plan.scene.passes[pass];
    for (std::size_t i = 0; i < declared.items.size(); ++i) {
        if (declared.items[i].kind == Item::Kind::clear) {
            picker->clear();
        } else if (const auto& item = passes[pass].items[i]; item && !runtime::hidden(frame, item->draw)) {
            picker->cover();
            draw_cover(*item, frame, view, true);
            picker->commit(item->draw);
        }
    }
}

std::vector<Index> Runtime::Impl::pick(const Frame& frame, int width, int height, PixelRect region) {
    const int right = std::clamp(region.left + region.width, 0, std::max(width, 0));
    const int top = std::clamp(region.bottom + region.height, 0, std::max(height, 0));
    region.left = std::clamp(region.left, 0, right);
    region.bottom = std::clamp(region.bottom, 0, top);
    region = {region.left, region.bottom, right - region.left, top - region.bottom};
    if (region.width == 0 || region.height == 0 || !ready_picker(width, height)) return {};
    const int before = picker->programs();
    picker->begin(region);
    PassView view{width, height, plan.scene.background};
    view.depth = fitted_depth(frame);
    view.shift = frame.shift;
    const bool only_window = frame.standing && !redrawn();
    find_needed(frame, view);
    for (Index pass = 0; pass < passes.size(); ++pass) {
        if (!passes[pass].live) continue;
        if (plan.scene.passes[pass].kind == Pass::Kind::window) {
            pick_window(pass, frame, view);
        } else if (due(pass, only_window)) {
            glDisable(GL_SCISSOR_TEST);
            if (plan.scene.passes[pass].kind == Pass::Kind::textures)
                draw_textures(pass, frame);
            else
                draw_cube(pass, frame);
        }
    }
    counters.programs_compiled += static_cast<std::uint64_t>(picker->programs() - before);
    return picker->read();
}

void Runtime::Impl::outline(const Frame& frame, const Surface& surface, Index draw, float line) {
    const auto draws = window_draws();
    const auto found = ranges::find(draws, draw, &runtime::ReadyDraw::draw);
    if (found == draws.end() || !ready_picker(surface.width, surface.height)) return;
    const int before = picker->programs();
    picker->whole();
    PassView view{surface.width, surface.height, plan.scene.background};
    view.depth = fitted_depth(frame);
    view.shift = frame.shift;
    draw_cover(**found, frame, view, false);
    picker->outline(surface.framebuffer, line);
    counters.programs_compiled += static_cast<std::uint64_t>(picker->programs() - before);
}

}  // namespace snell
