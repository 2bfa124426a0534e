// A parsed .glib text: a display list, in which every draw has the state at its statement. Plain values that need only
// the C++ standard library. Equal states are stored once and referred to by index, so that a scene of a million
// statements stays small.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "parser/text/source.h"

namespace snell {

using Index = std::uint32_t;
inline constexpr Index none = std::numeric_limits<Index>::max();

using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;
using Mat4 = std::array<double, 16>;  // column-major, as in OpenGL

struct FileName {
    std::string name;  // as written, with '/' for '\'
    Span span;
    std::string from = {};  // the included scene that contains the name; empty: the scene that was opened
};

// ---- geometry ---------------------------------------------------------------------------------------

enum class Topology : std::uint8_t {
    points,
    lines,
    line_strip,
    line_loop,
    triangles,
    triangle_strip,
    triangle_fan,
    lines_adjacency,
    line_strip_adjacency,
    triangles_adjacency,
    triangle_strip_adjacency,
    patches,
};

// Each shape names its command and lists its fields once, in the order of its statement. All that is generic about
// shapes comes from these two: text, dumps, identity, and the knob that makes round shapes finer. `solid`: from
// outside, only its outside is seen.

// A number of straight parts that together approximate something round.
template <class Shape>
struct RoundParts {
    int Shape::*count;
};
template <class Shape>
RoundParts(int Shape::*) -> RoundParts<Shape>;

struct Sphere {
    double radius = 1;
    int slices = 60, stacks = 60;
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Sphere"; }
    static constexpr auto fields() {
        return std::tuple{&Sphere::radius, RoundParts{&Sphere::slices}, RoundParts{&Sphere::stacks}};
    }
};
struct Torus {
    double outer = 1, inner = .5;  // as written: the larger one is the ring's
    int sides = 20, rings = 40;
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Torus"; }
    static constexpr auto fields() {
        return std::tuple{&Torus::outer, &Torus::inner, RoundParts{&Torus::sides}, RoundParts{&Torus::rings}};
    }
};
struct Cone {
    double radius = 1, height = 1;
    int slices = 60, stacks = 1;
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Cone"; }
    static constexpr auto fields() {
        return std::tuple{&Cone::radius, &Cone::height, RoundParts{&Cone::slices}, &Cone::stacks};
    }
};
struct Cylinder {
    double radius = 1, height = 1;
    int slices = 60, stacks = 1;
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Cylinder"; }
    static constexpr auto fields() {
        return std::tuple{&Cylinder::radius, &Cylinder::height, RoundParts{&Cylinder::slices}, &Cylinder::stacks};
    }
};
struct Box {
    double dx = 2, dy = 2, dz = 2;
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Box"; }
    static constexpr auto fields() { return std::tuple{&Box::dx, &Box::dy, &Box::dz}; }
};
struct Teapot {
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Teapot"; }
    static constexpr auto fields() { return std::tuple{}; }
};
struct Disk {
    double z = 0, radius = 1;
    int slices = 60, rings = 1;
    static constexpr bool solid = false;
    static constexpr std::string_view command() { return "DiskXY"; }
    static constexpr auto fields() {
        return std::tuple{&Disk::z, &Disk::radius, RoundParts{&Disk::slices}, &Disk::rings};
    }
};
// A grid of n1 x n2 cells that spans -size..size in two axes, at `offset` on the third.
enum class Plane : std::uint8_t { xy, xz, yz };
struct Quad {
    Plane plane = Plane::xy;
    double offset = 0, size = 1;
    int n1 = 1, n2 = 1;
    static constexpr bool solid = false;
    constexpr std::string_view command() const {
        return plane == Plane::xy ? "QuadXY" : plane == Plane::xz ? "QuadXZ" : "QuadYZ";
    }
    static constexpr auto fields() { return std::tuple{&Quad::offset, &Quad::size, &Quad::n1, &Quad::n2}; }
};
struct QuadBox {
    int n = 10;
    static constexpr bool solid = false;
    static constexpr std::string_view command() { return "QuadBox"; }
    static constexpr auto fields() { return std::tuple{&QuadBox::n}; }
};
struct Soccerball {
    double radius = 1;
    static constexpr bool solid = true;
    static constexpr std::string_view command() { return "Soccerball"; }
    static constexpr auto fields() { return std::tuple{&Soccerball::radius}; }
};
struct PointCloud {
    int nx = 10, ny = 10, nz = 10;
    bool jitter = false;
    static constexpr bool solid = false;
    constexpr std::string_view command() const { return jitter ? "JitterCloud" : "PointCloud"; }
    static constexpr auto fields() { return std::tuple{&PointCloud::nx, &PointCloud::ny, &PointCloud::nz}; }
};
struct Xarrow {
    int n = 100;
    static constexpr bool solid = false;
    static constexpr std::string_view command() { return "Xarrow"; }
    static constexpr auto fields() { return std::tuple{RoundParts{&Xarrow::n}}; }
};
enum class ObjAs : std::uint8_t { triangles, adjacency, patches };
struct ObjFile {
    Index file = none;  // Scene::files
    ObjAs as = ObjAs::triangles;
    static constexpr bool solid = true;  // mostly
    constexpr std::string_view command() const {
        return as == ObjAs::adjacency ? "ObjAdj" : as == ObjAs::patches ? "ObjPatch" : "Obj";
    }
    static constexpr auto fields() { return std::tuple{&ObjFile::file}; }
};
struct ShpFile {
    Index file = none;  // Scene::files
    static constexpr bool solid = false;
    static constexpr std::string_view command() { return "Shp"; }
    static constexpr auto fields() { return std::tuple{&ShpFile::file}; }
};
struct VertexList {
    Index list = none;  // Scene::vertex_lists
    static constexpr bool solid = false;
    static constexpr std::string_view command() { return "glBegin"; }
    static constexpr auto fields() { return std::tuple{&VertexList::list}; }
};

using Shape = std::variant<Sphere, Torus, Cone, Cylinder, Box, Teapot, Disk, Quad, QuadBox, Soccerball, PointCloud,
                           Xarrow, ObjFile, ShpFile, VertexList>;

// Calls `each(value, round)` for every field; `round`: the value is a number of RoundParts.
template <class Kind, class Each>
void for_each_field(Kind& shape, Each&& each) {
    const auto one = [&]<class Field>(Field field) {
        if constexpr (requires { field.count; })
            each(shape.*field.count, true);
        else
            each(shape.*field, false);
    };
    std::apply([&](auto... field) { (one(field), ...); }, Kind::fields());
}

// Vertices of glBegin … glEnd, Triangles and LinesAdjacency.
struct ListVertex {
    Vec4 position{0, 0, 0, 1};
    Vec3 normal{0, 0, 1};
    Vec3 texcoord{0, 0, 0};
    Vec4 color{1, 1, 1, 1};
};
struct VertexListData {
    Topology topology = Topology::triangles;
    int patch_vertices = 3;
    bool has_color = false;  // a glColor was given, so the draw's own colour is not used
    std::vector<ListVertex> vertices;
};

// ---- programs ---------------------------------------------------------------------------------------

enum class Stage : std::uint8_t { vertex, tess_control, tess_evaluation, geometry, fragment };
inline constexpr int stage_count = 5;

struct UniformValue {
    enum class Kind : std::uint8_t { scalar, array, range, boolean, color };
    std::string name;
    Kind kind = Kind::scalar;
    // For a range: min, current, max. For a boolean: 0 or 1; also for <0> and <1>, which are constants if the uniform
    // is not a bool.
    std::vector<double> values;
    bool integral = false;  // every number was written without point and exponent
    Span span;              // covers name and value
    Span name_span;
    // One for each number, so that saving values rewrites only these. Empty (begin == end) for a number that is not in
    // the text: the current value of <min max>, the blue of {r g}.
    std::vector<Span> value_spans;
};

// Alternative methods from the cheapest to the exact one. One of them is chosen when programs are compiled.
struct Ladder {
    std::string name;                // an identifier
    std::vector<std::string> rungs;  // at least one, all different; letters, digits and underscores
    std::size_t current = 0;         // index into `rungs`
    Span span, name_span;
    std::vector<Span> rung_spans;  // in the order of `rungs`, without brackets

