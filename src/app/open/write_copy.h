// Writes a scene with its files into another folder, without replacing anything there.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "src/plan/files.h"

namespace snell::app {

struct WrittenCopy {
    std::string scene;               // the path of the scene in the folder
    std::vector<std::string> files;  // all paths; those that were there already, with these bytes, too
    std::string error;               // "", or why nothing was written
};

// Why no copy can be written into the folder; empty: it can. Leaves nothing behind.
std::string check_folder(const std::string& folder);

// Writes the scene and everything that it reads, whatever its rungs are, into `folder`, which is made if it is missing.
// `texts`: by path, as Files resolves it for the scene, what is written instead of the file. Files keep their places
// relative to each other (copy_names.h). It writes all files or none, and refuses to replace a file with other bytes,
// to follow links within the folder, and to write into the scene's own folder.
WrittenCopy write_copy(const std::string& scene, const Access& access, const std::map<std::string, std::string>& texts,
                       const std::string& folder);

}  // namespace snell::app
