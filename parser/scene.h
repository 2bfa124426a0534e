// What a .glib text means: a display list. Every draw carries the state that stood at its statement.
// Plain values, C++ standard library only. Shared state is kept once and referred to by index, so that a
// scene of a million statements stays small.
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

#include "parser/source.h"

namespace snell {

using Index = std::uint32_t;
inline constexpr Index none = std::numeric_limits<Index>::max();

using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;
using Vec4 = std::array<double, 4>;
using Mat4 = std::array<double, 16>;  // column-major, as OpenGL's

struct FileName {
    std::string name;  // as written, with '/' for '\'
    Span span;
    std::string from = {};  // the included scene that names it; empty: the one that was opened
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
// shapes comes from these two: text, dumps, identity, and the knob that makes round shapes finer.

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
    static constexpr std::string_view command() { return "Sphere"; }
    static constexpr auto fields() {
        return std::tuple{&Sphere::radius, RoundParts{&Sphere::slices}, RoundParts{&Sphere::stacks}};
    }
};
struct Torus {
    double outer = 1, inner = .5;
    int sides = 20, rings = 40;
    static constexpr std::string_view command() { return "Torus"; }
    static constexpr auto fields() {
        return std::tuple{&Torus::outer, &Torus::inner, RoundParts{&Torus::sides}, RoundParts{&Torus::rings}};
    }
};
struct Cone {
    double radius = 1, height = 1;
    int slices = 60, stacks = 1;
    static constexpr std::string_view command() { return "Cone"; }
    static constexpr auto fields() {
        return std::tuple{&Cone::radius, &Cone::height, RoundParts{&Cone::slices}, &Cone::stacks};
    }
};
struct Cylinder {
    double radius = 1, height = 1;
    int slices = 60, stacks = 1;
    static constexpr std::string_view command() { return "Cylinder"; }
    static constexpr auto fields() {
        return std::tuple{&Cylinder::radius, &Cylinder::height, RoundParts{&Cylinder::slices}, &Cylinder::stacks};
    }
};
struct Box {
    double dx = 2, dy = 2, dz = 2;
    static constexpr std::string_view command() { return "Box"; }
    static constexpr auto fields() { return std::tuple{&Box::dx, &Box::dy, &Box::dz}; }
};
struct Teapot {
    static constexpr std::string_view command() { return "Teapot"; }
    static constexpr auto fields() { return std::tuple{}; }
};
struct Disk {
    double z = 0, radius = 1;
    int slices = 60, rings = 1;
    static constexpr std::string_view command() { return "DiskXY"; }
    static constexpr auto fields() {
        return std::tuple{&Disk::z, &Disk::radius, RoundParts{&Disk::slices}, &Disk::rings};
    }
};
// Quads spanning -size..size, split in n1 x n2 cells, at `offset` on the axis that is left out.
enum class Plane : std::uint8_t { xy, xz, yz };
struct Quad {
    Plane plane = Plane::xy;
    double offset = 0, size = 1;
    int n1 = 1, n2 = 1;
    constexpr std::string_view command() const {
        return plane == Plane::xy ? "QuadXY" : plane == Plane::xz ? "QuadXZ" : "QuadYZ";
    }
    static constexpr auto fields() { return std::tuple{&Quad::offset, &Quad::size, &Quad::n1, &Quad::n2}; }
};
struct QuadBox {
    int n = 10;
    static constexpr std::string_view command() { return "QuadBox"; }
    static constexpr auto fields() { return std::tuple{&QuadBox::n}; }
};
struct Soccerball {
    double radius = 1;
    static constexpr std::string_view command() { return "Soccerball"; }
    static constexpr auto fields() { return std::tuple{&Soccerball::radius}; }
};
struct PointCloud {
    int nx = 10, ny = 10, nz = 10;
    bool jitter = false;
    constexpr std::string_view command() const { return jitter ? "JitterCloud" : "PointCloud"; }
    static constexpr auto fields() { return std::tuple{&PointCloud::nx, &PointCloud::ny, &PointCloud::nz}; }
};
struct Xarrow {
    int n = 100;
    static constexpr std::string_view command() { return "Xarrow"; }
    static constexpr auto fields() { return std::tuple{RoundParts{&Xarrow::n}}; }
};
enum class ObjAs : std::uint8_t { triangles, adjacency, patches };
struct ObjFile {
    Index file = none;  // Scene::files
    ObjAs as = ObjAs::triangles;
    constexpr std::string_view command() const {
        return as == ObjAs::adjacency ? "ObjAdj" : as == ObjAs::patches ? "ObjPatch" : "Obj";
    }
    static constexpr auto fields() { return std::tuple{&ObjFile::file}; }
};
struct ShpFile {
    Index file = none;  // Scene::files
    static constexpr std::string_view command() { return "Shp"; }
    static constexpr auto fields() { return std::tuple{&ShpFile::file}; }
};
struct VertexList {
    Index list = none;  // Scene::vertex_lists
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

// glBegin … glEnd, Triangles and LinesAdjacency.
struct ListVertex {
    Vec4 position{0, 0, 0, 1};
    Vec3 normal{0, 0, 1};
    Vec3 texcoord{0, 0, 0};
    Vec4 color{1, 1, 1, 1};
};
struct VertexListData {
    Topology topology = Topology::triangles;
    int patch_vertices = 3;
    bool has_color = false;  // some glColor was given: the draw's own colour does not apply
    std::vector<ListVertex> vertices;
};

// ---- programs ---------------------------------------------------------------------------------------

enum class Stage : std::uint8_t { vertex, tess_control, tess_evaluation, geometry, fragment };
inline constexpr int stage_count = 5;

struct UniformValue {
    enum class Kind : std::uint8_t { scalar, array, range, boolean, color };
    std::string name;
    Kind kind = Kind::scalar;
    std::vector<double> values;  // range: min, current, max; boolean: 0 or 1 (also <0>, <1>: a constant
                                 // where the uniform is not bool)
    bool integral = false;       // every number was written without point and exponent
    Span span;                   // name and value
    Span name_span;
    // One for each number: "save values" rewrites just these. Empty (begin == end) for a number that the text
    // lacks: the current value of <min max>, the blue of {r g}.
    std::vector<Span> value_spans;
};

// Methods from the cheapest to the exact one, of which one is chosen when programs are compiled.
struct Ladder {
    std::string name;                // an identifier
    std::vector<std::string> rungs;  // at least one, all different; letters, digits and underscores
    std::size_t current = 0;         // of `rungs`
    Span span, name_span;
    std::vector<Span> rung_spans;  // as `rungs`, without brackets

