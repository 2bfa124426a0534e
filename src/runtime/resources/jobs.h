// Work for all cores, which one thread may watch.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "parser/text/diagnostic.h"
#include "src/runtime/resources/counters.h"

namespace snell::runtime {

struct Job {
    std::string name;
    std::function<void()> work;  // must not throw
};

// Adds what was said while a job read, but for what was said of the file's name when the scene was planned.
void say_once(const Diagnostics& said, Diagnostics& diagnostics);

// Does all of them, as many at a time as there are cores. `watcher`, if any, is called on this thread: at first, for
// each that is done, and in between every now and then, with the name of one that is not done yet.
void run(const std::vector<Job>& jobs, const Watcher& watcher);

}  // namespace snell::runtime
