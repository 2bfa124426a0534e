// What resources are made of: equal identities are equal bytes, today and after the scene was read again.
#pragma once

#include <string>
#include <vector>

#include "src/plan/plan.h"

namespace snell {

struct Identity {
    std::string key;                 // empty: nothing is known of it, or a file of it is missing
    std::vector<std::string> files;  // the paths, each with its size and time in the key
};

// Of a texture from files, without its filter; and of one that is computed from such.
Identity texture_identity(const Scene& scene, Index texture, const Files& files);
Identity mesh_identity(const Plan& plan, Index mesh, const Files& files);
// The statement, and the file's name in it: what can be said of a mesh points there.
std::vector<Span> mesh_places(const Plan& plan, Index mesh);
Identity noise_identity(int dimensions, int size, const Files& files);

// Of two shapes of one scene: files and lists of vertices go by name and number.
std::string shape_key(const Scene& scene, const Shape& shape, bool wire);

}  // namespace snell
