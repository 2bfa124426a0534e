// The window's side of pixels as numbers: nothing at all until it is asked for.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "src/app/document.h"
#include "src/app/refine.h"
#include "src/gl/still.h"
#include "src/runtime/inspect.h"
#include "src/ui/pixels.h"

namespace snell {

// The axes are left out: they are no part of the scene.
class PixelView {
public:
    // After the picture was drawn, or was found to stand. `picture` counts pictures; `density`: pixels for one window
    // coordinate. True: there is something else to show.
    bool follow(Document& shown, const Stand& stand, std::uint64_t picture, const ui::PixelMemory& memory,
                float density);
    // Null while nothing is asked for. Stands until the next call of follow().
    const ui::PixelFacts* facts() const { return pixels_ ? &facts_ : nullptr; }
    // The flagged pixels over the window's picture, whose bottom left is at pixel (0, y).
    void show(int y) const;

private:
    Frame frame(const Document& shown, const Stand& stand);
    void look(Document& shown, const Stand& stand, int x, int y);
    void flag(Document& shown, const Stand& stand);

    static constexpr int radius = 4;  // of what is magnified
    std::unique_ptr<FloatPicture> pixels_;
    std::uint64_t looked_ = 0, flagged_ = 0;  // the pictures that were looked at; 0: none
    Inspection found_;
    std::vector<float> rgba_;
    View view_;
    std::vector<std::byte> painted_;
    gl::Still still_;
    ui::PixelFacts facts_;
};

}  // namespace snell
