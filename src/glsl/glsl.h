// From the GLSL that students write to the GLSL that core profiles and OpenGL ES take. No GL here.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"

namespace snell::glsl {

// What the context accepts.
struct Target {
    int version = 330;  // 330, 410, 450 …; with es: 300, 320
    bool es = false;
    bool fp64 = true;  // doubles are there

    bool has_precise() const { return !es || version >= 320; }
};

// One stage of a program: its text is in Sources, so that messages can point into it.
struct StageInput {
    Stage stage = Stage::vertex;
    FileId file = 0;
    Span reference;  // where the scene names it
};

// A macro set from outside (ladders): `#define NAME VALUE` ahead of the user's first line.
struct Define {
    std::string name, value;
};

// Gives the text of `#include "name"` (relative to `from`) or `#include <name>` (angle = true).
struct IncludeText {
    std::string name, text;
    std::string why = {};  // without a name: why the file cannot be read
    bool inexact = false;  // the file of that name is another one, which is taken for it
};
using IncludeReader =
    std::function<std::optional<IncludeText>(std::string_view from, std::string_view name, bool angle)>;

// A uniform that the program's own text declares.
struct DeclaredUniform {
    std::string name;       // the scene's, as RenamedUniform::name
    std::string glsl_type;  // "vec3", on which all stages agree
    int array_size = 0;     // 0: no array
    // A number, vector or matrix: no array, structure, sampler or member of a block.
    bool simple = true;
    bool in_block = false;        // no scene can set it: it reads zero
    std::vector<double> initial;  // of its initialiser; empty: none
    // A function that main reaches names it. A driver may still find that it changes nothing.
    bool used = false;
    std::vector<std::string> functions = {};  // that name it, such as "main (fragment)"
    Span span = {};                           // of its name, where it is declared first
};

// A uniform that keeps its value, column by column: what the value decides is written as decided.
struct Settled {
    std::string name;  // the scene's
    std::vector<double> values;
    bool operator==(const Settled&) const = default;
};
// Chooses the uniforms of a program that are settled.
using Settler = std::function<std::vector<Settled>(std::span<const DeclaredUniform>)>;

struct Options {
    Target target;
    std::vector<Define> defines;
    // None: the program is one for any values.
    Settler settle;
    std::string geometry_input, geometry_output;  // "gl_triangles" …, from GeometryInput/GeometryOutput
    bool flat_color = false;                      // the legacy colour varyings are not interpolated
    // Lines become quads of `snell_LineWidth` pixels in `snell_Viewport`, by a geometry stage that passes every
    // varying on. For programs of a vertex and a fragment shader only.
    bool wide_lines = false;
    // gl_FragCoord is that of the whole picture where only a part of it is drawn: `snell_Place` is added.
    bool placed = false;
    // The context has no more stages than OpenGL ES 3.0: see Translation::tessellation and ::geometry.
    bool without_stages = false;
    int patch_vertices = 3;  // then: of each patch
    // A number or truth value that is written as a constant: to see what drivers make of its values, never to draw.
    std::optional<Settled> constant;
    int color_outputs = 1;  // render targets at once: gl_FragColor is written to each
    IncludeReader include;
    Limits limits;  // of includes and of nesting
};

// Operands that an operator does not take, as far as types are known: to explain what a driver refuses without naming
// them. Without `right` there is only one operand. `=`: the type of what a name gets that nothing declares. `:=`: what
// is assigned, at the right, has another size than what it is assigned to.
struct Misfit {
    Span span;  // of the expression
    std::string op;
    std::string_view left, right;
};

// A stage as the driver shall compile it. `files[n]` is the text that `#line … n` numbers as source string n,
// so the driver's "n:line" leads back to the user's file.
struct StageOutput {
    Stage stage = Stage::vertex;
    std::string text;
    std::vector<FileId> files;
    std::vector<Misfit> misfits = {};
    std::vector<Stage> written_in = {};  // the author's stage of each of `files`; empty: this one

