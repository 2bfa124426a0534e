// Contact sheets: many small pictures on one.
#pragma once

#include <string>
#include <vector>

#include "src/content/image/image.h"

namespace snell::app {

// Shrinks a picture to at most 160 pixels per side, by averaging; returns 3 channels of bytes. Smaller pictures keep
// their size. `light`: the numbers are light, which is encoded as for a display.
content::Image thumbnail(const content::Image& picture, bool light = false);

struct Tile {
    content::Image picture;  // from thumbnail(); empty if the picture was not drawn
    std::string label;
};
// The maximum number of tiles on one sheet.
constexpr std::size_t max_tiles = 4096;

// Arranges the tiles in rows of `columns`, each with its label below if `labels` is true.
content::Image contact_sheet(const std::vector<Tile>& tiles, std::size_t columns, bool labels);

}  // namespace snell::app
