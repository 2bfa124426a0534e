// Undo and redo of each scene of this window, and the state that is kept of scenes.
#pragma once

#include <bitset>
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>

#include "src/app/desktop/settings.h"
#include "src/app/window/session.h"
#include "src/document/history.h"
#include "src/platform/window.h"
#include "src/ui/panels/state.h"

namespace snell {

class Past {
public:
    // Without a folder nothing is kept.
    explicit Past(std::string folder) : folder_(std::move(folder)) {}

    // Reads what is kept of a scene, with which a session can begin.
    Remembered read(const std::string& scene);
    // Begins with a scene that was just opened: its view and axes are as they were last. Returns what the user should
    // know, or "".
    std::string begin(Session& session, View& view);
    // The same for a window that continues another one, as it was.
    void continue_with(Session& session, const View& view);

    // Call it before every frame of the panels.
    void hear(std::span<const Event> events);
    // Call it after every frame of the panels: makes steps of what was changed. `busy`: a gesture has not ended.
    // `moving`: sliders that move by themselves, each of which becomes a step when its motion ends; `undone`: to be
    // undone at once.
    void follow(Session& session, const View& view, bool busy, std::span<const Animated> moving, double now,
                bool undone = false);
    // Call it before follow() in a frame of the panels that set the state from before the last press, with as many
    // motions as there were then: the press leaves no step.
    void take_back(std::size_t moving);
    // Ends gestures and motions, before the scene is left: what they changed becomes a step.
    void finish(Session& session, const View& view);
    // True if undo is to end the motion, because nothing else was changed since it began.
    bool undoes_motion() { return moving_ > 0 && steps() <= before_motion_; }
    // Call it when the scene was read again. Returns what begin() does if the scene could not be read until now, and
    // otherwise which of the user's values the text replaced. `moving` is that of follow().
    std::string reread(Session& session, View& view, std::span<const Animated> moving = {});
    // Makes a step of files that were just replaced. Values stay, whatever is changed until the files are read.
    void add(std::string what, std::vector<SavedFile> files, Session& session);
    // Executes requests for undo and redo, and returns what they changed. `follow_rungs` makes the controls of the
    // rungs that were chosen; `moving` is that of follow().
    std::string serve(const ui::Requests& requests, Session& session, View& view, std::span<const Animated> moving,
                      const std::function<void()>& follow_rungs);

    // The number of steps that can be undone.
    std::size_t steps() { return name_.empty() ? 0 : history().done(); }

    // Which sections of the scene's programs the user has opened or folded: as they were last, and as they are now, in
    // the open scene, before it is read again.
    const ui::Folds& folds() const { return folds_; }
    void fold(const ui::Folds& folds, Session& session);
    // Writes what is kept of the scene, if it changed.
    void write(Session& session, const View& view);
    // Makes the scene that the document was saved as begin with this view, and with the values that are not in the
    // file.
    void hand_on(Session& session, const std::string& scene, const View& view);

private:
    History& history() { return histories_.use(name_); }
    void carry_folds(const Scene& scene);
    // What is to be kept of the open scene.
    Remembered state(Session& session, const View& view, bool axes) const;

    std::string folder_;
    std::string name_;  // of the open scene; empty until it could be read
    Remembered kept_;   // as read, then as written last
    ui::Folds folds_;
    Setup fold_programs_;  // what tells their programs apart
    Histories histories_;
    bool flat_ = false, axes_ = true, first_axes_ = true;  // axes_: as in the last scene that was not flat
    bool continued_ = false;                               // the scene, once it can be read, begins as the view is
    bool changed_ = false;                                 // since it was written
    std::size_t moving_ = 0, before_motion_ = 0;           // motions; steps when the last of them began
    std::uint64_t presses_ = 0;                            // number of buttons and keys that were pressed
    std::bitset<static_cast<std::size_t>(Key::count_)> down_;
};

}  // namespace snell
