// Many pictures on one.
#pragma once

#include <string>
#include <vector>

#include "src/content/image.h"

namespace snell::app {

// At most 160 pixels a side, by the mean of the pixels that fall on each; 3 channels of bytes. Smaller pictures stay
// as they are.
content::Image thumbnail(const content::Image& picture);

struct Tile {
    content::Image picture;  // as thumbnail() makes it; empty: was not drawn
    std::string label;
};
// The most tiles that one sheet takes.
constexpr std::size_t max_tiles = 4096;

// Rows of `columns`, each tile with its label below if wanted.
content::Image contact_sheet(const std::vector<Tile>& tiles, std::size_t columns, bool labels);

}  // namespace snell::app
