// Snapshots: numbered sets of values, stored next to the scene.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "src/document/document.h"
#include "src/plan/setup.h"
#include "src/ui/panels/state.h"

namespace snell {

inline constexpr int most_snapshots = ui::snapshot_count;

// Returns "room.snapshots.json" for "room.glib".
std::string snapshots_file(const std::string& scene);

// For each number from 1 to 9, whether the snapshot exists. All false if the file cannot be read.
std::array<bool, most_snapshots + 1> snapshots_there(const std::string& scene);

// What a snapshot stores: all values and rungs of the document.
Setup snapshot_of(const Document& document);

// Stores them, or those of `values`; the other contents of the file stay. Returns "" or the error.
std::string store_snapshot(int number, const Document& document);
std::string store_snapshot(int number, const std::string& scene, const Setup& values);

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
