// Which vertices stand at the same place. Internal to content/.
#pragma once

#include <span>

#include "src/content/mesh.h"

namespace snell::content {

// For each position the number of its place: equal positions (0 and -0 are equal, NaN equals nothing) have
// equal numbers, counted from 0 in the order of first appearance.
struct Weld {
    std::vector<std::uint32_t> place;  // as long as the positions
    std::uint32_t places = 0;
};
Weld weld(std::span<const Float3> positions);

// Pairs of indices, kept where no earlier pair joins the same two places, in either direction; the order of
// first appearance stays.
void keep_each_edge_once(std::vector<std::uint32_t>& lines, const Weld& weld);

}  // namespace snell::content
