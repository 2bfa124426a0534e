// The current values into the files of a scene.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/app/document.h"
#include "src/plan/write_back.h"

namespace snell {

// A text that is to take the place of another.
struct SavedFile {
    std::string path, before, after;
};

struct Saved {
    std::vector<SavedFile> files;
    std::vector<Unwritten> unwritten;
    std::size_t values = 0;  // and rungs, that were written
    std::string error;       // why nothing can be written; then there are no files
};

// Of uniforms and ladders, those that are not as the scene says.
std::size_t changed_values(const Document& document);

// What saving the document's controls would write. Nothing is written yet. An error where a file is no longer what the
// document was read from, or where the new texts would not read as they must.
Saved saved_values(const Document& document);

// All files or none, each of which must still be as it was before. "" or why not.
std::string write_saved(const std::vector<SavedFile>& files);
// Back to what was before, where the files are still as they were saved.
std::string undo_saved(const std::vector<SavedFile>& files);

}  // namespace snell
