// Small pictures of recent scenes, which the file browser shows. They are kept in the user's cache folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "src/content/image/image.h"

namespace snell {

// Returns $XDG_CACHE_HOME/snell/thumbnails, with ~/.cache as the default of the variable; "" if there is no home
// folder.
std::string thumbnails_folder();

// The file of the picture of a scene, whose path is absolute.
std::string thumbnail_file(const std::string& folder, const std::string& scene);

// Writes the picture of a scene, and removes those of scenes that are not recent. Errors are ignored, because only
// comfort is lost.
void keep_thumbnail(const std::string& folder, const std::string& scene, const content::Image& picture,
                    const std::vector<std::string>& recent);

// Returns the picture of a scene as RGBA bytes; nullopt if there is none, or if its file is damaged.
std::optional<content::Image> read_thumbnail(const std::string& folder, const std::string& scene);

}  // namespace snell
