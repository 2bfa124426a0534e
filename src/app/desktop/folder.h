// Lists a folder for the file browser, and keeps small pictures of recent scenes in the user's cache folder.
#pragma once

#include <optional>
#include <string>

#include "src/content/image/image.h"
#include "src/ui/panels/browser.h"

namespace snell {

// Lists a folder for the file browser.

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

// Small pictures of recent scenes, which the file browser shows. They are kept in the user's cache folder.

// Returns $XDG_CACHE_HOME/snell/thumbnails, with ~/.cache as the default of the variable; "" if there is no home
// folder.
std::string thumbnails_folder();

// The file of the picture of a scene, whose path is absolute.
std::string thumbnail_file(const std::string& folder, const std::string& scene);

inline constexpr std::size_t most_thumbnails = 400;
// Writes the picture of a scene, and removes the oldest of more. Errors are ignored, because only comfort is lost.
void keep_thumbnail(const std::string& folder, const std::string& scene, const content::Image& picture);

// Returns the picture of a scene as RGBA bytes; nullopt if there is none, or if its file is damaged.
std::optional<content::Image> read_thumbnail(const std::string& folder, const std::string& scene);

}  // namespace snell
