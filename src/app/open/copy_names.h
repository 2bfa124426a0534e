// The names that the files of a scene get in a copy, which is a page or another folder, by which the scene finds them
// there as it does on the disk.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

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

// `scene` is a marked_path(), `paths` are those that were resolved for it, the scene's own among them. Files keep their
// places relative to each other. Files with absolute names, and those more than a few folders above the scene, whose
// names would tell of the author's machine, move to the scene's folder, where Files looks for their last component.
// `copy` is the word for it in errors, such as "a page".
CopyNames copy_names(const std::string& scene, const std::vector<std::string>& paths, std::string_view copy);

}  // namespace snell::app
