// The functions and variables that GLSL offers, for hints.
#include <array>

#include "src/glsl/log/log.h"

namespace snell::glsl::log {
namespace {

struct Function {
    std::string_view name, parameters;
};

constexpr auto functions = std::to_array<Function>({
    {"abs", "x"},
    {"acos", "x"},
    {"acosh", "x"},
    {"all", "b"},
    {"any", "b"},
    {"asin", "x"},
    {"asinh", "x"},
    {"atanh", "x"},
    {"ceil", "x"},
    {"clamp", "x, low, high"},
    {"cos", "x"},
    {"cosh", "x"},
    {"cross", "a, b"},
    {"dFdx", "p"},
    {"dFdy", "p"},
    {"degrees", "radians"},
    {"determinant", "m"},
    {"distance", "a, b"},
    {"dot", "a, b"},
    {"equal", "a, b"},
    {"exp", "x"},
    {"exp2", "x"},
    {"faceforward", "N, I, Nref"},
    {"floor", "x"},
    {"fract", "x"},
    {"fwidth", "p"},
    {"greaterThan", "a, b"},
    {"greaterThanEqual", "a, b"},
    {"inverse", "m"},
    {"inversesqrt", "x"},
    {"length", "v"},
    {"lessThan", "a, b"},
    {"lessThanEqual", "a, b"},
    {"log", "x"},
    {"log2", "x"},
    {"matrixCompMult", "a, b"},
    {"max", "a, b"},
    {"min", "a, b"},
    {"mix", "a, b, t"},
    {"mod", "x, y"},
    {"noise1", "p"},
    {"noise2", "p"},
    {"noise3", "p"},
    {"noise4", "p"},
    {"normalize", "v"},
    {"notEqual", "a, b"},
    {"outerProduct", "a, b"},
    {"pow", "x, y"},
    {"radians", "degrees"},
    {"reflect", "I, N"},
    {"refract", "I, N, eta"},
    {"round", "x"},
    {"sign", "x"},
    {"sin", "x"},
    {"sinh", "x"},
    {"smoothstep", "edge0, edge1, x"},
    {"sqrt", "x"},
    {"step", "edge, x"},
    {"tan", "x"},
    {"tanh", "x"},
    {"transpose", "m"},
    {"trunc", "x"},
});

constexpr auto others = std::to_array<std::string_view>({
    "atan",
    "texture",
    "texture1D",
    "texture2D",
    "texture3D",
    "textureCube",
    "textureLod",
    "textureProj",
    "textureSize",
    "texelFetch",
    "ftransform",
    "EmitVertex",
    "EndPrimitive",
    "gl_Vertex",
    "gl_Normal",
    "gl_Color",
    "gl_MultiTexCoord0",
    "gl_Position",
    "gl_PointSize",
    "gl_FragColor",
    "gl_FragData",
    "gl_FragCoord",
    "gl_FragDepth",
    "gl_FrontFacing",
    "gl_FrontColor",
    "gl_BackColor",
    "gl_TexCoord",
    "gl_ModelViewMatrix",
    "gl_ProjectionMatrix",
    "gl_ModelViewProjectionMatrix",
    "gl_NormalMatrix",
    "gl_TextureMatrix",
    "gl_ModelViewMatrixInverse",
    "gl_LightSource",
    "gl_FrontMaterial",
    "gl_Fog",
    "gl_PositionIn",
    "gl_in",
    "gl_InvocationID",
    "gl_TessCoord",
    "gl_TessLevelOuter",
    "gl_TessLevelInner",
    "gl_VertexID",
    "gl_InstanceID",
    "gl_PrimitiveID",
    "gl_PointCoord",
    "float",
    "int",
    "bool",
    "vec2",
    "vec3",
    "vec4",
    "mat2",
    "mat3",
    "mat4",
    "sampler2D",
    "sampler3D",
    "samplerCube",
});

}  // namespace

std::string_view builtin_parameters(std::string_view function) {
    for (const Function& f : functions)
        if (f.name == function) return f.parameters;
    return {};
}

const std::vector<std::string_view>& builtin_names() {
    static const std::vector<std::string_view> names = [] {
        std::vector<std::string_view> all(others.begin(), others.end());
        for (const Function& f : functions) all.push_back(f.name);
        return all;
    }();
    return names;
}

}  // namespace snell::glsl::log
