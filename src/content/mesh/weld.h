// Finds vertices at the same place. Internal to src/content.
#pragma once

#include <span>

#include "src/content/mesh/mesh.h"

namespace snell::content {

// For each position, the number of its place. Equal positions have equal numbers, which count from 0 in the order of
// first appearance. 0 and -0 are equal; NaN equals nothing.
struct Weld {
    std::vector<std::uint32_t> place;  // as long as the positions
    std::uint32_t places = 0;
};
Weld weld(std::span<const Float3> positions);

// Removes pairs of indices that join the same two places as an earlier pair, in either direction; the order of the
// others stays.
void keep_each_edge_once(std::vector<std::uint32_t>& lines, const Weld& weld);

}  // namespace snell::content
