#include "parser/commands/elsewhere.h"

#include <array>
#include <utility>

#include "parser/commands/commands.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {
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
