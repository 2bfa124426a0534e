// Lists a folder for the file browser.
#pragma once

#include <string>

#include "src/ui/panels/browser.h"

namespace snell {

// Lists folders, then scenes (with `all`, every regular file), each sorted by name without regard to case and with
// numbers by value. Hidden entries are left out. `folder` may begin with ~. If the folder cannot be read, the listing
// has an error and the absolute path.
ui::Listing list_folder(const std::string& folder, bool all);

bool is_folder(const std::string& path);

// The scene of a folder that has exactly one directly in it, as of `snell new`; otherwise the path itself.
std::string only_scene(const std::string& path);

// Replaces a leading "~" or "~/" by the home folder.
std::string without_tilde(const std::string& path);

// Replaces a leading home folder by "~".
std::string with_tilde(const std::string& path);
// Replaces the folder, wherever a path in the text begins with it, by nothing, and the home folder by "~". Neither ends
// with a slash.
std::string near_names(const std::string& text, const std::string& folder);

// The order in which names are sorted for the user: "room2" before "Room10".
bool before(std::string_view a, std::string_view b);

}  // namespace snell
