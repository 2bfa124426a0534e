// The table itself, in the groups of docs/language.md. A command is one row here, its handler is declared in
// handlers.h.
#include "parser/commands/commands.h"

#include <cstdio>
#include <utility>

#include "parser/commands/handlers.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"

namespace snell {
namespace {

// A command that glman lacks.
constexpr Command addition(Command row) {
    row.addition = true;
    return row;
}

// clang-format off
constexpr Command view_rows[] = {
    {"WindowSize", "wx:int=600 wy:int=600", "Initial size of the drawing area, in pixels.", handle::window_size},
    {"Ortho", "xl=-3 xr=3 yb=-3 yt=3", "Orthographic projection: left, right, bottom and top of the visible area.", handle::ortho},
    {"Perspective", "fov=50", "Perspective projection with a vertical field of view in degrees.", handle::perspective, "Persp"},
    {"LookAt", " | ex ey=0 ez=0 lx=0 ly=0 lz=0 ux=0 uy=1 uz=0", "Places the eye: its position, the point it looks at, and the up direction. Replaces the previous LookAt. Without arguments: at the origin, looking along -Z.", handle::look_at},
    {"Background", "r=.0706 g=.1059 b=.1294 a=1 | color:vec3", "Colour that the current target is cleared to. Values outside 0..1 are clamped.", handle::background},
    addition({"Output", "encoding:raw/srgb=srgb", "What the colours of shaders are in the window, Background included. raw: the numbers that the display gets. srgb: light, which is encoded by the sRGB curve after blending. Default of a scene: raw.", handle::output}),
    {"Clear", "", "Clears colour and depth of the current target now.", handle::clear},
};

constexpr Command transformations_rows[] = {
    {"Translate", "x y=0 z=0", "Moves the following draws.", handle::translate},
    {"Rotate", "angle x=0 y=0 z=0", "Rotates the following draws by an angle in degrees about an axis through the origin.", handle::rotate},
    {"Scale", "s | sx sy sz=1", "Scales the following draws, by one factor or along each axis.", handle::scale},
    {"PushMatrix", "", "Saves the current transformation for the matching PopMatrix.", handle::push_matrix, "TransformBegin"},
    {"PopMatrix", "", "Restores the transformation that the matching PushMatrix saved.", handle::pop_matrix, "TransformEnd"},
};

constexpr Command geometry_rows[] = {
    {"Sphere", "radius=1 slices:int=60 stacks:int=60", "Solid sphere around the origin, with poles on Y.", handle::sphere},
    {"Torus", "outer=1 inner=.5 sides:int=20 rings:int=40", "Solid torus around Y. The larger radius is the ring's, the smaller the tube's.", handle::torus},
    {"Cone", "radius=1 height=1 slices:int=60 stacks:int=1", "Solid, capped cone with its base on y = 0 and its tip at +Y.", handle::cone},
    {"Cylinder", "radius=1 height=1 slices:int=60 stacks:int=1", "Solid, capped cylinder with its base on y = 0, along +Y.", handle::cylinder},
    {"Box", "dx=2 dy=2 dz=2", "Solid box about the origin with sides of these lengths.", handle::box, "Cube"},
    {"Teapot", "", "The Utah teapot, its spout to +X.", handle::teapot},
    {"DiskXY", "z=0 radius=1 slices:int=60 rings:int=1", "Disk parallel to the XY plane, facing +Z.", handle::disk_xy},
    {"QuadXY", "z=0 size=1 nx:int=1 ny:int=1", "Square parallel to the XY plane from -size to size, split into nx by ny cells.", handle::quad_xy},
    {"QuadXZ", "y=0 size=1 nx:int=1 nz:int=1", "Square parallel to the XZ plane from -size to size, split into nx by nz cells.", handle::quad_xz},
    {"QuadYZ", "x=0 size=1 ny:int=1 nz:int=1", "Square parallel to the YZ plane from -size to size, split into ny by nz cells.", handle::quad_yz},
    {"QuadBox", "n:int=10", "n squares parallel to XY from z = -1 to z = 1, with 3D texture coordinates.", handle::quad_box},
    {"Soccerball", "radius=1", "Truncated icosahedron; the number of each face is in FaceIndex.", handle::soccerball},
    {"PointCloud", "nx:int=10 ny:int=10 nz:int=10", "Points that fill the cube from -1 to 1 regularly.", handle::point_cloud},
    {"JitterCloud", "nx:int=10 ny:int=10 nz:int=10", "Points that fill the cube from -1 to 1, each moved randomly within its cell.", handle::jitter_cloud},
    {"Xarrow", "n:int=100", "Arrow on the X axis from 0 to 1, of n slices.", handle::xarrow},
    {"WireSphere", "radius=1 slices:int=60 stacks:int=60", "Edges of the Sphere.", handle::wire_sphere},
    {"WireTorus", "outer=1 inner=.5 sides:int=20 rings:int=40", "Edges of the Torus.", handle::wire_torus},
    {"WireCone", "radius=1 height=1 slices:int=60 stacks:int=1", "Edges of the Cone.", handle::wire_cone},
    {"WireCylinder", "radius=1 height=1 slices:int=60 stacks:int=1", "Edges of the Cylinder.", handle::wire_cylinder},
    {"WireBox", "dx=2 dy=2 dz=2", "Edges of the Box.", handle::wire_box, "WireCube"},
    {"WireTeapot", "", "Edges of the Teapot.", handle::wire_teapot},
    {"Obj", "file:path", "The faces of a Wavefront .obj file, as triangles.", handle::obj},
    {"ObjAdj", "file:path", "The faces of a Wavefront .obj file, as triangles with adjacency for geometry shaders.", handle::obj_adj},
    {"ObjPatch", "file:path", "The faces of a Wavefront .obj file, as patches of three vertices for tessellation shaders.", handle::obj_patch},
    {"WireObj", "file:path", "The edges of a Wavefront .obj file.", handle::wire_obj},
    {"Shp", "file:path", "The polylines of an ESRI shape file.", handle::shp},
    {"LinesAdjacency", "v0:vec3 v1:vec3 v2:vec3 v3:vec3", "One line from v1 to v2 with its neighbours, for geometry shaders.", handle::lines_adjacency},
    {"Triangles", "v0:vec3 v1:vec3 v2:vec3", "One triangle with the normal of its plane.", handle::triangles},
    {"glBegin", "topology:name", "Begins a list of vertices: gl_patches, gl_points, gl_lines, gl_line_strip, gl_line_loop, gl_triangles, gl_triangle_strip, gl_triangle_fan, or one of these lines and triangles with _adjacency.", handle::gl_begin},
    {"glVertex", "x y=0 z=0 w=1", "One vertex of the list, with the current colour, normal and texture coordinates.", handle::gl_vertex},
    {"glColor", "r=1 g=1 b=1 a=1 | color:vec3", "Colour of the vertices that follow, and of the draws after the list.", handle::color},
    {"glNormal", "x y z", "Normal of the vertices that follow.", handle::gl_normal},
    {"glTexCoord", "s t=0 p=0", "Texture coordinates of the vertices that follow.", handle::gl_tex_coord},
    {"glEnd", "", "Ends the list that glBegin began, and draws it.", handle::gl_end},
    {"NumPatchVertices", "n:int=3", "Vertices per patch of the following gl_patches.", handle::num_patch_vertices},
};

constexpr Command textures_rows[] = {
    {"Texture1D", "unit:int file:path", "Binds a one-dimensional image to a texture unit.", handle::texture_1d},
    {"Texture2D", "unit:int dims:int dimt:int | unit:int file:path encoding:raw/srgb?", "Binds an image to a texture unit, or creates an empty texture of dims by dimt to draw to. In snell also: srgb, the file holds colours as displays show them, and shaders read the light that they stand for. Default: raw, shaders read the numbers of the file.", handle::texture_2d},
    {"Texture3D", "unit:int dims:int dimt:int dimp:int | unit:int file:path", "Binds a volume to a texture unit, or creates an empty one.", handle::texture_3d},
    {"CubeMap", "unit:int posx:path negx:path posy:path negy:path posz:path negz:path encoding:raw/srgb? | unit:int file:path encoding:raw/srgb? | unit:int size:int", "Binds a cube map of six images to a texture unit. In snell also: one file, which is one of six numbered faces, a panorama, a cross or a strip; the size of an empty cube map to draw to; srgb, as in Texture2D.", handle::cube_map},
    {"Noise2D", "n:int=64", "Resolution of the built-in texture Noise2.", handle::noise_2d},
    {"Noise3D", "n:int=64", "Resolution of the built-in texture Noise3.", handle::noise_3d},
    {"Clamp", "", "Textures of the following draws clamp at their edges instead of repeating.", handle::clamp},
    addition({"Filter", "mode:nearest/linear/mipmap/anisotropic=linear n:int=16", "Filter of the textures named after it; n is the maximum anisotropy.", handle::filter}),
    {"RenderToTexture", "units:int...", "Renders the following draws to the 2D textures on these units, one for each output of the fragment shader. Without arguments: to the window.", handle::render_to_texture},
    addition({"RenderToCube", "unit:int x=0 y=0 z=0 faces:int=6 | unit:int center:vec3 faces:int=6", "Renders the following draws to the six faces of the cube map on this unit, seen from this point. In the window, 1, 2 or 3 faces a frame can be redrawn instead of all 6.", handle::render_to_cube}),
    addition({"Irradiance", "unit:int from:int size:int=16", "Binds the irradiance of the cube map on unit `from`, the light that matt surfaces collect, to a unit: a cube map of size texels per side to look up by the normal.", handle::irradiance}),
    addition({"Prefilter", "unit:int from:int size:int?", "Binds prefiltered reflections of the cube map on unit `from` to a unit: a chain of levels, the last for roughness 1, the first the cube map itself with size texels per side (default: its own size, at most 128, or 64 if it is drawn to).", handle::prefilter}),
};

constexpr Command programs_rows[] = {
    {"Vertex", "file:path?", "Vertex shader of the programs that follow; without an argument: none.", handle::vertex},
    {"TessControl", "file:path?", "Tessellation control shader of the programs that follow; without an argument: none.", handle::tess_control},
    {"TessEvaluation", "file:path?", "Tessellation evaluation shader of the programs that follow; without an argument: none.", handle::tess_evaluation},
    {"Geometry", "file:path?", "Geometry shader of the programs that follow; without an argument: none.", handle::geometry},
    {"Fragment", "file:path?", "Fragment shader of the programs that follow; without an argument: none.", handle::fragment},
    {"GeometryInput", "topology:gl_points/gl_lines/gl_lines_adjacency/gl_triangles/gl_triangles_adjacency?", "Input primitive of geometry shaders without a layout.", handle::geometry_input},
    {"GeometryOutput", "topology:gl_points/gl_line_strip/gl_triangle_strip?", "Output primitive of geometry shaders without a layout.", handle::geometry_output},
    {"Program", "name:name? values:uniforms", "Links the current shaders to the program of the following draws, and sets its uniforms: a number, an array [x y z], a range <min current max> on a slider, <true> or <false>, a colour {r g b} or {r g b a}. Without arguments the built-in program draws.", handle::program},
    {"GSTAP", "", "The shaders use the names of the book Graphics Shaders without declaring them: the uniforms uModelViewMatrix, uProjectionMatrix, uModelViewProjectionMatrix, uNormalMatrix and uModelViewMatrixInverse, and in vertex shaders the attributes aVertex, aNormal, aColor and aTexCoord0 to aTexCoord7. snell always provides them, with or without this command; a declaration in the shader wins.", handle::gstap},
    addition({"Ladder", "name:name rungs:rest", "Declares methods from cheap to exact, the current one in angle brackets; the programs that follow are compiled for it. In shaders its name is the rung's number in this order, from 0; rungs that are numbers are NAME_VALUE.", handle::ladder}),
};

constexpr Command state_rows[] = {
    {"Color", "r=1 g=1 b=1 a=1 | color:vec3", "The current colour: gl_Color of the draws that follow.", handle::color},
    {"LineWidth", "w=1", "Width of lines, in pixels.", handle::line_width},
    {"PointSize", "s=1", "Size of points, in pixels.", handle::point_size},
    {"PointSizeMode", "mode:int=0", "1: the vertex shader sets the size of points in gl_PointSize. 0: PointSize does.", handle::point_size_mode},
    {"Flat", "", "Flat shading: each face has the colour of one vertex.", handle::flat},
    {"Smooth", "", "Smooth shading: colours are interpolated over each face. Default.", handle::smooth},
    addition({"Blend", "state:on/off=on | src:" SNELL_BLEND_FACTORS " dst:" SNELL_BLEND_FACTORS, "Blends draws with the existing picture, by alpha or by these factors. Default: on.", handle::blend}),
    addition({"CullFace", "face:none/back/front=back", "Faces that are culled. Default: none.", handle::cull_face}),
    addition({"DepthTest", "state:on/off=on", "Nearer surfaces hide farther ones. Default: on.", handle::depth_test}),
    addition({"DepthWrite", "state:on/off=on", "Draws write their depth. Default: on.", handle::depth_write}),
    addition({"Wireframe", "state:on/off=on", "Draws only the edges of triangles. Default: off.", handle::wireframe}),
};

constexpr Command other_rows[] = {
    {"Timer", "secs=10", "Period of the uniform Timer, which runs from 0 to 1 repeatedly.", handle::timer},
    {"MessageBox", "text:rest", "Shows a message.", handle::message_box},
    {"Verbose", "", "Prints more messages.", handle::verbose},
    addition({"Include", "file:path", "Reads another scene here, as if its text were in this place.", handle::include}),
};
// clang-format on

struct RowGroup {
    std::string_view name;
    std::span<const Command> rows;
};
constexpr RowGroup row_groups[] = {{"View", view_rows},         {"Transformations", transformations_rows},
                                   {"Geometry", geometry_rows}, {"Textures", textures_rows},
                                   {"Programs", programs_rows}, {"State", state_rows},
                                   {"Other", other_rows}};

constexpr auto table = [] {
    constexpr std::size_t count = [] {
        std::size_t sum = 0;
        for (const RowGroup& group : row_groups) sum += group.rows.size();
        return sum;
    }();
    std::array<Command, count> all{};
    auto* next = all.begin();
    for (const RowGroup& group : row_groups)
        for (const Command& row : group.rows) {
            *next = row;
            next++->group = group.name;
        }
    return all;
}();

// Setting one bit makes letters lower case, and tells other characters well enough apart.
constexpr std::uint32_t hash(std::string_view word) {
    std::uint32_t h = 0;
    for (const char c : word) h = h * 31 + (static_cast<unsigned char>(c) | 32u);
    return h ^ (h >> 9);
}

// Open addressing over names and aliases: 0 is empty, else the row plus one.
constexpr std::size_t slots = 512;
constexpr std::array<std::uint8_t, slots> index_by_name = [] {
    std::array<std::uint8_t, slots> index{};
    const auto add = [&](std::string_view name, std::size_t row) {
        std::size_t at = hash(name) % slots;
        while (index[at] != 0) at = (at + 1) % slots;
        index[at] = static_cast<std::uint8_t>(row + 1);
    };
    for (std::size_t row = 0; row < std::size(table); ++row) {
        add(table[row].name, row);
        if (!table[row].alias.empty()) add(table[row].alias, row);
    }
    return index;
}();
static_assert(std::size(table) < 255);

constexpr bool documented() {
    for (const Command& c : table)
        if (c.name.empty() || c.doc.size() < 10) return false;
    return true;
}
static_assert(documented(), "every row has a name and a documentation");

}  // namespace

std::span<const Command> commands() { return table; }

const Command* find_command(std::string_view word) {
    constexpr std::size_t longest = 24;
    if (word.empty() || word.size() > longest) return nullptr;
    for (std::size_t at = hash(word) % slots; index_by_name[at] != 0; at = (at + 1) % slots) {
        const Command& command = table[index_by_name[at] - 1];
        if (same_word(word, command.name) || same_word(word, command.alias)) return &command;
    }
    return nullptr;
}

const std::vector<std::string_view>& command_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all;
        for (const Command& c : table) {
            all.push_back(c.name);
            if (!c.alias.empty()) all.push_back(c.alias);
        }
        return all;
    }();
    return names;
}

