// What the file browser shows of a folder.
#pragma once

#include <string>

#include "src/ui/browser.h"

namespace snell {

// Folders first, then scenes (`all`: every regular file), each by name without regard to case, numbers by value; hidden
// ones left out. `folder` may begin with ~. An error where it can't be read; the path is absolute all the same.
ui::Listing list_folder(const std::string& folder, bool all);

// "~" and "~/…" as the home folder's.
std::string without_tilde(const std::string& path);

// Whether a name comes before another where people look for it: "room2" before "Room10".
bool before(std::string_view a, std::string_view b);

}  // namespace snell
