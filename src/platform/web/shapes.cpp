// Parsers of meshes in a page.
#include "src/content/mesh/mesh.h"

#define TINYOBJLOADER_IMPLEMENTATION
#include <tiny_obj_loader.h>

namespace snell::content {

MeshResult parse_shp(std::string_view, const MeshLimits&) {
    MeshResult result;
    result.issues.push_back({true, "shp-in-a-page", "a page in a browser reads no shape files (.shp)",
                             "convert the file to .obj, or draw the scene with snell itself"});
    return result;
}

}  // namespace snell::content
