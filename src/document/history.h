// Undo and redo of what the user changes in a scene: values with their ranges, rungs, the view, and the files that a
// save or a snapshot replaced. Steps name what they change, so they survive reloads and edits of the text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "src/document/document.h"
#include "src/plan/setup.h"
#include "src/plan/values/animate.h"
#include "src/plan/view.h"

namespace snell {

// What the user changes. `follow_rungs` makes the controls of the rungs that were chosen; `exchange` gives the files of
// a step their texts of after it, if `forward`, or before it, and returns "" or the error. What moves is no part of it:
// the next frame sets it again.
struct UserState {
    const Scene& scene;
    Controls& controls;
    View& view;
    std::function<void()> follow_rungs;
    std::span<const Animated> moving = {};
    std::function<std::string(const std::vector<SavedFile>& files, bool forward)> exchange = {};
};

// The input that the state results from.
struct Gesture {
    bool busy = false;                      // a button is down, or a text is being typed: what follows is the same step
    std::uint64_t presses = 0;              // number of buttons and keys that were pressed so far
    double now = 0;                         // in seconds
    std::span<const Animated> moving = {};  // sliders that move by themselves: a step once they no longer do
    bool undone = false;                    // the step is undone at once: what can be redone stays
};

// Which values of last time are not those of the scene that was just opened, because its text has other numbers now, or
// programs that cannot be told apart any more; "" if there are none.
std::string lost_values(const Remembered& memory, const Scene& scene, const Controls& controls);

class History {
public:
    static constexpr std::size_t most_steps = 1000, most_bytes = std::size_t{16} << 20;

    // Steps are counted from this state.
    void begin(const Scene& scene, const Controls& controls, const View& view);
    // Call it after the scene was read again: what its text changed is not a step, unless the user had changed it, too;
    // the result then says so. What moves keeps the value from before its motion, whatever the text says: a save may
    // have written where it was. Unless values follow the text, what differs from the last call was changed by the
    // user. Values of programs that cannot be told apart any more are dropped, which the result says, too; undo sets
    // them by the programs' numbers.
    std::string reread(const Scene& scene, const Controls& controls, const View& view,
                       std::span<const Animated> moving = {}, Follow follow = Follow::text);
    // Makes a step of what was changed since the last call, or extends the last step if it changed the same in the same
    // gesture, such as turns of the wheel or repeats of a key. Returns true if there was a change.
    bool follow(const Scene& scene, const Controls& controls, const View& view, const Gesture& gesture);
    // Forgets what the last press changed, as if it had not been: what it made impossible to redo can be redone again.
    // Call it in the frame of the press that takes it back, `presses`; the state is what it was before.
    void take_back(std::uint64_t presses);
    // Makes a step of files that were replaced. `what` is what undo and redo say, such as "snapshot 3".
    void add(std::string what, std::vector<SavedFile> files);

    // Go one step back, or forward again, and return what was changed, such as "undo: Glass.uEta 1.5 → 1.1". What the
    // scene no longer has is skipped, and so is what an edit of the text already changed to that. A step whose files
    // cannot be exchanged stays the next one, and the error is returned, such as "not undone: a.glib is gone"; when the
    // same is asked at once and fails in the same way, it is left out.
    std::string undo(const UserState& state) { return go(state, false); }
    std::string redo(const UserState& state) { return go(state, true); }

    bool empty() const { return steps_.empty(); }
    std::size_t size() const { return steps_.size(); }
    // The number of steps that can be undone.
    std::size_t done() const { return done_; }
    std::size_t bytes() const { return bytes_; }

private:
    struct Change {
        std::string before, after;
        const std::string& at(bool forward) const { return forward ? after : before; }
    };
    struct Step {
        std::map<std::string, Change> changes;  // by the keys of a Setup
        std::string what;                       // what replaced the files
        std::vector<SavedFile> files;
        std::uint64_t presses = 0;
        double time = 0;
        bool by_number = false;  // of values that were dropped: it holds for this text only
        bool left = false;       // the files are as on the other side of it: the way back leaves it out, too

        bool empty() const { return changes.empty() && files.empty(); }
        std::size_t bytes() const;
        bool extends(const Step& last) const;
        // Returns false if both together change nothing.
        bool merge(Step&& later);
    };

    // What the steps of the last press replaced.
    struct Before {
        std::uint64_t presses = 0;  // with that press; 0: nothing
        std::deque<Step> undone;    // the steps that could be redone
        Setup setup;
        Controls controls;
        std::vector<std::string> names;
        View view;
    };

    // Sets what moves to the value from before its motion.
    void rest(const Scene& scene, Controls& controls, std::span<const Animated> moving) const;
    // The index into controls_; `names` are those of the other controls, or empty if they are the same uniforms.
    std::size_t old_index(std::size_t index, const std::vector<std::string>& names) const;
    bool take(const Scene& scene, const Controls& controls, const View& view, const Gesture& gesture);
    Step difference(const Scene& scene, const Controls& controls, const View& view) const;
    void push(Step step, bool undone = false);
    void note_before(std::uint64_t presses);
    void forget_redo();
    bool too_many() const { return steps_.size() > most_steps || (bytes_ > most_bytes && steps_.size() > 1); }
    void follow_text(const std::string& name, const Control& old, const Control& control);
    void name_objects(const Scene& scene, const View& view);
    std::string go(const UserState& state, bool forward);
    void pass(std::size_t to, const std::vector<Step*>& left);
    static std::string apply(const Step& step, const UserState& state, bool forward);
    // What of the step is not as it was before.
    static std::string words_of(const Step& step, const Setup& before, const UserState& state);
    // The view, with objects by their new indices, which steps have then, too.
    View carried_view(const Scene& scene);
    // Gives programs the names that they have now. Returns the values of those that cannot be told apart, by their old
    // names.
    std::map<std::string, const Control*> carry_programs(const Scene& scene);
    // Gives objects their new indices; what was changed of those that are gone is removed.
    static void carry_changes(const std::vector<std::string>& from, const std::vector<std::string>& to, Step& step);

    std::deque<Step> steps_;
    std::size_t done_ = 0;   // how many of them are not undone
    std::size_t bytes_ = 0;  // of all steps, about
    bool open_ = false;      // whether the last step may be extended
    bool held_ = false;      // whether the gesture was busy
    std::string refused_;    // what the last undo or redo returned if files could not be exchanged
    // The state after the steps that are done, as text and as the values that each frame is compared with.
    Setup setup_;
    Controls controls_, at_rest_;  // at_rest_ only keeps its memory from frame to frame
    std::vector<std::string> names_;
    Setup programs_;  // those of the scene, and those of steps that it does not have any more
    View view_;
    Before before_;
    std::vector<std::string> objects_;  // names of the scene's objects; empty until one was moved
};

// The histories of the scenes that were shown last.
class Histories {
public:
    static constexpr std::size_t most = 12;

    // The history of a scene, which is then the last one used. The one that was not used for the longest time may go.
    History& use(const std::string& scene);

private:
    std::list<std::pair<std::string, History>> used_;  // the last one is first
};

}  // namespace snell
