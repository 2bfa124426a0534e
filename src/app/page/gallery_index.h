// The first page of a gallery.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snell::app {

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

// The script that all pages of a gallery share, from the browser's part.
std::string gallery_runtime(std::string_view script);
// True for what gallery_runtime() returned.
bool is_gallery_runtime(std::string_view script);

}  // namespace snell::app
