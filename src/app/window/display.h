// The picture of the scene in the window. It is drawn only if it would differ from the last one, and kept, so that what
// lies over it can change without drawing it again.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
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
    std::uint64_t frames = 0;    // number of pictures of the scene that were drawn
    std::uint64_t coarse = 0;    // those of them that were not sharp
    std::uint64_t strips = 0;    // of sharp ones
    std::uint64_t presents = 0;  // number of times that the window's contents were replaced
    double time = 0;             // of the last picture, in seconds
    double frame_ms = 0;
    double interface_ms = 0, present_ms = 0;  // of the last presented one: panels made and drawn; contents replaced
    int grain = 0;                            // of the last picture, an index into `grains`
};

class Display {
public:
    // `window` must outlive the object.
    Display(Window& window, app::LossWatch loss) : window_(window), loss_(std::move(loss)) {}

    // Returns false if that would be the last picture again, or if the context refuses its size. Otherwise draw() must
    // follow.
    bool prepare(Drawn next, Document& document, const Wanted& wanted);
    // When a sharp picture is due if nothing moves, or its next strip, by the clock of the window; infinite if the
    // picture is sharp, or moves by itself and is coarse because of that.
    double sharp_due() const;
    // How much is drawn of a sharp picture that is not shown yet.
    double sharp_share() const;
    // Draws the picture, and returns true; if it is a sharp one that lasts, its next strip: it is shown once it is
    // whole. `after` is that of Frame; `density` is pixels per window coordinate.
    bool draw(Document& document, const std::function<void(const Step&)>* after, float density);
    // Draws what is right of the divider, which is as coarse, if it differs from its last picture. `next` is its
    // picture in the values of the other document. Returns true if it was drawn.
    bool draw_beside(Drawn next, Document& document, float density);
    // While the picture stays the same: see Runtime::specialise. Not for scenes that are cheap to draw.
    bool specialise(Document& document);
    // True if the driver reset the context during draw(); drawn() is still the picture before.
    bool lost() const { return lost_; }

    // Clears the window, whose size in pixels is given, and copies the last picture into it; with a divider, from that
    // column on what is beside it.
    void show(PixelSize pixels, std::optional<int> divider) const;
    // Replaces the contents of the window by what was drawn into it.
    void present(double interface_ms);

    const Drawn& drawn() const { return drawn_; }
    // The last picture, as small as the file browser shows it; without pixels if nothing was drawn.
    content::Image thumbnail() const;
    // The y of the picture's bottom, in pixels from the bottom of the window.
    int bottom(PixelSize pixels) const { return pixels.height - drawn_.stand.height; }
    // Of a sharp picture.
    int samples() const { return canvases_.sharp.samples(); }
    const WindowCounters& counters() const { return counters_; }
    // When the last picture was begun, by the clock of the window.
    double last_picture() const { return last_picture_; }

private:
    Window& window_;
    bool moved(const Drawn& next) const;
    // Draws next_ as coarse as it gets. Returns true if this is the picture, because a sharp one may take too long.
    bool draw_ahead(Document& document, float density);
    // The last picture is in one of them, see Drawn::grain.
    struct Canvases {
        gl::Canvas sharp, coarse;
        gl::Canvas& of(const Drawn& drawn) { return drawn.grain > 0 ? coarse : sharp; }
        const gl::Canvas& of(const Drawn& drawn) const { return drawn.grain > 0 ? coarse : sharp; }
    };
    // A sharp picture that is drawn strip by strip, from the bottom.
    struct Strips {
        Drawn of;
        int rows = 0, next = 0;  // that are drawn; of the next strip
        double ms = 0;
    };
    // `part`: only that; parts come in order, and the top ends the picture.
    void draw_into(gl::Canvas& canvas, const Drawn& drawn, Document& document,
                   const std::function<void(const Step&)>* after, float density,
                   const std::optional<PixelRect>& part = {});
    int first_strip() const;  // its rows
    // Draws the next strip of next_. Returns true if it was the last one.
    bool draw_strip(Document& document, float density);

    Canvases canvases_, beside_;
    Drawn drawn_beside_;
    Coarseness coarseness_;
    bool held_ = false;   // a mouse button was down at the last picture
    bool runs_ = false;   // it is coarse because it moves by itself
    bool ahead_ = false;  // nobody knows how long next_ takes
    Drawn drawn_, next_;
    std::optional<Strips> strips_;
    WindowCounters counters_;
    app::LossWatch loss_;
    bool lost_ = false;
    double last_picture_ = 0;
};

}  // namespace snell
