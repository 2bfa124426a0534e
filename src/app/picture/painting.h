// Draws a picture part by part into its file, so that pictures of any size need little memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/app/picture/picture.h"
#include "src/app/picture/tiles.h"
#include "src/content/image/rows.h"
#include "src/gl/target.h"

namespace snell::app {

class Painting {
public:
    // The GL context that is current now must be current for every call. `file` appears only when the picture is
    // complete. `display` is Runtime::display_pixels() of what will be drawn.
    Painting(const std::string& file, const PictureSize& size, const Tiling& tiling, bool transparent,
             gl::Pixels display);

    // Draws the next part and returns true if there are more. All parts must have the same runtime and frame.
    bool step(Runtime& runtime, Frame frame);
    // "", or why the picture cannot be made; step() then returns false.
    const std::string& error() const { return error_; }
    bool without_graphics() const { return !target_.framebuffer; }
    // From 0 to 1.
    double progress() const { return static_cast<double>(done_) / static_cast<double>(parts_.size()); }

private:
    void place(const content::Image& part, const PixelRect& at);

    PictureSize size_;
    PictureKind kind_;
    std::vector<PixelRect> parts_;
    std::size_t done_ = 0;
    std::uint64_t drawn_ = 0;  // number of the runtime's frames after the last part
    gl::Target target_;
    content::Image band_;  // one row of parts, as wide as the picture
    std::unique_ptr<content::RowWriter> file_;
    std::string error_;
};

}  // namespace snell::app
