// Runs all stages of a program on numbers, to see which uniforms change what it draws.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl::run {

// Those of the uniforms `names` of which a change changes an output. No optimiser may remove them then.
std::set<std::string_view> that_matter(const std::vector<Unit>& units, const std::vector<std::string_view>& names);

}  // namespace snell::glsl::run