    // True if every rung is a whole number, so that shaders can use its value.
    bool numeric() const;
};

struct Program {
    std::string name;
    std::array<std::optional<FileName>, stage_count> stages;  // nullopt if the stage is not set
    std::vector<UniformValue> uniforms;                       // in the order of the statement
    std::string geometry_input, geometry_output;              // such as "gl_triangles"; empty: as the shader says
    std::size_t ladders = 0;                                  // how many of Scene::ladders precede the program
    Span span;
};

// ---- textures ---------------------------------------------------------------------------------------

// What numbers of colours stand for. `raw`: for themselves. `srgb`: for light, encoded by the sRGB curve (IEC
// 61966-2-1).
enum class Encoding : std::uint8_t { raw, srgb };

enum class TextureTarget : std::uint8_t { d1, d2, d3, cube };
inline constexpr int texture_target_count = 4;

struct Filter {
    enum class Mode : std::uint8_t { nearest, linear, mipmap, anisotropic };
    Mode mode = Mode::linear;
    int anisotropy = 1;
    bool operator==(const Filter&) const = default;
};

// A cube map that is computed from another one: irradiance for diffuse surfaces, or levels of increasing roughness for
// mirrors.
enum class Computed : std::uint8_t { no, irradiance, prefilter };

struct Texture {
    int unit = 0;
    TextureTarget target = TextureTarget::d2;
    std::vector<FileName> files;       // empty for a texture of `size` or a computed one; a cube map has one or six
    std::array<int, 3> size{0, 0, 0};  // of a texture without files; cube: size[0]; computed: 0 if not given
    Computed computed = Computed::no;  // for cube maps only
    int from = 0;                      // computed: the unit to which the source is bound
    Index source = none;               // computed: the source in Scene::textures, which is not itself computed
    std::optional<Encoding> encoding;  // of its files; nullopt: the scene does not say, which means raw
    int bits = 0;                      // bits per channel of a cube map, 8 or 16; 0: as its files need
    Filter filter;
    Span span;
};

// ---- state of a draw --------------------------------------------------------------------------------

struct Camera {
    bool perspective = true;
    double fov = 50;                            // vertical, in degrees
    std::array<double, 4> ortho{-3, 3, -3, 3};  // left, right, bottom, top
    // Eye, centre, up; nullopt: the eye is at the origin and looks along -Z.
    std::optional<std::array<Vec3, 3>> look_at;
    bool operator==(const Camera&) const = default;
};

enum class BlendFactor : std::uint8_t {
    zero,
    one,
    src_color,
    one_minus_src_color,
    dst_color,
    one_minus_dst_color,
    src_alpha,
    one_minus_src_alpha,
    dst_alpha,
    one_minus_dst_alpha,
    src_alpha_saturate,
};
enum class CullFace : std::uint8_t { none, back, front };

struct RasterState {
    bool blend = true;
    BlendFactor src = BlendFactor::src_alpha, dst = BlendFactor::one_minus_src_alpha;
    CullFace cull = CullFace::none;
    bool depth_test = true, depth_write = true;
    bool wireframe = false;
    bool flat = false;
    bool clamp = false;            // textures of this draw are clamped to the edge
    bool point_size_mode = false;  // the vertex shader sets gl_PointSize
    double line_width = 1, point_size = 1;
    bool operator==(const RasterState&) const = default;
};

// The textures bound to units: indices into Scene::textures, sorted by (unit, target).
struct Bindings {
    struct Entry {
        int unit;
        TextureTarget target;
        Index texture;
        bool operator==(const Entry&) const = default;
    };
    std::vector<Entry> entries;
    bool operator==(const Bindings&) const = default;
};

struct Draw {
    Shape shape;
    bool wire = false;      // WireSphere …: the edges of the same solid as GL_LINES
    Index matrix = none;    // index into Scene::matrices: the model transformation without the camera's LookAt
    Index camera = none;    // index into Scene::cameras
    Index raster = none;    // index into Scene::rasters
    Index bindings = none;  // index into Scene::bindings
    Index color = none;     // index into Scene::colors
    Index program = none;   // index into Scene::programs; none: the built-in program
    Span span;
};

struct Clear {
    Span span;
};

struct Item {
    enum class Kind : std::uint8_t { draw, clear };
    Kind kind = Kind::draw;
    Index index = 0;  // index into Scene::draws or Scene::clears
};

// The draws from one RenderTo… statement to the next.
struct Pass {
    enum class Kind : std::uint8_t { window, textures, cube };
    Kind kind = Kind::window;
    std::vector<int> units;  // textures: the units as written
    // The textures bound to these units; none if there was none, which has been reported as an error.
    std::vector<Index> textures;
    Vec3 center{0, 0, 0};            // cube: world position of the eye
    int faces_per_frame = 6;         // cube: 1, 2, 3 or 6; used when frames are paced
    std::optional<Vec4> background;  // the last Background of this pass; nullopt: the target's default
    std::vector<Item> items;
    Span span;  // the statement that began the pass; empty for the first pass
};

struct Message {
    std::string text;
    Span span;
};

struct Scene {
    std::array<int, 2> window_size{600, 600};
    Vec4 background{.0706, .1059, .1294, 1};  // of the window
    Encoding output = Encoding::raw;          // of the window, whose shaders write light if it is encoded
    double timer_period = 10;                 // in seconds
    int noise2d = 64, noise3d = 64;
    std::array<Span, 2> noise_spans;  // of the statements that say so, if any
    bool gstap = false;
    bool verbose = false;
    std::vector<Message> messages;

    std::vector<Pass> passes;  // at least one
    std::vector<Draw> draws;
    std::vector<Clear> clears;

    std::vector<Ladder> ladders;  // with different names
    std::vector<Program> programs;
    std::vector<Texture> textures;
    std::vector<FileName> files;
    std::vector<VertexListData> vertex_lists;

    std::vector<Mat4> matrices;
    std::vector<Camera> cameras;
    std::vector<RasterState> rasters;
    std::vector<Bindings> bindings;
    std::vector<Vec4> colors;
};

}  // namespace snell
