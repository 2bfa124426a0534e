// The functions, variables and types that GLSL offers, for hints.
#include <algorithm>

#include "parser/text/words.h"
#include "src/glsl/log/log.h"
#include "src/glsl/read/words.h"

namespace snell::glsl::log {
namespace {

constexpr std::string_view others =
    "texture1D texture2D texture3D textureCube gl_Vertex gl_Normal gl_Color gl_MultiTexCoord0 gl_Position "
    "gl_PointSize gl_FragColor gl_FragData gl_FragCoord gl_FragDepth gl_FrontFacing gl_FrontColor gl_BackColor "
    "gl_TexCoord gl_ModelViewMatrix gl_ProjectionMatrix gl_ModelViewProjectionMatrix gl_NormalMatrix gl_TextureMatrix "
    "gl_ModelViewMatrixInverse gl_LightSource gl_FrontMaterial gl_Fog gl_PositionIn gl_in gl_InvocationID "
    "gl_TessCoord gl_TessLevelOuter gl_TessLevelInner gl_VertexID gl_InstanceID gl_PrimitiveID gl_PointCoord float "
    "int bool vec2 vec3 vec4 mat2 mat3 mat4 sampler2D sampler3D samplerCube";

}  // namespace

std::string_view builtin_parameters(std::string_view name) {
    const BuiltinFunction* function = builtin_function(name);
    if (!function || function->parameters.empty()) return {};
    const auto commas = std::count(function->parameters.begin(), function->parameters.end(), ',');
    for (const std::string_view overload : split(function->signatures))  // R:AA; a bracket makes it longer
        if (static_cast<std::ptrdiff_t>(overload.size()) != commas + 3) return {};
    return function->parameters;
}

const std::vector<std::string_view>& builtin_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all = split(others);
        for (const BuiltinFunction& f : builtin_functions()) all.push_back(f.name);
        return all;
    }();
    return names;
}

}  // namespace snell::glsl::log
