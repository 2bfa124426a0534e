// What saving the current values would write to the files of a scene.
#pragma once

#include <string>
#include <vector>

#include "src/document/document.h"
#include "src/plan/values/write_back.h"

namespace snell {

// The new text of a file, and the text that it replaces.
struct SavedFile {
    std::string path, before, after;
};

struct Saved {
    std::vector<SavedFile> files;
    std::vector<Unwritten> unwritten;
    std::size_t values = 0;  // the number of values and rungs that are written
    std::string error;       // why nothing can be written; `files` is then empty
};

// The number of uniforms and ladders that differ from the scene.
std::size_t changed_values(const Document& document);

// Computes what saving the document's controls would write; writes nothing. The result has an error if a file changed
// since the document was read, or if the new texts would not read back correctly.
Saved saved_values(const Document& document);

// The scene with its current values, under another name.
struct SavedAs {
    SavedFile file;       // `before` is empty
    bool exists = false;  // a file of that name would be replaced
    std::string error;    // why the scene can't have that name
};
// Computes it; writes nothing. `name` is relative to the scene's folder; ".glib" is added where it lacks. Refuses
// folders from which the scene's files would not be found, and values that belong to another file, which the scene
// includes.
SavedAs saved_as(const Document& document, const std::string& name);

}  // namespace snell
