// What a window goes on with when the driver took its context away, or when it had to be started again.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parser/source.h"
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
    std::string values;                // what is not as the scene says: restore_changed() once it is read
    std::string problem;               // what happened, and what may be done
    bool edited = false;               // a file was saved while nothing could look
};

// What another window begins with.
struct Carried {
    std::string scene;
    Recovery recovery;
    View view;
    std::pair<int, int> size;  // of the window
    double time = 0;           // of the scene
};

Recovery after_loss(std::shared_ptr<const Kept> kept, std::vector<std::string> files);

// As text, without what only lives with the process: what is kept, and the problem. "" reads as what a window begins
// with, of no scene.
std::string carried_text(const Carried& carried);
Carried read_carried(const std::string& text);

}  // namespace snell
