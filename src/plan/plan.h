// A plan is a scene with its files: shader texts that were read, and its meshes and textures with duplicates merged.
// Their files are read when they are first needed. No GL.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/content/cube/cubemap.h"
#include "src/content/image/image.h"
#include "src/content/mesh/mesh.h"
#include "src/glsl/glsl.h"
#include "src/plan/files.h"
#include "src/plan/values/rungs.h"

namespace snell {

// A mesh that at least one draw needs. Equal requests are merged.
struct MeshRequest {
    Shape shape;
    bool wire = false;
    Span span;  // the first statement that needs it
};

// A program with the texts of its shaders.
struct PlannedProgram {
    Index program = none;  // index into Scene::programs
    // If empty although `readable`: the statement names no shader, and its draws use the built-in program.
    std::vector<glsl::StageInput> stages;
    bool readable = false;  // every file that the statement names was read
};

struct Plan {
    Scene scene;
    std::vector<PlannedProgram> programs;  // in the order of Scene::programs
    std::vector<MeshRequest> meshes;
    std::vector<Index> draw_mesh;  // index into `meshes` for each of Scene::draws
    // For each of Scene::textures, the first texture with the same target and files, whose pixels it shares: its own
    // index for that first one and for empty textures.
    std::vector<Index> same_pixels;
    Rungs rungs;  // the rungs to compile the programs for; initially those that the scene's text marks
};

// Reads the shaders of every program, each file once. For meshes and textures it checks only that the files exist.
// Reports file-not-found (errors), file-inexact and program-without-shaders (warnings).
Plan make_plan(Scene scene, Files& files, Sources& sources, Diagnostics& diagnostics);

// ---- loading, on first need; diagnostics name the statement ----------------------------------------------

// Decoded images by path, shared by textures that use the same files. Thread-safe.
class ImageCache {
public:
    struct Entry {
        std::once_flag once;
        content::ImageResult result;
        std::string unreadable;  // why the file cannot be read; empty if it can
    };
    // Returns the entry of a file, a new one if there is none yet.
    std::shared_ptr<Entry> entry(const std::string& path);
    void clear();
    // The current contents of the cache.
    struct Stats {
        std::size_t images = 0, bytes = 0;
    };
    Stats stats() const;

private:
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<Entry>> entries_;
};

// Returns an empty mesh and reports an error if its file cannot be read.
content::Mesh load_mesh(const Plan& plan, Index mesh, Files& files, Diagnostics& diagnostics);
// These return images that are ready to upload: with four channels, and with the row first that OpenGL takes first,
// which is the bottom row except for the faces of cube maps.
//
// Returns the image of a texture with one file. If it cannot be read, returns a checkerboard and reports an error
// (file-not-found is not repeated if `diagnostics` already holds it).
content::Image load_texture(const Scene& scene, Index texture, Files& files, Diagnostics& diagnostics,
                            ImageCache* cache = nullptr);
// Returns six square faces of equal size and format, decoded on all cores. A face that cannot be used is a
// checkerboard, with an error.
content::CubeFaces load_cube(const Scene& scene, Index texture, Files& files, Diagnostics& diagnostics,
                             ImageCache* cache = nullptr);
// Returns the noise of that resolution from the file next to the scene, otherwise generated. `dimensions` is 2 or 3.
content::Image load_noise(int dimensions, int size, Files& files, Diagnostics& diagnostics, Span span = {});

// ---- what a draw reads and writes ------------------------------------------------------------------------

// Returns the texture bound to `unit` and `target` at a draw. If nothing was bound there yet, returns the last texture
// that the scene binds there: a display list is drawn repeatedly, so it finds the binding of the frame before. Returns
// `none` if the scene never binds one.
Index find_texture(const Scene& scene, const Draw& draw, int unit, TextureTarget target);

// The kind of the scene's textures that a sampler of that GLSL type reads; nullopt if scenes have none of it, or the
// sampler reads the mesh that is drawn.
std::optional<TextureTarget> sampler_target(std::string_view name, std::string_view type);

// Returns an error (feedback-loop) if `draw`, in `pass`, samples `texture` while that pass renders to it.
std::optional<Diagnostic> feedback_error(const Scene& scene, Index pass, Index draw, Index texture);

// Lists the plan as text, for `snell check --dump plan`.
std::string dump_plan(const Plan& plan, const Sources& sources);

// ---- matrices, in double ---------------------------------------------------------------------------------

// Distances of the clipping planes from the eye, in its viewing direction.
struct DepthRange {
    double near = .1, far = 1000;
    bool operator==(const DepthRange&) const = default;
};

// A mesh's bounding box in model space, and its transformation to eye space (the eye looks along -Z).
struct DepthBox {
    glm::dmat4 eye_from_model{1};
    std::array<float, 3> min{}, max{};

