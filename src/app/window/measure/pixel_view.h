// Values of pixels in the window. It does nothing until the user asks for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "src/app/window/measure/accuracy_view.h"
#include "src/document/document.h"
#include "src/gl/present.h"
#include "src/runtime/inspect.h"
#include "src/ui/panels/pixels.h"

namespace snell {

// The axes are left out, because they are not part of the scene.
class PixelView {
public:
    // Call it after each frame, whether the picture was drawn or is unchanged. `picture` counts pictures; `density` is
    // pixels per window coordinate. `half` names that of two states that `shown` is, where two are shown. Returns true
    // if something must be shown again.
    bool follow(Document& shown, const Stand& stand, std::uint64_t picture, const ui::PixelMemory& memory,
                float density, std::string_view half);
    // Null while nothing is requested. Valid until the next call of follow().
    const ui::PixelFacts* facts() const { return pixels_ ? &facts_ : nullptr; }
    // Draws the flagged pixels over the window's picture, whose bottom left is at pixel (0, y).
    void show(int y) const;

private:
    Frame frame(const Document& shown, const Stand& stand);
    void look(Document& shown, const Stand& stand, int x, int y);
    void flag(Document& shown, const Stand& stand);

    static constexpr int radius = 4;  // of the magnified area, in pixels
    std::unique_ptr<FloatPicture> pixels_;
    std::uint64_t looked_ = 0, flagged_ = 0;  // the pictures that were inspected and flagged last; 0: none
    std::string half_;                        // that was inspected last
    Inspection found_;
    std::vector<float> rgba_;
    View view_;
    std::vector<std::byte> painted_;
    gl::Still still_;
    ui::PixelFacts facts_;
};

}  // namespace snell