namespace {

std::string json(std::string_view text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        if (static_cast<unsigned char>(c) < 0x20) {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(c));
            out += escape;
        } else {
            out += c;
        }
    }
    return out + "\"";
}

std::string_view kind(ArgumentKind kind) {
    constexpr std::string_view names[] = {"number", "int", "path", "name", "choice", "vec3", "uniforms", "rest"};
    return names[static_cast<std::size_t>(kind)];
}

std::string choices(std::string_view list) {
    std::string out;
    for (const std::string_view word : split(list, '/')) out += (out.empty() ? "[" : ", ") + json(word);
    return out + "]";
}

std::string argument(const Parameter& p) {
    std::string out = "{\"name\": " + json(p.name) + ", \"kind\": " + json(kind(p.kind));
    if (p.kind == ArgumentKind::choice) out += ", \"choices\": " + choices(p.choices);
    if (!p.default_text.empty()) {
        const bool number = p.kind == ArgumentKind::number || p.kind == ArgumentKind::integer;
        // JSON has no numbers that begin or end with a point.
        std::string value = number ? text_of::number(p.default_value) : json(p.default_text);
        if (value.ends_with('.')) value.pop_back();
        out += ", \"default\": " + value;
    }
    if (p.optional) out += ", \"optional\": true";
    if (p.repeated) out += ", \"repeated\": true";
    return out + "}";
}

