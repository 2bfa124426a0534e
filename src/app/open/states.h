// States of a scene by name, so that any two can be compared: in the window side by side, and by `snell compare`. Among
// them are snapshots, numbered sets of values, stored next to the scene.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "src/document/document.h"
#include "src/plan/setup.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/rungs.h"
#include "src/ui/panels/state.h"

namespace snell {

// What a state has in place of what the scene has otherwise, as arguments of --set and --ladder.
struct NamedState {
    bool written = false;  // otherwise: as the scene's text says; else as it is now
    std::vector<std::string> sets, ladders;
    std::string error;  // why there is no such state; empty if there is
};

inline constexpr std::string_view state_now = "now", state_saved = "saved", state_reference = "reference",
                                  state_snapshot = "snapshot ";

// The name is one of these, such as "snapshot 3", or has settings between blanks, such as
// "Glass.uIndex=1.33 BEND=single" or "Glass.uIndex=1.33, BEND=single", each of a uniform or a ladder. `path` is that of
// the scene.
NamedState named_state(std::string_view name, const std::string& path, const Scene& scene);

// Sets what the state has; what does not fit is left out, and returned as a message, or "".
std::string apply_state(const NamedState& state, const Scene& scene, Rungs& rungs);
std::string apply_state(const NamedState& state, const Scene& scene, Controls& controls);

// The texts of a scene as they were, by the paths of their files, and its values and rungs then.
struct TextState {
    std::map<std::string, std::string> texts;
    Setup setup;
};
// As the scene was when it was opened, and before the last edit that is shown; without texts if it was not edited.
struct Earlier {
    TextState opened, before_edit;
};

// What differs between two states of a scene, on either side: "uIndex 1.33" and "2.4". Both are empty if nothing does.
struct StateDifference {
    std::string left, right;
};
StateDifference difference(const Setup& left, const Setup& right);

// Snapshots: numbered sets of values, stored next to the scene.

inline constexpr int most_snapshots = ui::snapshot_count;

// Returns "room.snapshots.json" for "room.glib", and for links to it.
std::string snapshots_file(const std::string& scene);

// For each number from 1 to 9, whether the snapshot exists. All false if the file cannot be read.
std::array<bool, most_snapshots + 1> snapshots_there(const std::string& scene);

// What a snapshot stores: all values and rungs of the document.
Setup snapshot_of(const Document& document);

// Stores them, or those of `values`; the other contents of the file stay. Returns "" or the error.
std::string store_snapshot(int number, const Document& document);
std::string store_snapshot(int number, const std::string& scene, const Setup& values);

// The other contents of the file stay. Returns "" or the error.
std::string delete_snapshot(int number, const std::string& scene);

// Of a number that no snapshot of the scene has: that there is none, and which there are.
std::string no_snapshot(std::string_view number, const std::string& scene);

// The values and rungs of a snapshot. Sets `error` if there is none.
Setup read_snapshot(int number, const std::string& scene, std::string& error);

struct Restored {
    std::string error;     // if not empty, nothing was changed
    std::size_t lost = 0;  // number of values that the scene no longer has
};
// Restores a snapshot. Values that the scene does not have, or cannot hold, are left out; values that the snapshot does
// not have stay.
Restored restore_snapshot(int number, Document& document);

}  // namespace snell
