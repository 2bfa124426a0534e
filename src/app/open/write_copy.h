// Writes a scene: its saved values in place, or with its files into another folder, without replacing anything there.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "src/document/document.h"
#include "src/plan/files.h"

namespace snell::app {

// Writes a scene with its files into another folder, without replacing anything there.

struct WrittenCopy {
    std::string scene;               // the path of the scene in the folder
    std::vector<std::string> files;  // all paths; those that were there already, with these bytes, too
    std::string error;               // "", or why nothing was written
};

// Writes the scene and everything that it reads, whatever its rungs are, into `folder`, which is made if it is missing.
// `texts`: by path, as Files resolves it for the scene, what is written instead of the file. Files keep their places
// relative to each other (copy_names.h). It writes all files or none, and refuses to replace a file with other bytes,
// to follow links within the folder, and to write into the scene's own folder. The scene gets this `name`, or keeps its
// own.
WrittenCopy write_copy(const std::string& scene, const Access& access, const std::map<std::string, std::string>& texts,
                       const std::string& folder, const std::string& name = {});

// Where write_copy() writes the scene; "" if it can't.
std::string place_in_copy(const std::string& scene, const Access& access, const std::string& folder,
                          const std::string& name);

// The names that the files of a scene get in a copy, which is a page or another folder, by which the scene finds them
// there as it does on the disk.

struct NamedFile {
    std::string path;  // on the disk
    std::string name;  // in the copy: relative, with '/', without ".."
};

struct CopyNames {
    std::string scene;
    std::vector<NamedFile> files;  // in the order of the paths, each name once
    std::string error;             // "", or why the scene would not find its files in the copy
};

// Returns a name of the same scene, such that paths that Files resolves from relative names begin with its folder, and
// those from absolute names do not.
std::string marked_path(const std::string& scene);
// A path as messages have it, without the mark of marked_path().
std::string shown_path(const std::string& path);

// `scene` is a marked_path(), `paths` are those that were resolved for it, the scene's own among them. Files keep their
// places relative to each other. Files with absolute names, and those more than a few folders above the scene, whose
// names would tell of the author's machine, move to the scene's folder, where Files looks for their last component.
// `copy` is the word for it in errors, such as "a page".
CopyNames copy_names(const std::string& scene, const std::vector<std::string>& paths, std::string_view copy);

}  // namespace snell::app

namespace snell {

// Writes the saved values to the files of a scene.

// Writes all files or none; each must still have the text `before`. Returns "" or the error.
std::string write_saved(const std::vector<SavedFile>& files);
// Restores the previous texts if the files are still as saved. Returns "" or the error.
std::string revert_saved(const std::vector<SavedFile>& files);
// Writes them again if `forward`, and otherwise restores the previous texts; a file that was not there before goes.
std::string exchange_saved(const std::vector<SavedFile>& files, bool forward);

}  // namespace snell
