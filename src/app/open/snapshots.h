// Snapshots: numbered sets of values, stored next to the scene.
#pragma once

#include <array>
#include <string>

#include "src/document/document.h"
#include "src/ui/panels/state.h"

namespace snell {

inline constexpr int most_snapshots = ui::snapshot_count;

// Returns "room.snapshots.json" for "room.glib".
std::string snapshots_file(const std::string& scene);

// For each number from 1 to 9, whether the snapshot exists. All false if the file cannot be read.
std::array<bool, most_snapshots + 1> snapshots_there(const std::string& scene);

// Stores all values and rungs of the document; the other contents of the file stay. Returns "" or the error.
std::string store_snapshot(int number, const Document& document);

struct Restored {
    std::string error;     // if not empty, nothing was changed
    std::size_t lost = 0;  // number of values that the scene no longer has
};
// Restores a snapshot. Values that the scene does not have, or has in another type, are left out; values that the
// snapshot does not have stay.
Restored restore_snapshot(int number, Document& document);

// Formats the values and rungs that differ from the scene as text; "" if none does.
std::string changed_text(const Document& document);
// Restores the values of such a text, as restore_snapshot() does.
Restored restore_changed(const std::string& changed, Document& document);
// Restores only the rungs, before the programs are compiled for them.
void restore_rungs(const std::string& changed, const Scene& scene, Rungs& rungs);

}  // namespace snell
