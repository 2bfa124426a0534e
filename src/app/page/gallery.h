// A folder of pages for any static host, or for a disk: one for each scene, with an index and one runtime for all.
#pragma once

#include <string>
#include <vector>

#include "src/app/open/exit_status.h"
#include "src/plan/files.h"

namespace snell::app {

struct GalleryOptions {
    std::vector<std::string> folders;  // whose scenes are shown, with those of all folders below
    std::string output;                // a folder, which is made if it does not exist
    std::string link;                  // from every page
    Access access;
    bool grade = false;
    double timeout = 20;  // in seconds, for each scene
};

inline constexpr std::size_t most_gallery_scenes = 1000;

// A scene that has errors, or that browsers cannot draw, is in the index with its first error, and has no page; that of
// an earlier run is removed. Other files in the folder stay: a gallery that would replace one is not made.
Exit make_gallery(const GalleryOptions& options);

}  // namespace snell::app
