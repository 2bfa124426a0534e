// Pages of all scenes of a folder, and the page that lists them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/app/open/complain.h"
#include "src/plan/files.h"

namespace snell::app {

// A folder of pages for any static host, or for a disk: one for each scene, with an index and one runtime for all.

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

// Names of the pages of a gallery.

// A scene, and the file name and title of its page.
struct Exhibit {
    std::string scene, folder;  // `folder`: the one that was named
    std::string page, title;
};

// Names each page after its scene, and titles it so. Scenes that would have one name get the names of their folders,
// too, and a number if that is not enough; the names of all other scenes do not depend on them. Upper and lower case
// are the same name, because folders move to systems that do not tell them apart.
void name_pages(std::vector<Exhibit>& exhibits);

// The first page of a gallery.

struct GalleryRow {
    std::string title;
    std::string page;     // file name; empty if the scene has none
    std::string picture;  // a data: address; empty if there is none
    std::string error;    // why there is no page
};

// A row as text, to pass it from one process to another. A text that is no row gives an empty one.
std::string row_text(const GalleryRow& row);
GalleryRow read_row(const std::string& text);

// A page that needs no other file but those that it links to.
std::string gallery_index(const std::vector<GalleryRow>& rows);
// True for what gallery_index() returned: only that may be replaced by another one.
bool is_gallery_index(std::string_view page);

// The script that all pages of a gallery share, from the browser's part, with the list of the pages that there are:
// each links to its neighbours.
std::string gallery_runtime(std::string_view script, const std::vector<GalleryRow>& rows);
// True for what gallery_runtime() returned.
bool is_gallery_runtime(std::string_view script);

}  // namespace snell::app
