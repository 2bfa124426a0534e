#include "src/runtime/inspect.h"

#include <algorithm>
#include <cmath>

#include "src/gl/driver.h"

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

void FloatPicture::draw(Runtime& runtime, const Frame& frame, std::vector<float>& rgba) {
    const int width = target_.width, height = target_.height;
    take(runtime, frame, {target_.framebuffer.get(), width, height}, rgba);
    const auto row = static_cast<std::ptrdiff_t>(width) * 4;
    for (int top = 0, bottom = height - 1; top < bottom; ++top, --bottom)
        std::swap_ranges(rgba.begin() + top * row, rgba.begin() + (top + 1) * row, rgba.begin() + bottom * row);
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

namespace {

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

}  // namespace

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

FlagCounts count_flags(std::span<const float> rgba) {
    FlagCounts counts;
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4)
        ++counts.pixels[static_cast<std::size_t>(flag_of(rgba.subspan(at).first<4>()))];
    return counts;
}

void paint_flags(std::span<const float> rgba, std::vector<std::byte>& picture) {
    picture.resize(rgba.size() / 4 * 4);
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4) {
        const Flag flag = flag_of(rgba.subspan(at).first<4>());
        const auto gray = [&] {
            const float light = .2126F * rgba[at] + .7152F * rgba[at + 1] + .0722F * rgba[at + 2];
            return static_cast<std::uint8_t>(110 * std::clamp(light, 0.0F, 1.0F));
        };
        std::array<std::uint8_t, 3> color = color_of(flag);
        if (flag == Flag::none) color.fill(gray());
        for (std::size_t c = 0; c < 3; ++c) picture[at + c] = std::byte{color[c]};
        picture[at + 3] = std::byte{255};
    }
}

}  // namespace snell
