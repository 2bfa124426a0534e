#include "src/app/picture/picture.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "src/document/document.h"
#include "src/plan/locate.h"
#include "src/runtime/inspect.h"

namespace snell::app {

namespace {

// The first `channels` of the four.
template <int channels, class Channel>
content::Image picture_of(const std::vector<Channel>& rgba, int width) {
    const std::size_t count = rgba.size() / 4;
    constexpr std::size_t kept = channels * sizeof(Channel);
    content::Image image{.width = width,
                         .height = static_cast<int>(count / static_cast<std::size_t>(width)),
                         .channels = channels,
                         .type = sizeof(Channel) == 1 ? content::PixelType::u8 : content::PixelType::f32};
    image.pixels.resize(count * kept);
    std::byte* to = image.pixels.data();
    for (const Channel* from = rgba.data(); from != rgba.data() + 4 * count; from += 4, to += kept)
        std::memcpy(to, from, kept);
    return image;
}

// Returns the alpha of a pixel from its three channels over black and over white.
template <class Number>
double covered(const Number* black, const Number* white, double one) {
    double shows = 0;
    for (int c = 0; c < 3; ++c) shows += (static_cast<double>(white[c]) - static_cast<double>(black[c])) / (3 * one);
    return std::isfinite(shows) ? std::clamp(1 - shows, 0., 1.) : 1;
}

void take_background(std::vector<float>& black, const std::vector<float>& white) {
    for (std::size_t i = 0; i + 3 < black.size(); i += 4)
        black[i + 3] = static_cast<float>(covered(&black[i], &white[i], 1));
}

void take_background(std::vector<std::byte>& black, const std::vector<std::byte>& white) {
    const auto* over_black = reinterpret_cast<const unsigned char*>(black.data());
    const auto* over_white = reinterpret_cast<const unsigned char*>(white.data());
    for (std::size_t i = 0; i + 3 < black.size(); i += 4) {
        const double alpha = covered(over_black + i, over_white + i, 255);
        for (std::size_t c = 0; c < 3; ++c) {
            const double own = alpha > 0 ? std::min(255., over_black[i + c] / alpha) : 0;
            black[i + c] = static_cast<std::byte>(std::lround(own));
        }
        black[i + 3] = static_cast<std::byte>(std::lround(alpha * 255));
    }
}

// Of bytes that are encoded: as PNG's alpha is a share of light, the background is taken from the light.
void take_background_of_light(std::vector<std::byte>& black, const std::vector<std::byte>& white) {
    const auto decoded = [](const std::vector<std::byte>& bytes) {
        std::vector<float> light;
        for (const std::byte b : bytes)
            light.push_back(static_cast<float>(content::light_of_srgb(std::to_integer<int>(b) / 255.)));
        return light;
    };
    std::vector<float> light = decoded(black);
    take_background(light, decoded(white));
    for (std::size_t i = 0; i < light.size(); ++i) {
        const double alpha = static_cast<double>(light[i - i % 4 + 3]);
        const double own = alpha > 0 ? content::srgb_of_light(static_cast<double>(light[i]) / alpha) : 0;
        black[i] = static_cast<std::byte>(std::lround(255 * (i % 4 == 3 ? alpha : std::min(1., own))));
    }
}

template <class Read>
content::Image drawn(Runtime& runtime, Frame frame, const Surface& surface, bool transparent, int width, Read read) {
    if (transparent) frame.background = Vec4{0, 0, 0, 1};
    runtime.draw(frame, surface);
    auto pixels = read();
    if (!transparent) return picture_of<3>(pixels, width);
    frame.background = Vec4{1, 1, 1, 1};
    frame.standing = true;
    runtime.draw(frame, surface);
    if constexpr (sizeof pixels[0] == 1) {
        if (runtime.display_pixels() == gl::Pixels::srgb8) {
            take_background_of_light(pixels, read());
            return picture_of<4>(pixels, width);
        }
    }
    take_background(pixels, read());
    return picture_of<4>(pixels, width);
}

}  // namespace

bool holds_floats(const std::string& path) {
    return has_extension(path, "exr") || has_extension(path, "hdr") || has_extension(path, "pfm");
}

bool holds_alpha(const std::string& path) { return has_extension(path, "png") || has_extension(path, "exr"); }

content::Image draw_picture(Runtime& runtime, Frame frame, const gl::Target& target, Surface surface,
                            const PictureKind& kind) {
    surface.framebuffer = target.framebuffer.get();
    const int width = surface.part ? surface.part->width : surface.width;
    const int height = surface.part ? surface.part->height : surface.height;
    if (kind.floats)
        return drawn(runtime, frame, surface, kind.transparent, width,
                     [&] { return gl::read_rgba32f(surface.framebuffer, width, height, target.samples); });
    return drawn(runtime, frame, surface, kind.transparent, width,
                 [&] { return gl::read_rgba8(surface.framebuffer, width, height, target.samples, target.pixels); });
}

DrawnScene scene_picture(const std::string& scene, const ScenePicture& wanted, const gl::Caps& caps) {
    DrawnScene drawn;
    Diagnostics wrong;
    const auto choose = [&](const Scene& read, Rungs& rungs) {
        for (const std::string& rung : wanted.ladders) choose_rung(rungs, read, rung, wrong);
    };
    const auto document =
        open_document(scene, caps, choose, nullptr, {}, access_to(scene, wanted.access, wanted.grade));
    drawn.messages = render(document->diagnostics, document->sources);
    drawn.misfit = wrong.has_errors();
    if (!document->runtime) return drawn;
    Controls controls = document->controls;
    for (const std::string& set : wanted.sets) set_control(controls, document->scene(), set, wrong);
    drawn.messages += render(wrong, document->sources);
    drawn.misfit = wrong.has_errors();
    if (document->diagnostics.has_errors() || drawn.misfit) return drawn;
    const auto [width, height] =
        wanted.size.value_or(std::pair(document->scene().window_size[0], document->scene().window_size[1]));
    Runtime& runtime = *document->runtime;
    const gl::Target target = gl::make_target(width, height, wanted.samples, runtime.display_pixels());
    if (!target.framebuffer) {
        drawn.messages += "snell: error: this OpenGL gives no picture of this size\n";
        return drawn;
    }
    const View view;
    Frame frame{wanted.time, view, controls};
    drawn.picture.image = draw_picture(runtime, frame, target, {.width = width, .height = height}, {});
    frame.standing = true;
    FloatPicture floats;
    std::vector<float> rgba;
    if (floats.resize(width, height)) floats.draw(runtime, frame, rgba);
    const auto channels = static_cast<std::size_t>(drawn.picture.image->channels);
    for (std::size_t i = 0; i < rgba.size(); ++i)
        if (i % 4 < 3 && std::isnan(rgba[i])) drawn.picture.replaced.push_back(i / 4 * channels + i % 4);
    return drawn;
}

Painting::Painting(const std::string& file, const PictureSize& size, const Tiling& tiling, bool transparent,
                   gl::Pixels display)
    : size_(size), kind_{size.floats, transparent}, parts_(parts_of(size, tiling)) {
    target_ = gl::make_target(tiling.width, tiling.height, size.samples, size.floats ? gl::Pixels::rgba32f : display);
    if (!target_.framebuffer) {
        error_ = fmt::format("this OpenGL gives no picture of {}x{} with {} samples", tiling.width, tiling.height,
                             size.samples);
        return;
    }
    band_.width = size.width;
    band_.height = size.height;
    band_.channels = transparent ? 4 : 3;
    band_.type = size.floats ? content::PixelType::f32 : content::PixelType::u8;
    file_ = std::make_unique<content::RowWriter>(file, band_);
    error_ = file_->add({});  // finds out whether the file can be written before anything is drawn
}

void Painting::place(const content::Image& part, const PixelRect& at) {
    if (at.left == 0) {
        band_.height = at.height;
        band_.pixels.resize(band_.bytes());
    }
    for (std::size_t y = 0; y < static_cast<std::size_t>(at.height); ++y)
        std::memcpy(
            band_.pixels.data() + y * band_.row_bytes() + band_.pixel_bytes() * static_cast<std::size_t>(at.left),
            part.pixels.data() + y * part.row_bytes(), part.row_bytes());
}

bool Painting::step(Runtime& runtime, Frame frame) {
    if (!error_.empty() || done_ == parts_.size()) return false;
    const PixelRect& part = parts_[done_];
    // Off-screen targets are the same for all parts, unless something else was drawn in the meantime.
    frame.standing = done_ > 0 && runtime.counters().frames == drawn_;
    Surface surface{.width = size_.width, .height = size_.height};
    if (parts_.size() > 1) surface.part = part;
    place(draw_picture(runtime, frame, target_, surface, kind_), part);
    ++done_;
    drawn_ = runtime.counters().frames;
    if (part.left + part.width == size_.width) error_ = file_->add(band_.pixels);
    if (done_ == parts_.size() && error_.empty()) error_ = file_->finish();
    return error_.empty() && done_ < parts_.size();
}

}  // namespace snell::app
