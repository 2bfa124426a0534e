// Input and panels: Dear ImGui's frames, what the user changes there, the clock of the scene, and objects that are
// picked.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/app/open/progress.h"
#include "src/app/window/measure/accuracy_view.h"
#include "src/document/document.h"
#include "src/platform/window.h"
#include "src/ui/kit/gui.h"
#include "src/ui/panels/state.h"

namespace snell {

class Interface {
public:
    // With `listening` the places of the widgets are recorded in layout(). `window` must outlive the object.
    Interface(Window& window, bool listening);

    // What the user changed: the view of the scene, and the state of the panels.
    View& view() { return view_; }
    ui::Memory& memory() { return memory_; }
    const ui::Layout& layout() const { return layout_; }
    // Begins with the view and the memory of a scene that was just opened; the appearance of the window stays, and what
    // could not be done in the scene before waits until that is opened again. `same`: it is the scene of
    // before, saved under another name, whose time continues.
    void begin_scene(const std::string& scene, bool same);

    // Starts the clocks, when the window is shown.
    void start();
    // Passes the events to the panels, which change `controls`, the view and the memory. Draws nothing yet.
    ui::Requests frame(std::span<const Event> events, const ui::Facts& facts, Controls& controls);
    // Shows a progress bar instead of the panels.
    void loading(const LoadProgress& progress);
    // Draws the panels of the last frame over the contents of the window.
    void paint() { painter_.paint(); }
    // When the panels would be another picture even without input, by the clock of the window; infinite if never.
    double due() const { return framed_ + gui_.due(); }
    // True while the panels change by themselves.
    bool fading() const { return memory_.hint > 0; }
    // A hash of the last frame: equal hashes mean equal panels.
    std::uint64_t picture() const { return picture_; }

    // True while a mouse button is down.
    bool pressed() const { return gui_.pressed(); }
    // True while a mouse button is down or a widget is in use.
    bool busy() const { return gui_.busy(); }
    // Pixels per window coordinate.
    float density() const;
    // True while measuring, or the dialog that saves pictures, holds the scene's time.
    bool held() const { return memory_.picture.open || (memory_.accuracy_in_sight() && memory_.accuracy.hold_time); }
    // Advances the scene's time by the time since the last call, unless it is paused or `stopped`. Returns it, in
    // seconds.
    double time(bool stopped);

private:
    void begin(double seconds, std::span<const Event> events);

    Window& window_;
    ui::Gui gui_;
    ui::Painter painter_;
    ui::Layout layout_;
    ui::Memory memory_;
    View view_;
    std::uint64_t picture_ = 0;
    double framed_ = 0, ticked_ = 0;  // when frame() and time() were called last
    bool stood_ = false;              // the scene's time did not pass then
};

// Picks and moves objects. It does nothing until the first object is picked.
class Picking {
public:
    // Call it before the panels use the view. After the scene was read again, it updates the indices of the objects and
    // drops those that are gone.
    void follow(Document& shown, std::uint64_t revision, View& view, HoldMemory& hold);
    // Picks the object at the click, in the picture that `stand` describes; `density` is pixels per window coordinate.
    void serve(const ui::Requests& requests, Document& shown, const Stand& stand, float density, HoldMemory& hold);
    // Fills in the text about the picked object.
    void tell(ui::Facts& facts, const Document* shown, const HoldMemory& hold);

private:
    std::uint64_t revision_ = 0;
    // Names of the objects, in the order of Scene::draws; empty if none was picked yet.
    std::vector<std::string> names_;
    std::string told_;
    std::pair<std::uint64_t, Index> told_of_{0, none};  // the revision and the object that told_ describes
};

}  // namespace snell
