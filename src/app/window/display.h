// The picture of the scene in the window. It is drawn only if it would differ from the last one, and kept, so that what
// lies over it can change without drawing it again.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "src/app/open/ending.h"
#include "src/app/window/measure/accuracy_view.h"
#include "src/content/image/image.h"
#include "src/document/coarseness.h"
#include "src/document/document.h"
#include "src/gl/present.h"
#include "src/platform/window.h"

namespace snell {

// The inputs of a picture of the scene. While they are the same, so is the picture.
struct Drawn {
    std::uint64_t revision = 0;
    Stand stand;
    Rungs rungs;
    std::uint64_t showing = 0;  // of a found rung, see Measuring; 0: of the scene
    Index object = none;        // the object with the outline
    int grain = 0;              // an index into `grains`

    bool operator==(const Drawn&) const = default;
};

// How a picture is wanted.
struct Wanted {
    bool held = false;   // a mouse button is down, so that changes are a drag, in which pictures may be coarse
    bool sharp = false;  // never coarse
    bool runs = false;   // values change by themselves
    bool again = false;  // even if nothing changed
};

struct WindowCounters {
    std::uint64_t frames = 0;    // number of pictures of the scene that were drawn; two side by side are one
    std::uint64_t coarse = 0;    // those of them that were not sharp
    std::uint64_t strips = 0;    // of sharp ones
    std::uint64_t presents = 0;  // number of times that the window's contents were replaced
    double time = 0;             // of the last picture, in seconds
    double frame_ms = 0;
    double interface_ms = 0, present_ms = 0;  // of the last presented one: panels made and drawn; contents replaced
    int grain = 0;                            // of the last picture, an index into `grains`
};

// One of the pictures that the window shows: the only one, or what is right of the divider.
struct Half {
    Drawn next;
    Document* document = nullptr;
};

class Display {
public:
    // `window` must outlive the object. `longest`: seconds after which a sharp picture is given up; 0: never.
    Display(Window& window, app::LossWatch loss, double longest)
        : window_(window), longest_(longest), loss_(std::move(loss)) {}

    // What is shown next: the only picture or the left one, and the right one. Both are as coarse, and drawn again if
    // one of them differs from its last picture. Returns false if neither does, or if the context refuses their size.
    // Otherwise draw() must follow.
    bool prepare(Half left, std::optional<Half> right, const Wanted& wanted);
    // When a sharp picture is due if nothing moves, or its next strip, by the clock of the window; infinite if the
    // picture is sharp, or moves by itself and is coarse because of that.
    double sharp_due() const;
    // How much is drawn of a sharp picture that is not shown yet.
    double sharp_share() const { return sharp_ ? sharp_->share() : 0; }
    // What a sharp picture may take in milliseconds, where that is so long that it is drawn in strips; 0: it is drawn
    // at once.
    double lasts() const;
    // What is shown next is drawn at once, and not looked ahead at.
    bool at_once() const { return !sharp_ && !ahead_; }
    // Seconds that what is shown next has taken so far, its coarse pictures and all strips together.
    double spent() const { return spent_ms_ / 1e3; }
    // That was too long: it stays coarse until another one is to be shown.
    bool given_up() const { return given_up_; }
    // It may take so long until something is shown that one wonders.
    bool slow() const { return !sharp_ && sides_[0].half.next.grain == 0 && sharp_ms_ > Coarseness::patience; }
    // Draws it, and returns true; of a sharp one that lasts, the next strip: it is shown once it is whole. `after` is
    // that of Frame, of the left picture, for what is drawn at once. `density` is pixels per window coordinate.
    bool draw(const std::function<void(const Step&)>* after, float density);
    // While the picture stays the same: see Runtime::specialise. Not for scenes that are cheap to draw.
    bool specialise(Document& document);
    // True if the driver reset the context during draw(); drawn() is still the picture before.
    bool lost() const { return lost_; }

    // Clears the window, whose size in pixels is given, and copies the last picture into it; with a divider, from that
    // column on what is beside it.
    void show(PixelSize pixels, std::optional<int> divider) const;
    // Replaces the contents of the window by what was drawn into it.
    void present(double interface_ms);

    // These are of the only picture, or of the left one.
    const Drawn& drawn() const { return sides_[0].drawn; }
    // As small as the file browser shows it; without pixels if nothing was drawn.
    content::Image thumbnail() const;
    // The y of the picture's bottom, in pixels from the bottom of the window.
    int bottom(PixelSize pixels) const { return pixels.height - drawn().stand.height; }
    // Of a sharp picture.
    int samples() const { return sides_[0].canvases.sharp.samples(); }
    const WindowCounters& counters() const { return counters_; }
    // When the last picture was begun, by the clock of the window.
    double last_picture() const { return last_picture_; }

private:
    struct Canvases {
        gl::Canvas sharp, coarse;
        gl::Canvas& of(const Drawn& drawn) { return drawn.grain > 0 ? coarse : sharp; }
        const gl::Canvas& of(const Drawn& drawn) const { return drawn.grain > 0 ? coarse : sharp; }
    };
    struct Side {
        Canvases canvases;  // the last picture is in one of them, see Drawn::grain
        Drawn drawn;
        Half half;                 // what is shown next
        std::uint64_t frames = 0;  // Counters::frames of its document after its last strip

        bool other() const;  // than the last picture, not only moved
        bool moved() const;
    };

    // Those that are shown next.
    std::span<Side> shown() { return {sides_.data(), two_ ? 2U : 1U}; }
    bool any(const std::function<bool(const Side&)>& holds) const;
    void set_grain(int grain);
    bool resize();
    // Draws what is shown next, only that part of it if one is given; parts come in order, and the last one ends the
    // picture. Adds its time to ms_.
    void draw_all(const std::function<void(const Step&)>* after, float density,
                  const std::optional<PixelRect>& part = {});
    // What a sharp picture may take by a coarse one, in milliseconds: more than the last one by far, and it is not its
    // pixels that take long, so that neither a coarse picture nor a strip is quicker.
    double most() const;
    // The same as coarse as it gets. Returns true if this is the picture, because a sharp one may take too long.
    bool draw_ahead(float density);
    // Draws the next strips. Returns true if that was the last one.
    bool draw_strips(float density);

    Window& window_;
    std::array<Side, 2> sides_;
    bool two_ = false;
    double ms_ = 0;                    // that what is shown next has taken so far, as coarse as it is
    double spent_ms_ = 0;              // with the coarser ones before
    double longest_;                   // see the constructor
    bool given_up_ = false;            // what is shown next took longer
    std::array<Drawn, 2> next_{};      // what is shown next, were it sharp
    std::optional<Strips> sharp_;      // of it
    std::array<Drawn, 2> sharp_of_{};  // what that was when they were begun
    Coarseness coarseness_;
    bool loops_ = false;     // what is shown next has loops that may last
    bool may_last_ = false;  // what is shown next, if it is sharp
    double sharp_ms_ = 0;    // of the last sharp picture
    bool held_ = false;      // a mouse button was down at the last picture
    bool runs_ = false;      // it is coarse because it moves by itself
    bool ahead_ = false;     // nobody knows how long the next one takes
    WindowCounters counters_;
    app::LossWatch loss_;
    bool lost_ = false;
    double last_picture_ = 0;
};

}  // namespace snell
