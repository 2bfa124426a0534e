// Pictures of a scene at any size, as bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parser/text/limits.h"
#include "src/app/picture/tiles.h"
#include "src/content/image/image.h"
#include "src/content/image/png_write.h"
#include "src/gl/context.h"
#include "src/gl/target.h"
#include "src/plan/files.h"
#include "src/runtime/runtime.h"

namespace snell::app {

// Draws pictures in the form in which they are written.

// True for formats that store floats, which get the shaders' values without rounding to bytes.
bool holds_floats(const std::string& path);

// True for formats that store alpha, which a picture without background needs.
bool holds_alpha(const std::string& path);

struct PictureKind {
    bool floats = false;
    // Makes four channels, without the background: the picture is drawn over black and over white, and the difference
    // is its transparency. Floats are multiplied by alpha, as EXR requires; bytes are not, as PNG requires. If false,
    // makes three channels: the alpha that blending leaves has no meaning.
    bool transparent = false;
};

// Draws into the target, which must be large enough for the surface's part, or for the whole surface.
content::Image draw_picture(Runtime& runtime, Frame frame, const gl::Target& target, Surface surface,
                            const PictureKind& kind);

// One picture of a scene, as `snell compare` draws it.

struct ScenePicture {
    std::vector<std::string> sets, ladders;
    std::optional<std::pair<int, int>> size;  // nullopt: the scene's own
    double time = 0;
    int samples = 1;
    Access access;
    bool grade = false;
};
struct DrawnScene {
    content::ImageResult picture;  // without an image if the scene has errors or a value does not fit
    std::string messages;          // errors and warnings
    bool misfit = false;           // a value or a rung of `wanted` does not fit
};

// Draws the scene as `snell render` does to a file of bytes. Needs a current context. NaN, which bytes cannot hold, is
// in the picture's `replaced`.
DrawnScene scene_picture(const std::string& scene, const ScenePicture& wanted, const gl::Caps& caps);

// Draws a picture part by part into its file, so that pictures of any size need little memory.

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
