// Runs all stages of a program on numbers, to see which uniforms change what it draws.
#pragma once

#include <set>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl::run {

struct Tried {
    std::string_view name;
    bool wanted = true;  // false: it is looked at where others are, but is not worth a try of its own
};

// Those of the uniforms of which a change changes an output. No optimiser may remove them then.
std::set<std::string_view> that_matter(const std::vector<Unit>& units, const std::vector<Tried>& uniforms);

}  // namespace snell::glsl::run
