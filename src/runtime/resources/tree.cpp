#include "src/runtime/resources/tree.h"

namespace snell::runtime {

std::optional<TreePart> tree_part(std::string_view sampler, std::string_view type) {
    if (type != "samplerBuffer") return std::nullopt;
    if (sampler == "snellMeshNodes") return TreePart::nodes;
    if (sampler == "snellMeshTriangles") return TreePart::triangles;
    if (sampler == "snellMeshNormals") return TreePart::normals;
    return std::nullopt;
}

}  // namespace snell::runtime
