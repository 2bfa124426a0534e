// Values of pixels in the window, and textures of the shown scene as texels. Neither does anything until the user asks
// for it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/app/window/measure/accuracy_view.h"
#include "src/document/coarseness.h"
#include "src/document/document.h"
#include "src/gl/present.h"
#include "src/gl/texels.h"
#include "src/runtime/inspect.h"
#include "src/ui/panels/pixels.h"
#include "src/ui/panels/state.h"

namespace snell {

// A frame of what the window has drawn: off-screen targets still have what that drew, so they are not drawn again. The
// axes are left out, because they are not part of the scene. The frame has its view in `view`.
Frame drawn_again(const Document& shown, const Stand& stand, View& view);

class PixelView {
public:
    // What the window shows: one picture, or two states side by side, the right one from a column on.
    struct Half {
        Document* document;  // null: there is no picture of that state
        std::string name;    // as ui::PixelFacts::half
    };
    struct Sight {
        std::vector<Half> halves;
        int divider = 0;
        bool heat = false;  // over it lies what differs
        Stand stand;
        std::uint64_t picture = 0;  // counts pictures
        float density = 1;          // pixels per window coordinate
        // Pixels are flagged once the picture is sharp, in strips if it lasts so many milliseconds, as Display says.
        double lasts = 0;
        bool sharp = true;
    };
    // Call it after each frame, whether the picture was drawn or is unchanged. Returns true if something must be shown
    // again.
    bool follow(const Sight& sight, const ui::PixelMemory& memory);
    int width() const { return pixels_ ? pixels_->width() : 0; }
    // The next strip can be drawn.
    bool busy() const { return strips_.has_value(); }
    // Null while nothing is requested. Valid until the next call of follow().
    const ui::PixelFacts* facts() const { return pixels_ ? &facts_ : nullptr; }
    // The pixel that is inspected, from the upper left; null if none is.
    const Inspection* inspection() const { return pixels_ ? facts_.inspection : nullptr; }
    // That of two states there. Returns true if it must be shown again.
    bool set_difference(std::optional<double> difference) {
        return std::exchange(facts_.difference, difference) != difference;
    }
    // Draws the flagged pixels over the window's picture, whose bottom left is at pixel (0, y); right of the divider,
    // those of the right half.
    void show(int y, std::optional<int> divider) const;

private:
    // These return true if something must be shown again.
    bool follow_pointer(const Sight& sight, const ui::PixelMemory& memory);
    bool follow_flags(const Sight& sight, bool wanted);
    void look(Document& shown, const Stand& stand, int x, int y);
    // Draws the next strips, of all halves if that does not take long.
    void flag(const Sight& sight);
    // Counts what is seen of each half.
    bool count(const Sight& sight);
    // Returns true if there were flags, or some to come.
    bool unflag();

    // A half whose pixels were looked at.
    struct Marked {
        std::vector<FlagCounts> columns;  // none, and an empty picture: there is no such state
        gl::Still still;
    };

    static constexpr int radius = 4;  // of the magnified area, in pixels
    std::unique_ptr<FloatPicture> pixels_;
    std::uint64_t looked_ = 0;                                    // the picture that was inspected last; 0: none
    std::string half_;                                            // likewise
    std::pair<std::uint64_t, std::vector<std::string>> flagged_;  // the picture that is flagged, and its halves
    std::vector<Marked> marked_;                                  // as many of these as are ready
    std::optional<Strips> strips_;                                // of the next one
    Inspection found_;
    std::vector<float> rgba_;
    View view_;
    std::vector<std::byte> painted_;
    ui::PixelFacts facts_;
};

// Textures of the shown scene as texels in the window. It does nothing until the user opens their panel.

class TextureView {
public:
    explicit TextureView(bool es) : es_(es) {}

    // Call it after each frame, whether the picture was drawn or is unchanged. `picture` counts pictures, and
    // `revision` readings of the files; `density` is pixels per window coordinate. Returns true if something must be
    // shown again.
    bool follow(const Document& shown, std::uint64_t revision, std::uint64_t picture, const ui::Memory& memory,
                float density);
    // Null while the panel is closed. Valid until the next call of follow().
    const ui::TextureFacts* facts() const { return open_ ? &facts_ : nullptr; }

private:
    // A texture of the scene, or noise.
    struct Source {
        Index texture = none;
        int noise = 0;
    };
    // What the picture depends on.
    struct Shown {
        std::size_t row = 0;
        int level = 0, slice = 0;
        std::pair<std::uint64_t, int> listed;
        std::uint64_t picture = 0;  // 0 if no frame changes the texture
        bool operator==(const Shown&) const = default;
    };
    struct Drawn {
        Shown shown;
        gl::TexelLook look;
        int width = 0, height = 0;
        bool operator==(const Drawn&) const = default;
    };

    bool close();
    void list(const Document& shown);
    void add(Source source, std::string name, std::string why, const std::optional<Runtime::Held>& held);
    bool draw(const gl::Plane& plane, const Shown& shown, const ui::Memory& memory, float density);
    bool look(const gl::Plane& plane, const Shown& shown, const ui::TextureMemory& memory);
    bool count(const gl::Plane& plane, const Shown& shown, bool wanted);

    bool es_;
    bool open_ = false;
    std::unique_ptr<gl::TexelViewer> viewer_;
    std::pair<std::uint64_t, int> listed_{0, 0};  // the revision and Runtime::form() of the rows
    std::vector<ui::TextureRow> rows_;
    std::vector<Source> sources_;  // of the rows
    bool light_ = false;
    Drawn drawn_;
    std::optional<Shown> looked_, counted_;
    Inspection found_;
    ui::TextureFacts facts_;
};

}  // namespace snell
