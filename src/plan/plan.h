// Scene + files → what there is to draw: shader texts, meshes and textures named once each, and nothing read
// that was not asked for yet. No GL.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
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
#include "src/plan/rungs.h"

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
    // Empty with `readable`: the statement names no shader, and its draws use the built-in program.
    std::vector<glsl::StageInput> stages;
    bool readable = false;  // every file that it names was read
};

struct Plan {
    Scene scene;
    std::vector<PlannedProgram> programs;  // as Scene::programs
    std::vector<MeshRequest> meshes;
    std::vector<Index> draw_mesh;  // by Scene::draws → meshes
    // By Scene::textures: the first texture with the same target and files, whose pixels are these; itself for
    // the first, and for empty textures.
    std::vector<Index> same_pixels;
    Rungs rungs;  // to compile the programs for; at first as the scene's text marks them
};

// Reads the shaders of every program, each file once. Of meshes and textures only the existence of their files
// is checked. Reports file-not-found (errors), file-inexact and program-without-shaders (warnings).
Plan make_plan(Scene scene, Files& files, Sources& sources, Diagnostics& diagnostics);

// ---- loading, on first need; diagnostics name the statement ----------------------------------------------

// Decoded pictures by path, for those who load several textures of the same files. Thread-safe.
class ImageCache {
public:
    struct Entry {
        std::once_flag once;
        content::ImageResult result;
        std::string unreadable;  // why the file can't be read
    };
    std::shared_ptr<Entry> entry(const std::string& path);
    void clear();
    // Of what is in the cache now.
    struct Stats {
        std::size_t images = 0, bytes = 0;
    };
    Stats stats() const;

private:
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<Entry>> entries_;
};

// Empty when the file can't be read.
content::Mesh load_mesh(const Plan& plan, Index mesh, Files& files, Diagnostics& diagnostics);
// `image` of a texture with one file. A picture that can't be read is a checkerboard, with an error (but
// file-not-found is not repeated when `diagnostics` has it already).
content::Image load_texture(const Scene& scene, Index texture, Files& files, Diagnostics& diagnostics,
                            ImageCache* cache = nullptr);
// Six square faces of equal size and format, decoded on all cores. What can't be used is a checkerboard.
content::CubeFaces load_cube(const Scene& scene, Index texture, Files& files, Diagnostics& diagnostics,
                             ImageCache* cache = nullptr);
// The noise file of that resolution beside the scene, else generated. dimensions: 2 or 3.
content::Image load_noise(int dimensions, int size, Files& files, Diagnostics& diagnostics);

// ---- what a draw reads and writes ------------------------------------------------------------------------

// The texture of `unit` and `target` at a draw. Where nothing stood there when the statement was read, the last
// one that the whole text binds there: a display list that is drawn again and again finds that one. `none`:
// the text binds nothing there.
Index find_texture(const Scene& scene, const Draw& draw, int unit, TextureTarget target);

// What a sampler of that GLSL type reads. Nothing for kinds that scenes have no textures for.
std::optional<TextureTarget> sampler_target(std::string_view type);

// An error (feedback-loop) when `draw`, in `pass`, samples `texture` while that pass renders to it.
std::optional<Diagnostic> feedback_error(const Scene& scene, Index pass, Index draw, Index texture);

std::string dump_plan(const Plan& plan, const Sources& sources);

// ---- matrices, in double ---------------------------------------------------------------------------------

// Distances of the clipping planes in front of the eye.
struct DepthRange {
    double near = .1, far = 1000;
};

// A mesh's bounds, and where the eye sees them (the eye looks to -Z).
struct DepthBox {
    glm::dmat4 eye_from_model{1};
    std::array<float, 3> min{}, max{};
};
// Between the usual planes, as near to the boxes as they allow: 24 bits of depth with near .1 resolve .006 at a
// distance of 100, with near 90 they resolve 7e-6. Nothing that the usual planes show is cut off. nullopt: nothing
// lies between them, or a box is not finite.
std::optional<DepthRange> fit_depth(std::span<const DepthBox> boxes);

// Clip from eye. `aspect` is width / height; what a square window shows stays visible, and more at the longer
// sides. Values outside their domain fall back to their defaults, never to NaN. `depth` by default: .1 to 1000
// for perspective, -1000 to 1000 for orthographic (scenes draw at z = 0 with the eye at the origin).
glm::dmat4 projection_matrix(const Camera& camera, double aspect, std::optional<DepthRange> depth = std::nullopt);

// Eye from world: rigid to 1e-12 however near `up` is to the viewing direction. Eye = centre looks to -Z;
// without a usable `up` it is the world's Y, or for a camera that looks straight up or down what tilting it
// there gives.
glm::dmat4 view_matrix(const Camera& camera);

// For normals: the inverse transpose of the upper 3x3, by scaled cofactors; finite for every scale from 1e-30
// to 1e30, sign of the determinant kept. Scales so extreme that normalising a normal in float would overflow
// change its length, not its direction. A matrix that flattens space keeps the plane's normal; one that leaves
// less than a plane gives the identity.
glm::dmat3 normal_matrix(const glm::dmat4& model_view);

}  // namespace snell
