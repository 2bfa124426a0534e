// The state with which a window continues after the driver reset its context, or after it was restarted.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/plan/plan.h"
#include "src/plan/values/controls.h"
#include "src/plan/view.h"

namespace snell {

// The inputs of a document, which outlive a context.
struct Kept {
    Plan plan;
    Sources sources;
    Controls controls;  // with the values when it was last drawn
};

struct Recovery {
    std::shared_ptr<const Kept> kept;  // the last state that was drawn without problems; null if nothing is shown
    std::vector<std::string> files;    // files in use; a change of one makes the window try again
    std::string values;   // the values that differ from the scene's, for restore_changed() once the scene is read
    Diagnostic problem;   // what happened, and what the user can do
    bool edited = false;  // a file was saved while no window watched it
};

// The initial state of a window that replaces another one.
struct Carried {
    std::string scene;
    Recovery recovery;
    View view;
    std::pair<int, int> size;  // of the window
    double time = 0;           // of the scene
};

// The state after a loss of the context; its problem tells the user what happened.
Recovery after_loss(std::shared_ptr<const Kept> kept, std::vector<std::string> files);

// Converts to and from text, without `kept`, which exists only within the process, and without the problem. "" reads as
// the initial state of a window without a scene.
std::string carried_text(const Carried& carried);
Carried read_carried(const std::string& text);

}  // namespace snell
