// Sets of values by number, kept beside the scene.
#pragma once

#include <array>
#include <string>

#include "src/app/document.h"
#include "src/ui/state.h"

namespace snell {

inline constexpr int most_snapshots = ui::snapshot_count;

// "room.snapshots.json" for "room.glib".
std::string snapshots_file(const std::string& scene);

// By number, 1 to 9: whether there is one. All false where the file can't be read.
std::array<bool, most_snapshots + 1> snapshots_there(const std::string& scene);

// Keeps all values and rungs of the document. "" or why not; what the file holds besides stays.
std::string store_snapshot(int number, const Document& document);

struct Restored {
    std::string error;     // then nothing was changed
    std::size_t lost = 0;  // values for which the scene has no place now
};
// What the scene does not have, or holds in another type, is left out; what the snapshot does not have stays.
Restored restore_snapshot(int number, Document& document);

// The values and rungs that are not as the scene says, as text; "" where all are.
std::string changed_text(const Document& document);
Restored restore_changed(const std::string& changed, Document& document);
// The rungs alone, before the programs are compiled for them.
void restore_rungs(const std::string& changed, const Scene& scene, Rungs& rungs);

}  // namespace snell
