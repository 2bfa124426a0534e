// The numbers that changes of the kind expression-mean lack until they are drawn. Needs a current context.
#pragma once

#include <span>
#include <vector>

#include "src/accuracy/found/search.h"

namespace snell::accuracy {

// Draws the expressions of these changes as colours, at the places of the scene that are searched on, and writes their
// means into the changes: those over all pixels in which the expression is computed and shows. View, time and values
// are the scene's own, and the size is fixed, so that whoever applies a change gets the number that was measured.
// Changes that need no number stay as they are, and so do those whose expression shows nowhere, or if `stop` says so:
// choose_changes refuses them.
void fill_averages(const Original& original, std::span<Change*> changes, const gl::Caps& caps, const Stop& stop = {});
void fill_averages(const Original& original, std::vector<Change>& changes, const gl::Caps& caps, const Stop& stop = {});

}  // namespace snell::accuracy
