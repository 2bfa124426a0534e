#include "src/app/picture/painting.h"

#include <fmt/format.h>

#include <cstring>

namespace snell::app {

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
