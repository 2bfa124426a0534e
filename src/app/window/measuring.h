// What the window measures of its picture, where a panel asks for it: errors and costs while nothing else happens,
// values of pixels, and why the scene costs what it does.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "src/app/window/display.h"
#include "src/app/window/measure/accuracy_view.h"
#include "src/app/window/measure/found_view.h"
#include "src/app/window/measure/frame_costs.h"
#include "src/app/window/measure/inspector_view.h"
#include "src/app/window/measure/states_view.h"
#include "src/app/window/nan_watch.h"
#include "src/app/window/session.h"
#include "src/ui/panels/state.h"

namespace snell {

class Measuring {
public:
    // The GL context of `caps` must be current during the object's whole life.
    Measuring(const std::string& scene, const gl::Caps& caps);
    // Forgets what was measured of the scene before.
    void begin_scene(const std::string& scene);
    // Call it when the scene was read again: its document may be another one.
    void leave(ui::AccuracyMemory& memory);

    // Call it before a picture is drawn: two states may be shown side by side.
    void prepare(Document& scene, const Session& session, const ui::AccuracyMemory& memory) {
        states_.follow(scene, session.earlier(), session.revision(), session.stale(), memory);
    }
    // The document whose picture the window shows in place of the scene's: that of a found rung, the left one of two
    // states, or the scene's own.
    Document& shown(Document& scene) { return found_.rung() ? found_.shown(scene) : states_.left(scene); }
    // What is right of the divider; null if there is none.
    Document* beside(Document& scene) {
        return !states_.active() ? nullptr : found_.rung() ? &scene : &states_.right(scene);
    }
    // Another number for each found rung and each pair of states that is shown; 0: the scene is shown.
    std::uint64_t showing() const { return 65536 * found_.showing() + states_.showing(); }
    // The divider's column in a picture of that width, where two states are shown side by side.
    std::optional<int> divider(int width, const ui::AccuracyMemory& memory) const;

    // True if the picture must be drawn although it is unchanged.
    bool wants_picture(const Display& display) const { return frame_costs_.wants_picture() && display.lasts() == 0; }
    // Call these before and after a picture, or a strip of it, is drawn. begin_picture() returns the function for
    // Frame::after.
    const std::function<void(const Step&)>* begin_picture(std::uint64_t revision, const Display& display) {
        return frame_costs_.begin(revision, display.at_once());
    }
    void end_picture(const Display& display) {
        frame_costs_.end(display.counters().frame_ms, display.counters().grain == 0);
    }

    // Call it after each frame, whether the picture was drawn or is unchanged. `still`: nothing moves, by hand or by
    // itself. Returns true if the panels must be shown again.
    bool follow(Document& document, const Session& session, const Display& display, bool still,
                const ui::Memory& memory, double now);
    // True if look_for_nan() has something to do.
    bool watches(const Document& scene, const Display& display, const ui::Memory& memory, double now) const;
    // Call follow() after it, which tells what was found.
    void look_for_nan(Document& scene, const Display& display);
    // True if step() has something to do.
    bool busy() const { return accuracy_.busy() || frame_costs_.busy() || linking_ || found_.busy(); }
    // How much is drawn of a picture with marks of pixels, where that takes long.
    std::optional<double> flagged() const { return pixels_.facts() ? pixels_.facts()->drawn : std::nullopt; }
    // True if the next call of follow() draws a part of something.
    bool draws() const { return pixels_.busy(); }
    // Draws one picture to measure it, or some, with `alive` called between them. Returns true if there is something
    // new to show.
    bool step(Document* document, const std::function<void()>& alive);
    // Starts and stops what the panels ask for. Returns a command to be copied, or "".
    std::string serve(const ui::Requests& requests, Document* document, ui::Memory& memory);

    // Fills in the results, without the explanation.
    void tell(ui::Facts& facts, Document* document, const Session& session, const ui::Memory& memory);
    // Fills in the explanation of the costs, if its panel is open.
    void explain(ui::Facts& facts, const Document& document, const ui::Memory& memory);
    // The explanation that is shown is of programs for other values.
    bool outdated(const Document& document) const;
    // Changes whenever show() would draw something else because of the accuracy panel.
    std::uint64_t revision(const ui::Memory& memory) const { return accuracy_.revision(memory.accuracy); }
    // Draws what is measured over the picture, whose bottom left is at pixel (0, y).
    void show(int y, const ui::Memory& memory);

private:
    std::string found_text() const;
    // Call it whenever a found rung may be shown now, or not any more.
    void follow_rung(ui::AccuracyMemory& memory);
    // What one half of the window shows; null: there is no picture of that state.
    Document* half(Document& scene, bool right);
    bool heat(const ui::Memory& memory) const {
        return states_.active() && memory.accuracy.show == ui::AccuracyMemory::Show::heat;
    }
    // Whether there are pictures of what the heat map is of.
    bool comparable() const { return found_.rung() || (states_.shows(false) && states_.shows(true)); }
    // The window's picture, or a smaller one of the same where it takes too long.
    const Stand& measured(const Display& display);

    gl::Caps caps_;
    AccuracyView accuracy_;
    FoundView found_;
    StatesView states_;
    FrameCosts frame_costs_;
    PixelView pixels_;
    TextureView textures_;
    NanWatch watch_;
    Explanation explanation_;
    std::pair<std::uint64_t, int> explained_;  // the revision and Runtime::form() that explanation_ belongs to
    bool linking_ = false;                     // programs that tell what values switch off
    Stand measured_;                           // see measured()
    int samples_ = 1;                          // of the window's picture
    bool of_rung_ = false;                     // a found rung is shown
    bool alone_ = false;                       // the scene was shown alone before that
};

}  // namespace snell
