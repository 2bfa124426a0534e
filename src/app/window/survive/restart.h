// Restarts a window within its own process if a frame does not end or memory runs out. The user's changes are passed on
// in an anonymous memory file, so nothing stays behind on disk.
#pragma once

#include <atomic>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "src/app/open/ending.h"
#include "src/app/window/survive/keeper.h"

namespace snell {

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
    // Stores the state for the next window, if there will be one. `worth_it`: also where memory runs out.
    void keep(const Carried& carried, bool worth_it = true);
    // Tells that the scene is about to be read again. If memory runs out before this call and before a state is kept,
    // the program ends, because it would restart over and over. Files that are saved from now on count as another edit.
    void trying();

    // Watches frames: if one takes longer than that many seconds, the window is restarted, which also ends threads that
    // do not return.
    app::Deadline hang_watch(double seconds) const;

private:
    enum class Cause { hang, memory };
    // Neither function allocates memory. They return if this system cannot restart.
    void start(Cause cause) const;
    static void out_of_memory();

    std::string after_, program_;
    std::vector<std::string> arguments_;  // the last one is the value of "--after"
    std::vector<char*> after_hang_, after_memory_;
    int memory_ = -1;  // descriptor of the memory file
    std::atomic<bool> worth_it_ = false;
    std::new_handler before_;
};

}  // namespace snell