    std::array<glm::dvec3, 8> corners() const;  // in eye space
};
// Fits the clipping planes to the boxes, within the default range. A tight range saves precision: with 24 bits of
// depth, near = .1 resolves .006 at a distance of 100, near = 90 resolves 7e-6. Nothing that the default planes show is
// cut off. Returns nullopt if no box lies between them, or a box is not finite.
std::optional<DepthRange> fit_depth(std::span<const DepthBox> boxes);

// Returns true if nothing in the box can be within the frustum of `clip_from_eye`, even if it extends by `margin` times
// half of its width and height on each side, and the matrices and positions are rounded to floats. Returns false if a
// number is not finite.
bool out_of_view(const DepthBox& box, const glm::dmat4& clip_from_eye, const glm::dvec2& margin);

// Clip from eye. `aspect` is width / height; the content of a square window stays visible, and the longer sides show
// more. Values outside of their domain fall back to their defaults, never to NaN. Default of `depth`: .1 to 1000 for
// perspective, -1000 to 1000 for orthographic cameras, because scenes draw at z = 0 with the eye at the origin.
glm::dmat4 projection_matrix(const Camera& camera, double aspect, std::optional<DepthRange> depth = std::nullopt);

// Eye from world; rigid to 1e-12 however near `up` is to the viewing direction. If eye and centre coincide, the camera
// looks along -Z. If `up` is unusable, the world's Y is used; a camera that looks straight up or down gets the up
// vector that tilting a level camera there would give.
glm::dmat4 view_matrix(const Camera& camera);

// Transforms normals: the inverse transpose of the upper 3x3, by scaled cofactors. It is finite for every scale from
// 1e-30 to 1e30 and keeps the sign of the determinant. For scales so extreme that normalising a normal would overflow a
// float, its length is changed, but not its direction. A matrix that flattens space to a plane gives the plane's
// normal; one that leaves less gives the identity.
glm::dmat3 normal_matrix(const glm::dmat4& model_view);

// ---- settings that trade accuracy for speed and apply to any scene; the command line and tests write the same ones --
// Values that differ need different meshes or textures.
struct PlanKnobs {
    double tessellation = 1;       // factor for the slices, stacks, sides and rings of shapes
    std::optional<Filter> filter;  // for all textures from files; nullopt: as the scene says
    int cube_size = 0;             // texels per side of a cube map, at most those of its files; 0: as the scene says
    int cube_bits = 0;             // bits per channel of cube maps, 8 or 16; 0: as files and scene say
    bool operator==(const PlanKnobs&) const = default;
};

struct Knobs {
    int grid = 1;         // each pixel is the mean of grid x grid pictures, shifted by fractions of a pixel
    int multisample = 1;  // samples per pixel, taken by the driver
    PlanKnobs plan = {};
    bool operator==(const Knobs&) const = default;
};

// Applies the knobs to the plan's shapes and textures. Slice counts stay between 3 and 2000.
Plan with_knobs(Plan plan, const PlanKnobs& knobs);

// Whether the scene has anything that the respective knobs change.
bool has_round_shapes(const Scene& scene);
bool has_textures(const Scene& scene);
bool has_cube_maps(const Scene& scene);

// Identities of resources: resources with equal identities have equal bytes, also after the scene was read again.

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