std::string row(const Command& c) {
    std::string out = "  {\"name\": " + json(c.name) + ", \"group\": " + json(c.group);
    out += ", \"aliases\": [" + (c.alias.empty() ? "" : json(c.alias)) + "]";
    out += std::string(", \"addition\": ") + (c.addition ? "true" : "false");
    out +=
        ",\n   \"signature\": " + json(c.signature.text) + ",\n   \"doc\": " + json(c.doc) + ",\n   \"arguments\": [";
    for (std::size_t i = 0; i < c.signature.count; ++i) {
        out += i == 0 ? "[" : ", [";
        for (std::size_t j = 0; j < c.signature.parameter_count(i); ++j)
            out += (j == 0 ? "" : ", ") + argument(c.signature.parameter(i, j));
        out += "]";
    }
    return out + "]}";
}

}  // namespace

std::string commands_json() {
    std::string rows;
    for (const Command& c : commands()) rows += (rows.empty() ? "" : ",\n") + row(c);
    return "{\"schema\": 1, \"commands\": [\n" + rows + "\n]}";
}

namespace {

using Entry = std::pair<std::string_view, std::string_view>;

constexpr std::string_view no_lights =
    "there are no lights but those of shaders: compute the light in the fragment shader, from uniforms such as "
    "uLightPos";
constexpr std::string_view no_materials =
    "there are no materials but those of shaders: give the program uniforms such as uKa, uKd and uKs; 'Color r g b' "
    "sets "
    "gl_Color";
constexpr std::string_view textures =
    "'Texture2D unit file' puts an image on a unit, and a sampler on the Program line "
    "is given that unit";
constexpr std::string_view culling =
    "'CullFace back' or 'CullFace front' leaves faces out; front faces are those whose "
    "corners run counter-clockwise";
constexpr std::string_view stencil = "there is no stencil buffer in the language";

// The arguments of glEnable and glDisable that a command replaces: it takes on or off.
constexpr auto capabilities = std::to_array<Entry>({
    {"BLEND", "Blend"},
    {"DEPTH_TEST", "DepthTest"},
});

constexpr auto other_capabilities = std::to_array<Entry>({
    {"CULL_FACE", culling},
    {"LIGHTING", no_lights},
    {"COLOR_MATERIAL", no_materials},
    {"TEXTURE_1D", textures},
    {"TEXTURE_2D", textures},
    {"TEXTURE_3D", textures},
    {"TEXTURE_CUBE_MAP", textures},
    {"NORMALIZE", "write normalize(…) in the shader"},
    {"RESCALE_NORMAL", "write normalize(…) in the shader"},
    {"FOG", "there is no fog but that of shaders: mix(color, fogColor, …) in the fragment shader"},
    {"STENCIL_TEST", stencil},
    {"PROGRAM_POINT_SIZE", "'PointSizeMode 1' lets the vertex shader set gl_PointSize"},
    {"VERTEX_PROGRAM_POINT_SIZE", "'PointSizeMode 1' lets the vertex shader set gl_PointSize"},
    {"MULTISAMPLE", "--samples N draws with N samples a pixel"},
    {"LINE_SMOOTH", "--samples N draws with N samples a pixel"},
    {"ALPHA_TEST", "write discard in the fragment shader"},
});

// Words of OpenGL without gl, glu or glut before them, and without the letters of types behind them.
constexpr auto words = std::to_array<Entry>({
    {"BlendFunc", "'Blend src dst' sets the factors, as in 'Blend src_alpha one_minus_src_alpha'; 'Blend off' ends it"},
    {"ShadeModel", "'Flat' or 'Smooth' does it"},
    {"Light", no_lights},
    {"LightModel", no_lights},
    {"Lighting", no_lights},
    {"PointLight", no_lights},
    {"SpotLight", no_lights},
    {"Material", no_materials},
    {"ColorMaterial", no_materials},
    {"Fog", "there is no fog but that of shaders: mix(color, fogColor, …) in the fragment shader"},
    {"DepthFunc", "write 'DepthTest on' if nearer surfaces hide farther ones, otherwise 'DepthTest off'"},
    {"DepthMask", "'DepthWrite on' or 'DepthWrite off' does it"},
    {"FrontFace", culling},
    {"PolygonMode", "'Wireframe on' draws only the edges of triangles"},
    {"AlphaFunc", "write discard in the fragment shader"},
    {"StencilFunc", stencil},
    {"StencilOp", stencil},
    {"LoadIdentity", "there is no such command: 'PushMatrix' saves a transformation, and 'PopMatrix' restores it"},
    {"LoadMatrix", "there is no such command: 'Translate', 'Rotate' and 'Scale' make transformations"},
    {"MultMatrix", "there is no such command: 'Translate', 'Rotate' and 'Scale' make transformations"},
    {"MatrixMode", "it is not needed: 'Perspective' and 'Ortho' set the projection, all others the model"},
    {"Ortho2D", "'Ortho xl xr yb yt' does it"},
    {"Frustum", "'Perspective fov' does it, with the vertical field of view in degrees"},
    {"Viewport", "'WindowSize wx wy' does it"},
    {"InitWindowSize", "'WindowSize wx wy' does it"},
    {"ReshapeWindow", "'WindowSize wx wy' does it"},
    {"ClearColor", "'Background r g b' does it"},
    {"TexParameter",
     "'Filter linear', 'Filter nearest' or 'Filter mipmap' before the texture; 'Clamp' after the Program"},
    {"TexEnv", textures},
    {"TexImage1D", textures},
    {"TexImage2D", textures},
    {"TexImage3D", textures},
    {"BindTexture", textures},
    {"ActiveTexture", textures},
    {"MultiTexCoord", "'glTexCoord s t p' does it"},
    {"UseProgram", "'Program name' does it, after 'Vertex' and 'Fragment'"},
    {"Uniform", "uniforms are given by a Program statement: Program Name uniform value"},
    {"SolidTeapot", "'Teapot' does it"},
    {"SolidSphere", "'Sphere radius slices stacks' does it"},
    {"SolidTorus", "'Torus outer inner sides rings' does it"},
    {"SolidCone", "'Cone radius height' does it"},
    {"SolidCube", "'Box dx dy dz' does it"},
    {"Disk", "'DiskXY z radius' does it"},
    {"Quad", "'QuadXY z size', 'QuadXZ y size' or 'QuadYZ x size' draws a square"},
    {"Flush", "it is not needed"},
    {"Finish", "it is not needed"},
    {"SwapBuffers", "it is not needed"},
    {"PostRedisplay", "it is not needed"},
    {"Hint", "it is not needed"},
});

template <std::size_t N>
std::string_view find(const std::array<Entry, N>& entries, std::string_view word) {
    const auto same = ranges::find_if(entries, [&](const Entry& entry) { return same_word(entry.first, word); });
    return same == entries.end() ? std::string_view() : same->second;
}

std::string_view without_start(std::string_view word, std::string_view start) {
    return word.size() > start.size() && same_word(word.substr(0, start.size()), start) ? word.substr(start.size())
                                                                                        : word;
}

// Returns "Color" for "Color3fv": the rest states the number and type of arguments.
std::string_view without_types(std::string_view word) {
    const std::string_view whole = word;
    if (word.size() > 2 && lower(word.back()) == 'v') word.remove_suffix(1);
    const char type = word.empty() ? ' ' : lower(word.back());
    const bool digit_before = word.size() > 2 && word[word.size() - 2] >= '1' && word[word.size() - 2] <= '4';
    if (type != 'f' && type != 'd' && type != 'i' && !(digit_before && type == 's')) return whole;
    word.remove_suffix(digit_before ? 2 : 1);
    return word;
}

std::string help_for_capability(std::string_view argument, bool on) {
    argument = without_start(argument, "GL_");
    if (const std::string_view command = find(capabilities, argument); !command.empty())
        return "'" + std::string(command) + (on ? " on" : " off") + "' does it";
    if (!on && same_word(argument, "CULL_FACE")) return "'CullFace none' does it";
    if (const std::string_view other = find(other_capabilities, argument); !other.empty()) return std::string(other);
    return "'Blend', 'DepthTest' and 'DepthWrite' take on or off; 'CullFace' takes none, back or front";
}

}  // namespace

std::string help_for_opengl(std::string_view word, std::string_view argument) {
    const std::string_view bare = without_start(word, "gl");
    for (const std::string_view name : {bare, without_start(bare, "ut"), without_start(bare, "u")}) {
        if (same_word(name, "Enable")) return help_for_capability(argument, true);
        if (same_word(name, "Disable")) return help_for_capability(argument, false);
        for (const std::string_view form : {name, without_types(name)})
            if (const std::string_view help = find(words, form); !help.empty()) return std::string(help);
        if (bare == word) break;
    }
    // The language has the commands of glTranslatef, gluLookAt and glColor3f by their plain names.
    for (const std::string_view name : {without_types(word), bare, without_types(bare), without_start(bare, "u")})
        if (const Command* command = name == word ? nullptr : find_command(name); command != nullptr) {
            std::string usage(command->name);
            if (!command->signature.text.empty()) usage += " " + std::string(command->signature.text);
            return "'" + usage + "' does it";
        }
    return {};
}

}  // namespace snell
