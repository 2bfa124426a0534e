// Found rungs as rows of the accuracy panel.
#pragma once

#include <vector>

#include "parser/text/source.h"
#include "src/accuracy/found/search.h"
#include "src/ui/panels/found.h"

namespace snell {

// By group, with the rungs of the front first. `searching`: what was not tried yet has no row. What may not be left out
// has none either, because it changes pixels as it should.
std::vector<ui::FoundRow> found_rows(const accuracy::FoundResult& result, const Sources& sources, bool searching);

}  // namespace snell