    // Every rung is a whole number: its value means something.
    bool numeric() const;
};

struct Program {
    std::string name;
    std::array<std::optional<FileName>, stage_count> stages;  // none: stage not set
    std::vector<UniformValue> uniforms;                       // in the order of the statement
    std::string geometry_input, geometry_output;              // "gl_triangles", …; empty: as the shader says
    std::size_t ladders = 0;                                  // the first so many of Scene::ladders stood before it
    Span span;
};

// ---- textures ---------------------------------------------------------------------------------------

enum class TextureTarget : std::uint8_t { d1, d2, d3, cube };
inline constexpr int texture_target_count = 4;

struct Filter {
    enum class Mode : std::uint8_t { nearest, linear, mipmap, anisotropic };
    Mode mode = Mode::linear;
    int anisotropy = 1;
    bool operator==(const Filter&) const = default;
};

// What is computed from another cube map: the light that a matt surface gathers, or what mirrors see that are the
// rougher the higher the level.
enum class Computed : std::uint8_t { no, irradiance, prefilter };

struct Texture {
    int unit = 0;
    TextureTarget target = TextureTarget::d2;
    std::vector<FileName> files;       // none: empty texture of `size`, or computed; cube: one or six
    std::array<int, 3> size{0, 0, 0};  // of an empty texture; cube: size[0]; computed ones: 0 where not given
    Computed computed = Computed::no;  // only of cube maps
    int from = 0;                      // computed: the unit that the source stands on
    Index source = none;               // computed: the source in Scene::textures, which is not computed itself
    int bits = 0;                      // of a channel of a cube map, 8 or 16; 0: what its files need
    Filter filter;
    Span span;
};

// ---- state of a draw --------------------------------------------------------------------------------

struct Camera {
    bool perspective = true;
    double fov = 50;                             // vertical, degrees
    std::array<double, 4> ortho{-3, 3, -3, 3};   // left right bottom top
    std::optional<std::array<Vec3, 3>> look_at;  // eye, centre, up; none: eye at the origin, looking to -Z
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
    bool clamp = false;            // textures of this draw clamp to edge
    bool point_size_mode = false;  // the vertex shader sets gl_PointSize
    double line_width = 1, point_size = 1;
    bool operator==(const RasterState&) const = default;
};

// Textures by unit and target: Scene::textures, sorted by (unit, target).
struct Bindings {
    struct Entry {
        int unit;
        TextureTarget target;
        Index texture;
        bool operator==(const Entry&) const = default;
    };
    std::vector<Entry> entries;
};

struct Draw {
    Shape shape;
    bool wire = false;      // WireSphere …: GL_LINES of the same solid
    Index matrix = none;    // Scene::matrices: model transformation; the camera's LookAt is not in it
    Index camera = none;    // Scene::cameras
    Index raster = none;    // Scene::rasters
    Index bindings = none;  // Scene::bindings
    Index color = none;     // Scene::colors
    Index program = none;   // Scene::programs; none: the built-in program
    Span span;
};

struct Clear {
    Span span;
};

struct Item {
    enum class Kind : std::uint8_t { draw, clear };
    Kind kind = Kind::draw;
    Index index = 0;  // Scene::draws or Scene::clears
};

// The draws between one RenderTo… statement and the next.
struct Pass {
    enum class Kind : std::uint8_t { window, textures, cube };
    Kind kind = Kind::window;
    std::vector<int> units;          // textures: the units as written
    std::vector<Index> textures;     // what stood on those units; none where nothing did (an error was given)
    Vec3 center{0, 0, 0};            // cube: world position of the eye
    int faces_per_frame = 6;         // cube: 1, 2, 3 or 6, where frames follow each other
    std::optional<Vec4> background;  // last Background of this pass; none: the target's default
    std::vector<Item> items;
    Span span;  // the statement that began it; empty for the first
};

struct Message {
    std::string text;
    Span span;
};

struct Scene {
    std::array<int, 2> window_size{600, 600};
    Vec4 background{.0706, .1059, .1294, 1};  // of the window
    double timer_period = 10;                 // seconds
    int noise2d = 64, noise3d = 64;
    bool gstap = false;
    bool verbose = false;
    std::vector<Message> messages;

    std::vector<Pass> passes;  // at least one
    std::vector<Draw> draws;
    std::vector<Clear> clears;

    std::vector<Ladder> ladders;  // their names all differ
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
