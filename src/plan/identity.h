// Identities of resources: resources with equal identities have equal bytes, also after the scene was read again.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "src/plan/plan.h"

namespace snell {

struct Identity {
    std::string key;                 // empty if nothing is known about the resource, or one of its files is missing
    std::vector<std::string> files;  // paths of the files; the key holds their sizes and times
};

// The identity of a texture from files, without its filter, or of a texture that is computed from one.
Identity texture_identity(const Scene& scene, Index texture, const Files& files);
// The size of the texture's files; 0 for one that is missing.
std::uint64_t file_bytes(const Scene& scene, Index texture, const Files& files);
// The identity of a mesh, by its shape or its file.
Identity mesh_identity(const Plan& plan, Index mesh, const Files& files);
// The file that a shape is read from, as an index into Scene::files; none if it is made.
Index file_of(const Shape& shape);
// The places in the text that messages about a mesh point to: its statement, and the file name in it.
std::vector<Span> mesh_places(const Plan& plan, Index mesh);
Identity noise_identity(int dimensions, int size, const Files& files);

// A key by which shapes of one scene are compared. It names files and lists of vertices by name and number, so it means
// nothing outside of that scene.
std::string shape_key(const Scene& scene, const Shape& shape, bool wire);

}  // namespace snell
