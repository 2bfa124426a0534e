// A window that can't go on, because a frame does not end or memory ran out, and starts itself again in its own
// process's place. What was set by hand goes with it: in memory that has a name in no folder, so nothing stays behind.
#pragma once

#include <atomic>
#include <new>
#include <optional>
#include <string>
#include <vector>

#include "src/app/deadline.h"
#include "src/app/recovery.h"

namespace snell {

// One at a time: while it is there, operator new calls it when there is no more memory.
class Restart {
public:
    // `after`: what "--after" says in a window that was started again, else "".
    explicit Restart(std::string after);
    ~Restart();
    Restart(const Restart&) = delete;
    Restart& operator=(const Restart&) = delete;

    // What a window that was started again begins with.
    std::optional<Carried> carried() const;
    // What the next one begins with, if there is one.
    void keep(const Carried& carried);
    // The scene is about to be read again. Memory that runs out before that, and before anything is kept, ends the
    // program: it would again and again. What is saved from now on is another edit.
    void trying();

    // Watches frames: after that many seconds the window is started again. Threads that don't return end with it.
    app::Deadline hang_watch(double seconds) const;

private:
    enum class Cause { hang, memory };
    // Both allocate nothing, and return where this system can't.
    void start(Cause cause) const;
    static void out_of_memory();

    std::string after_, program_;
    std::vector<std::string> arguments_;  // the last one is what "--after" says
    std::vector<char*> after_hang_, after_memory_;
    int memory_ = -1;  // a file of it
    std::atomic<bool> worth_it_ = false;
    std::new_handler before_;
};

}  // namespace snell
