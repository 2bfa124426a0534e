// Finds the scene of a submission, which may be deep in folders, or in archives.
#pragma once

#include <string>
#include <vector>

namespace snell::app {

struct FoundScene {
    std::string scene;  // path relative to the folder; "" if there is an error
    std::string error;
    bool several = false;               // it is not clear which one is meant
    std::vector<std::string> archives;  // paths of archives in the folder, if it has no scene
};

// `pattern` is a file name with * and ?, without regard to case; "" stands for *.glib. Of several scenes, those with
// the name `preferred` count, then those in the fewest folders; then there must be one. Links, hidden files and those
// of macOS are left out.
FoundScene find_scene(const std::string& folder, const std::string& pattern, const std::string& preferred);

// Whether a file name fits a pattern with * and ?, without regard to case.
bool fits_pattern(std::string_view name, std::string_view pattern);

}  // namespace snell::app
