// Writes the saved values to the files of a scene.
#pragma once

#include <string>
#include <vector>

#include "src/document/save_values.h"

namespace snell {

// Writes all files or none; each must still have the text `before`. Returns "" or the error.
std::string write_saved(const std::vector<SavedFile>& files);
// Restores the previous texts if the files are still as saved. Returns "" or the error.
std::string revert_saved(const std::vector<SavedFile>& files);

}  // namespace snell
