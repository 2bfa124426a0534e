// What outlives a picture: values that the user keeps, and the state with which a window continues after the driver
// reset its context, or restarts within its own process if a frame does not end or memory runs out.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/app/open/command_text.h"
#include "src/app/open/ending.h"
#include "src/app/open/states.h"
#include "src/document/document.h"
#include "src/plan/plan.h"
#include "src/plan/setup.h"
#include "src/plan/values/controls.h"
#include "src/plan/view.h"
#include "src/ui/panels/state.h"

namespace snell {

// Executes the requests to keep values: it saves them to the scene, stores and restores snapshots, and copies the
// command that draws the picture.
class Keeper {
public:
    explicit Keeper(std::string scene) : scene_(std::move(scene)) {}

    // Fills in what the panels show: whether values changed, and the snapshots.
    void tell(ui::Facts& facts, const Document* document, std::span<const Animated> moving);
    // Looks for the snapshots again, after their file may have changed.
    void look_again() { snapshots_ = snapshots_there(scene_); }
    // Results that Workspace and Past need.
    struct Served {
        std::string what;  // replaced these files, such as "snapshot 3"
        std::vector<SavedFile> files;
        std::string saved_as;  // path of the scene that was saved under another name
        std::string as;        // what is said of it when it is shown
        std::string copied;    // for the clipboard
    };
    // Executes the requests and sets `memory.notice`, or `memory.failures`, to their outcome.
    Served serve(const ui::Requests& requests, Document& document, const Picture& picture, ui::Memory& memory);

private:
    static void save(const Document& document, const View& view, ui::Memory& memory, Served& served);
    void store(int number, Setup values, ui::Memory& memory, Served& served);
    void remove(int number, ui::Memory& memory, Served& served);

    std::string scene_;
    std::array<bool, ui::snapshot_count + 1> snapshots_{};
    std::uint64_t looked_ = 0;  // the revision at which the snapshots were last looked for
};

// The state with which a window continues after the driver reset its context, or after it was restarted.

// The inputs of a document, which outlive a context.
struct Kept {
    Plan plan;
    Sources sources;
    Controls controls;  // with the values when it was last drawn
};

struct Recovery {
    std::shared_ptr<const Kept> kept;  // the last state that was drawn without problems; null if nothing is shown
    std::vector<std::string> files;    // files in use; a change of one makes the window try again
    std::string values;                // setup_text() of what differs from the scene, for when the scene is read
    Diagnostic problem;                // what happened, and what the user can do
    bool edited = false;               // a file was saved while no window watched it
};

// The initial state of a window that replaces another one.
struct Carried {
    std::string scene;
    Recovery recovery;
    View view;
    std::pair<int, int> size;  // of the window
    double time = 0;           // of the scene
    ui::Failures failures;     // that are not answered; only within the process
    std::string reading;       // the scene that was read since then; "": none
    int tries = 0;             // before the last one, since something was drawn
};

// The state after a loss of the context; its problem tells the user what happened.
Recovery after_loss(std::shared_ptr<const Kept> kept, std::vector<std::string> files);

// Converts to and from text, without `kept` and `failures`, which exist only within the process, and without the
// problem. "" reads as the initial state of a window without a scene.
std::string carried_text(const Carried& carried);
Carried read_carried(const std::string& text);

// Restarts a window within its own process if a frame does not end or memory runs out. The user's changes are passed on
// in an anonymous memory file, so nothing stays behind on disk.

// There may be only one at a time. While it exists, operator new calls it when memory runs out.
class Restart {
public:
    // `after` is the value of "--after" in a window that was restarted, otherwise "".
    explicit Restart(std::string after);
    ~Restart();
    Restart(const Restart&) = delete;
    Restart& operator=(const Restart&) = delete;

    // The state that a restarted window begins with.
    std::optional<Carried> carried() const;
    // Stores the state for the next window, if there will be one. `drawn`: something was, so that the window is worth a
    // restart where memory runs out.
    void keep(Carried carried, bool drawn = true);
    // Tells that a scene is about to be read, or read again. If memory runs out before this call and before a state is
    // kept, the program ends, because it would restart over and over. Files that are saved from now on count as another
    // edit.
    void trying(const std::string& scene);

    // Watches frames: if one takes longer than that many seconds, the window is restarted, which also ends threads that
    // do not return.
    app::Deadline hang_watch(double seconds) const;

private:
    enum class Cause { hang, memory };
    void store() const;
    // Neither function allocates memory. They return if this system cannot restart.
    void start(Cause cause) const;
    static void out_of_memory();

    std::string after_, program_;
    std::vector<std::string> arguments_;  // the last one is the value of "--after"
    std::vector<char*> after_hang_, after_memory_;
    int memory_ = -1;  // descriptor of the memory file
    Carried kept_;     // what it holds
    bool drawn_ = false;
    std::atomic<bool> worth_it_ = false;
    std::new_handler before_;
};

}  // namespace snell
