// Work on many things, each in a process of its own, as many at a time as there are cores.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

#include "src/content/process.h"

namespace snell::app {

struct EndedProcess : content::Ended {
    bool again = false;  // it ended by a signal once before
};

struct Apart {
    std::size_t at_once = 1;
    content::ProcessLimits limits;
    bool (*stop)() = nullptr;  // ends all of them, without a call of `done`, once it is true
};

// Calls `work(k)` for 0 ≤ k < count in copies of this process, whose return value is the copy's exit status, and `done`
// here when it has ended. One that ends by a signal of its own is tried once more. There must be neither threads nor a
// context yet, because they are not copied.
void run_apart(std::size_t count, const Apart& how, const std::function<int(std::size_t)>& work,
               const std::function<void(std::size_t, const EndedProcess&)>& done);

// Why the process of a submission ended.

// What is said of it in the report; "" if it ended by itself, with its work done. `timeout`: seconds for a picture;
// `gigabytes` of memory that it could ask for, 0: no limit.
std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes);

}  // namespace snell::app
