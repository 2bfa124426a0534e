// A picture that is drawn part by part into its file: of any size, in little memory.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/app/picture.h"
#include "src/app/tiles.h"
#include "src/content/rows.h"
#include "src/gl/target.h"

namespace snell::app {

class Painting {
public:
    // Needs the GL context that was current when it was made. Nothing stands under the name `file` until it is whole.
    Painting(const std::string& file, const PictureSize& size, const Tiling& tiling, bool transparent);

    // Draws the next part. True: there are more. The same runtime and frame for all of them.
    bool step(Runtime& runtime, Frame frame);
    // "" or why there will be no picture; then step() says that there is no more to do.
    const std::string& error() const { return error_; }
    bool without_graphics() const { return !target_.framebuffer; }
    // 0 to 1.
    double progress() const { return static_cast<double>(done_) / static_cast<double>(parts_.size()); }

private:
    void place(const content::Image& part, const Surface::Part& at);

    PictureSize size_;
    PictureKind kind_;
    std::vector<Surface::Part> parts_;
    std::size_t done_ = 0;
    std::uint64_t drawn_ = 0;  // frames of the runtime, after the last part
    gl::Target target_;
    content::Image band_;  // as high as a part, as wide as the picture
    std::unique_ptr<content::RowWriter> file_;
    std::string error_;
};

}  // namespace snell::app
