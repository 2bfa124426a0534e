#include "src/runtime/resources/tree.h"

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/glsl/glsl.h"

namespace snell::runtime {

std::optional<TreePart> tree_part(std::string_view sampler, std::string_view type) {
    const auto* found = ranges::find(glsl::mesh_samplers, sampler);
    if (type != "sampler2D" || found == glsl::mesh_samplers.end()) return std::nullopt;
    return static_cast<TreePart>(found - glsl::mesh_samplers.begin());
}

}  // namespace snell::runtime
