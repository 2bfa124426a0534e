// Scene + files → what there is to draw: shader texts, meshes and textures named once each, and nothing read
// that was not asked for yet. No GL.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "parser/source.h"
#include "src/content/cubemap.h"
#include "src/content/image.h"
#include "src/content/mesh.h"
#include "src/glsl/glsl.h"
#include "src/plan/files.h"

namespace snell {

// A mesh that some draw needs; equal requests are one.
struct MeshRequest {
    Shape shape;
    bool wire = false;
    Span span;  // the first statement that asked
};

// A program whose shader files were found and read.
struct PlannedProgram {
    Index program = none;  // Scene::programs
    std::vector<glsl::StageInput> stages;
    bool readable = false;  // every file that it names was read
};

struct Plan {
    Scene scene;
    std::vector<PlannedProgram> programs;  // as Scene::programs
    std::vector<MeshRequest> meshes;
    std::vector<Index> draw_mesh;  // by Scene::draws → meshes
};

Plan make_plan(Scene scene, Files& files, Sources& sources, Diagnostics& diagnostics);

// Reads and builds on first need; diagnostics name the statement.
content::Mesh load_mesh(const Plan& plan, Index mesh, Files& files, Diagnostics& diagnostics);
// `image` of a texture with one file. A picture that can't be read is a checkerboard, with an error.
content::Image load_texture(const Scene& scene, Index texture, Files& files, Diagnostics& diagnostics);
content::CubeFaces load_cube(const Scene& scene, Index texture, Files& files, Diagnostics& diagnostics);
content::Image load_noise(int dimensions, int size, Files& files, Diagnostics& diagnostics);

std::string dump_plan(const Plan& plan, const Sources& sources);

// ---- matrices, in double ---------------------------------------------------------------------------------
glm::dmat4 projection_matrix(const Camera& camera, double aspect);  // clip from eye
glm::dmat4 view_matrix(const Camera& camera);                       // eye from world
// For normals: the inverse transpose of the upper 3x3, by scaled cofactors; finite for every scale from 1e-30
// to 1e30, sign of the determinant kept.
glm::dmat3 normal_matrix(const glm::dmat4& model_view);

}  // namespace snell
