#include "src/plan/identity.h"

#include <sys/stat.h>

#include "src/content/image/noise.h"
#include "src/plan/locate.h"

namespace snell {
namespace {

// Appends the bytes of values, which must have no padding, to a key.
template <class... Values>
void put(std::string& key, Values... values) {
    (key.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
}

// Adds the file's current size and time. Returns false if it does not exist.
bool put_file(Identity& identity, const std::string& path) {
    struct stat status {};
    if (path.empty() || stat(path.c_str(), &status) != 0) return false;
    identity.key += path;
    identity.key += '\0';
    put(identity.key, status.st_size, status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
    identity.files.push_back(path);
    return true;
}

void put_list(std::string& key, const VertexListData& list) {
    put(key, list.topology, list.patch_vertices, list.has_color);
    for (const ListVertex& vertex : list.vertices)
        put(key, vertex.position, vertex.normal, vertex.texcoord, vertex.color);
}

}  // namespace

Index file_of(const Shape& shape) {
    if (const auto* obj = std::get_if<ObjFile>(&shape)) return obj->file;
    if (const auto* shp = std::get_if<ShpFile>(&shape)) return shp->file;
    return none;
}

std::string shape_key(const Scene& scene, const Shape& shape, bool wire) {
    std::string key;
    put(key, static_cast<std::uint8_t>(shape.index()), wire);
    const auto describe = [&]<class Kind>(const Kind& kind) {
        key += kind.command();
        for_each_field(kind, [&](auto value, bool) {
            if constexpr (std::is_same_v<Kind, ObjFile> || std::is_same_v<Kind, ShpFile>)
                key += value < scene.files.size() ? scene.files[value].name : "";
            else
                put(key, value);
        });
    };
    std::visit(describe, shape);
    return key;
}

Identity mesh_identity(const Plan& plan, Index mesh, const Files& files) {
    if (mesh >= plan.meshes.size()) return {};
    const MeshRequest& request = plan.meshes[mesh];
    const Scene& scene = plan.scene;
    Identity identity{"mesh " + shape_key(scene, request.shape, request.wire), {}};
    if (const auto* list = std::get_if<VertexList>(&request.shape); list && list->list < scene.vertex_lists.size())
        put_list(identity.key, scene.vertex_lists[list->list]);
    const Index file = file_of(request.shape);
    Diagnostics unheard;  // discarded: these are reported when the mesh is loaded
    if (file < scene.files.size() &&
        !put_file(identity, locate(scene.files[file], mesh_extensions(request.shape), files, unheard)))
        return {};
    return identity;
}

std::vector<Span> mesh_places(const Plan& plan, Index mesh) {
    std::vector<Span> places{plan.meshes[mesh].span};
    const Index file = file_of(plan.meshes[mesh].shape);
    if (file < plan.scene.files.size()) places.push_back(plan.scene.files[file].span);
    return places;
}

Identity texture_identity(const Scene& scene, Index index, const Files& files) {
    if (index >= scene.textures.size()) return {};
    const Texture& texture = scene.textures[index];
    Identity identity;
    if (texture.computed != Computed::no) {
        identity = texture_identity(scene, texture.source, files);
        if (identity.key.empty()) return {};
        put(identity.key, 'c', texture.computed, texture.size);
        return identity;
    }
    if (texture.files.empty()) return {};
    put(identity.key, 't', texture.target, texture.bits, texture.encoding == Encoding::srgb);
    Diagnostics unheard;
    for (const TextureFile& file : locate_texture(texture, files, unheard))
        if (file.noise > 0)
            put(identity.key, 'n', file.noise);
        else if (!put_file(identity, file.path))
            return {};
    return identity;
}

std::uint64_t file_bytes(const Scene& scene, Index texture, const Files& files) {
    Diagnostics unheard;
    std::uint64_t bytes = 0;
    for (const TextureFile& file : locate_texture(scene.textures[texture], files, unheard)) {
        struct stat status {};
        if (!file.path.empty() && stat(file.path.c_str(), &status) == 0)
            bytes += static_cast<std::uint64_t>(status.st_size);
    }
    return bytes;
}

Identity noise_identity(int dimensions, int size, const Files& files) {
    Identity identity;
    put(identity.key, 'n', dimensions, size);
    put_file(identity, files.find(content::noise_file_name(dimensions, size)).path);
    return identity;
}

}  // namespace snell
