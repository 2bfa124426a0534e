// What a window goes on with when the driver took its context away, or does not return from a frame.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parser/source.h"
#include "src/app/deadline.h"
#include "src/plan/controls.h"
#include "src/plan/plan.h"
#include "src/plan/view.h"

namespace snell {

// What a document was made from: it outlives a context.
struct Kept {
    Plan plan;
    Sources sources;
    Controls controls;  // their values when it was last drawn
};

struct Recovery {
    std::shared_ptr<const Kept> kept;  // what was last drawn well; null: nothing is shown
    std::vector<std::string> files;    // a change of which is another try
    std::string problem;               // what happened, and what may be done
};

// What another window begins with.
struct Carried {
    std::string scene;
    Recovery recovery;
    View view;
    std::pair<int, int> size;
};

Recovery after_loss(std::shared_ptr<const Kept> kept, std::vector<std::string> files);

// For a window that was started in place of one that hung.
Recovery after_hang(const std::string& scene);

// Watches frames: one that takes longer than `seconds` is said on standard error, and the program is started again in
// this process's place, with "--after-hang". Threads that don't return end with it; what was set by hand is lost.
app::Deadline hang_watch(double seconds);

}  // namespace snell
