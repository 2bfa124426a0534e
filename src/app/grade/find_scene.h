// Finds the scene of a submission, which may be deep in folders, or in archives.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

// Which scene is meant.
struct WantedScene {
    std::string pattern;    // of the file name, with * and ?, without regard to case; "": *.glib
    std::string preferred;  // a file name
    std::string named;      // the scene's own path in the folder, or the end of it; "": not known
    // Tells which of the rubric's uniforms a scene has; may be null.
    std::function<std::set<std::string>(const std::string& folder, const std::string& path)> uniforms = nullptr;
};

struct FoundScene {
    std::string folder;  // one of those that were searched
    std::string scene;   // path relative to it; "" if there is an error
    std::string error;
    std::string reason;                 // why it is this one, if that is not plain
    std::vector<std::string> several;   // paths of scenes, if it is not clear which one is meant
    std::vector<std::string> archives;  // paths of archives in the folders
};

// If no scene is named: of several, those without any of the rubric's uniforms are left out if others have some. Then
// those with the preferred name count, then those in the fewest folders, then the one with the most of the uniforms.
// Links, hidden files and those of the system are left out.
FoundScene find_scene(const std::vector<std::string>& folders, const WantedScene& wanted);

// Whether a name is that of a hidden file, or of one that systems and programs write by themselves.
bool is_hidden(std::string_view name);

// Whether a name fits a pattern with * and ?. The case of letters counts only if it does by `exact`.
bool fits_pattern(std::string_view name, std::string_view pattern, bool exact = false);

}  // namespace snell::app