    Stage stage_of(std::size_t file) const { return file < written_in.size() ? written_in[file] : stage; }
};

// The value an initialised uniform has until something sets it (needed where the target takes no
// initialisers, and to fill the user interface), and the units of a sampler whose layout(binding) the target
// does not take. `name` is the scene's, without "[0]".
struct UniformDefault {
    std::string name;
    std::vector<double> values;
};

// A uniform whose name can't stand in the translated shader (`uniform sampler2D sample`, or a variable that hides
// a built-in function it calls): what the scene calls `name` is the active uniform `shader_name`.
struct RenamedUniform {
    std::string name, shader_name;
};

// A vertex and a geometry stage as two vertex shaders, whose outputs transform feedback writes to buffers, for contexts
// that have no geometry stage (forms/geometry.cpp). `count` runs once for each primitive and invocation, and tells how
// many vertices are emitted and where strips end. `capture` runs for every `vertices` of them, beginning at the one
// that its attribute `snell_Slot` (location 0) names after the number of the invocation, and writes all that they
// output. `listed`: they output too much to be captured. There is no `capture`, and the vertex shader among the
// program's stages runs both for each vertex that is drawn, whose number is that of the run times `most`, plus its own.
struct EmulatedGeometry {
    StageOutput count, capture;
    std::vector<std::string> counted, captured;  // what transform feedback writes, interleaved
    std::string input, output;                   // primitives, as layouts name them
    int invocations = 1, most = 1;               // of each primitive; vertices that one of them may emit
    bool listed = false;
    int vertices = 1;            // that one run of `capture` writes
    std::vector<bool> integral;  // of the slots of one vertex, four components each: whole numbers
};

// The stages up to the evaluation stage as two vertex shaders, for contexts that have no tessellation
// (forms/tessellation.cpp). `control` runs `runs` times for each patch, and writes `slots` times four whole numbers in
// each run; the first six of a patch are the bits of its outer and inner levels. All together are the texture
// `stage_patches`, which the evaluation stage reads: a vertex shader, whose attribute is (u, v, number of the patch).
struct EmulatedTessellation {
    StageOutput control;
    std::vector<std::string> captured;
    int runs = 1, slots = 1;
    int corners = 3;              // vertices of a patch
    std::string domain, spacing;  // as layouts name them
    bool clockwise = false, points = false;
};
// What these shaders read: texels of the mesh's attributes, `stage_attributes` of each vertex in the order of
// Attribute; the indices of its primitives, four a texel; the first primitive of the draw, and whether the mesh has
// colours.
inline constexpr std::string_view stage_vertices = "snell_StageVertices", stage_primitives = "snell_StagePrimitives",
                                  stage_range = "snell_StageRange", stage_patches = "snell_StagePatches";
inline constexpr int stage_attributes = 5;

// On OpenGL ES, the loops of which nobody knows how often they go round are left after so many rounds, together.
inline constexpr int most_rounds = 1 << 18;

// The loops of a stage may go round thousands of times, unless each of the uniforms `bounds` is at most `up_to` in
// magnitude; negative: whatever they are.
struct LongLoops {
    std::vector<std::string> bounds;
    double up_to = -1;
};

struct Translation {
    bool ok = false;  // false: diagnostics hold at least one error
    std::vector<StageOutput> stages;
    // Where Options::without_stages replaced tessellation: the vertex shader among `stages`, or that which
    // `geometry` was made from, is the evaluation stage.
    std::optional<EmulatedTessellation> tessellation;
    // Where it replaced a geometry stage. The vertex shader among `stages` hands on what was captured: its attributes
    // are the slots, by their numbers.
    std::optional<EmulatedGeometry> geometry;
    std::vector<UniformDefault> defaults;
    std::vector<RenamedUniform> renamed;
    std::vector<DeclaredUniform> declared;  // stage by stage, as the texts declare them; each once
    std::vector<Settled> settled;           // those of Options::settle that decide something
    bool uses_alpha = true;                 // false: every colour output is known to have alpha 1
    // Every vertex goes where the model-view-projection matrix puts it, and no stage reads a depth or the projection:
    // the near and the far plane may be moved without any other change.
    bool plain_depth = false;
    // The name of the matrix that places the vertices, if the vertex shader only multiplies them by it, and a draw
    // that shows none of them changes nothing; empty otherwise. A scene may set a uniform of that name.
    std::string placed_by;
    bool reads_place = false;  // the fragment shader names gl_FragCoord
    // Of the fragment shader, and in OpenGL ES, where they are left after most_rounds, of any stage.
    std::vector<LongLoops> long_loops;
};

// Translates all stages of one program together: interfaces between them are made to match.
Translation translate(const std::vector<StageInput>& stages, Sources& sources, const Options& options,
                      Diagnostics& diagnostics);

// Turns a driver's compile or link log (Mesa, NVIDIA, AMD/Intel, Apple, ANGLE) into diagnostics at the user's
// own lines: first cause first, follow-ups folded, hints for the classics. `stage` is null for link logs.
// `where` is the scene's statement, for lines that lead nowhere.
// `lines` says what the log's line numbers count.
enum class Lines : std::uint8_t { numbered, unnumbered };  // those of StageOutput::text; those of unnumbered(text)
void explain_log(std::string_view log, const Translation& translation, const StageOutput* stage, Span where,
                 std::string_view program, const Sources& sources, Diagnostics& diagnostics,
                 Lines lines = Lines::numbered);

// The text of a stage with an empty line for each #line. Mesa forgets in which source string an expression stands, so
// what is wrong in an included file is found by its line in the whole text.
std::string unnumbered(std::string_view text);

// ---- the names that translated shaders use for what the system provides --------------------------------
// The translator writes these, the runtime sets them. A legacy `gl_Xyz` becomes `snell_Xyz`, an array or
// struct keeps its shape (snell_TextureMatrix[8], snell_LightSource[8], snell_FrontMaterial, snell_Fog …).

// Vertex attributes, at fixed locations in every program: bound by the runtime with glBindAttribLocation
// before linking, by any of these names. Multi-texture coordinates beyond 0 read as texcoord 0.
enum class Attribute : int {
    vertex = 0,
    normal = 1,
    color = 2,
    texcoord = 3,
    tangent = 4,
    secondary_color = 5,
    fog_coord = 6,
    vertex_id = 7
};
inline constexpr int attribute_count = 8;
struct AttributeName {
    std::string_view name;
    Attribute attribute;
};
// snell_Vertex, snell_Normal, snell_Color, snell_MultiTexCoord0 …, and the modern names: aVertex, aNormal,
// aColor, aTexCoord0 … 7, Tangent, position, i_position, normal, i_normal …
std::vector<AttributeName> attribute_names();

// One row for every Attribute: what the translator declares, and what docs/variables.md says of it.
struct AttributeFacts {
    Attribute attribute;
    std::string_view name, type;  // as the translator declares it
    int rows;                     // of the type
    std::string_view space, range, doc;
};
std::span<const AttributeFacts, attribute_count> attribute_facts();

// Matrices and the like that the runtime sets when a linked program has them active.
enum class System : std::uint8_t {
    model_view,
    projection,
    model_view_projection,
    normal_matrix,
    model_view_inverse,
    projection_inverse,
    model_view_projection_inverse,
    model_view_transpose,
    projection_transpose,
    model_view_projection_transpose,
    model_view_inverse_transpose,
    projection_inverse_transpose,
    model_view_projection_inverse_transpose,
    texture_matrix,
    texture_matrix_inverse,
    texture_matrix_transpose,
    texture_matrix_inverse_transpose,
    model,
    view,
    view_projection,
    model_inverse,
    view_inverse,
    model_normal_matrix,
    model_viewer,         // world axes, relative to the eye that looks through the scene transformation
    camera_position,      // world space; the eye that looks through the scene transformation
    viewer_position_eye,  // eye space; the eye that looks through the scene transformation
    normal_scale,
    timer,
    time,
    resolution,
    mouse,
    noise2,
    noise3,
    face_index,
    point_size,
    fixed_point_size,
    line_width,
    viewport,   // pixels
    place,      // of the part of the picture that is drawn: pixels from the left, the bottom and the top
    harmonics,  // nine coefficients of the cube map that the last Irradiance names
};

// One row for every System. docs/variables.md is written from these rows.
struct SystemFacts {
    System system;
    std::string_view type;  // GLSL type that the active uniform must have: "mat4", "vec3", "float", "int" …
    std::string_view space, range, doc;
};
std::span<const SystemFacts> system_facts();
struct SystemName {
    std::string_view name;
    System system;
    std::string_view type;  // as in SystemFacts
    bool legacy;            // written by the translator only: always set. Otherwise set only if the scene does
                            // not set that name itself.
};
std::vector<SystemName> system_names();

// The samplers of <snell/mesh.glsl>, for the triangles of the mesh that is drawn. All are sampler2D.
inline constexpr std::array<std::string_view, 3> mesh_samplers{"snellMeshNodes", "snellMeshTriangles",
                                                               "snellMeshNormals"};

// Documented defaults of gl_LightSource, gl_FrontMaterial, gl_Fog, gl_LightModel …: the name of each active
// uniform ("snell_LightSource[0].position") and its value.
std::vector<UniformDefault> fixed_function_defaults();

}  // namespace snell::glsl
