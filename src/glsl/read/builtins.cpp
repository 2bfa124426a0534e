// The built-in functions: their signatures, as far as the typing of expressions needs them, and their parameters, for
// hints.
#include <string_view>
#include <unordered_map>

#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

// One overload is RESULT:PARAMETERS, one character each; overloads are tried in order.
//   F I U B   float, int, uint, bool or a vector of them; all capitals of one overload have the same size
//   f i u b   scalars            3 vec3    4 vec4    2 vec2   n ivec2   m ivec3
//   M         any matrix         S any sampler or image
//   C         coordinates: any floating type      J integer coordinates of any size
//   T         what the sampler gives (vec4, ivec4, uvec4, or float for shadow samplers)
//   Z         the size of a texture: int, ivec2 or ivec3, by the sampler's dimensions
//   X         the same size as the arguments, float for matrices: left to special rules; unknown type
// A parameter in brackets may be left out from there on: "T:SC[f".
constexpr BuiltinFunction functions[] = {
    {"radians", "F:F", "degrees"},
    {"degrees", "F:F", "radians"},
    {"sin", "F:F", "x"},
    {"cos", "F:F", "x"},
    {"tan", "F:F", "x"},
    {"asin", "F:F", "x"},
    {"acos", "F:F", "x"},
    {"atan", "F:FF F:F"},
    {"sinh", "F:F", "x"},
    {"cosh", "F:F", "x"},
    {"tanh", "F:F", "x"},
    {"asinh", "F:F", "x"},
    {"acosh", "F:F", "x"},
    {"atanh", "F:F", "x"},
    {"pow", "F:FF", "x, y"},
    {"exp", "F:F", "x"},
    {"log", "F:F", "x"},
    {"exp2", "F:F", "x"},
    {"log2", "F:F", "x"},
    {"sqrt", "F:F", "x"},
    {"inversesqrt", "F:F", "x"},
    {"abs", "F:F I:I", "x"},
    {"sign", "F:F I:I", "x"},
    {"floor", "F:F", "x"},
    {"trunc", "F:F", "x"},
    {"round", "F:F", "x"},
    {"roundEven", "F:F"},
    {"ceil", "F:F", "x"},
    {"fract", "F:F", "x"},
    {"mod", "F:FF F:Ff", "x, y"},
    {"modf", "F:FF"},
    {"min", "F:FF F:Ff I:II I:Ii U:UU U:Uu", "a, b"},
    {"max", "F:FF F:Ff I:II I:Ii U:UU U:Uu", "a, b"},
    {"clamp", "F:FFF F:Fff I:III I:Iii U:UUU U:Uuu", "x, low, high"},
    {"mix", "F:FFF F:FFf F:FFB I:IIB U:UUB B:BBB", "a, b, t"},
    {"step", "F:FF F:fF", "edge, x"},
    {"smoothstep", "F:FFF F:ffF", "edge0, edge1, x"},
    {"isnan", "B:F"},
    {"isinf", "B:F"},
    {"floatBitsToInt", "I:F"},
    {"floatBitsToUint", "U:F"},
    {"intBitsToFloat", "F:I"},
    {"uintBitsToFloat", "F:U"},
    {"fma", "F:FFF"},
    {"frexp", "F:FI"},
    {"ldexp", "F:FI"},
    {"length", "f:F", "v"},
    {"distance", "f:FF", "a, b"},
    {"dot", "f:FF", "a, b"},
    {"cross", "3:33", "a, b"},
    {"normalize", "F:F", "v"},
    {"faceforward", "F:FFF", "N, I, Nref"},
    {"reflect", "F:FF", "I, N"},
    {"refract", "F:FFf", "I, N, eta"},
    {"matrixCompMult", "X:MM", "a, b"},
    {"outerProduct", "X:CC", "a, b"},
    {"transpose", "X:M", "m"},
    {"determinant", "f:M", "m"},
    {"inverse", "X:M", "m"},
    {"lessThan", "B:FF B:II B:UU", "a, b"},
    {"lessThanEqual", "B:FF B:II B:UU", "a, b"},
    {"greaterThan", "B:FF B:II B:UU", "a, b"},
    {"greaterThanEqual", "B:FF B:II B:UU", "a, b"},
    {"equal", "B:FF B:II B:UU B:BB", "a, b"},
    {"notEqual", "B:FF B:II B:UU B:BB", "a, b"},
    {"any", "b:B", "b"},
    {"all", "b:B", "b"},
    {"not", "B:B"},
    {"dFdx", "F:F", "p"},
    {"dFdy", "F:F", "p"},
    {"fwidth", "F:F", "p"},
    {"dFdxFine", "F:F"},
    {"dFdyFine", "F:F"},
    {"dFdxCoarse", "F:F"},
    {"dFdyCoarse", "F:F"},
    {"bitfieldExtract", "I:Iii U:Uii"},
    {"bitfieldInsert", "I:IIii U:UUii"},
    {"bitfieldReverse", "I:I U:U"},
    {"bitCount", "I:I I:U"},
    {"findLSB", "I:I I:U"},
    {"findMSB", "I:I I:U"},
    {"texture", "T:SC[f"},
    {"textureProj", "T:SC[f"},
    {"textureLod", "T:SCf"},
    {"textureProjLod", "T:SCf"},
    {"textureGrad", "T:SCCC"},
    {"textureProjGrad", "T:SCCC"},
    {"textureOffset", "T:SCJ[f"},
    {"textureLodOffset", "T:SCfJ"},
    {"textureGather", "4:SC[i"},
    {"texelFetch", "T:SJ[i"},
    {"texelFetchOffset", "T:SJiJ"},
    {"textureSize", "Z:S[i"},
    {"textureQueryLod", "2:SC"},
    {"textureQueryLevels", "i:S"},
    {"imageLoad", "T:SJ"},
    {"imageStore", "X:SJX"},
    {"imageSize", "Z:S"},
    {"interpolateAtCentroid", "F:F"},
    {"interpolateAtSample", "F:Fi"},
    {"interpolateAtOffset", "F:F2"},
    {"noise1", "f:F", "p"},
    {"noise2", "2:F", "p"},
    {"noise3", "3:F", "p"},
    {"noise4", "4:F", "p"},
    {"ftransform", "4:"},
    {"EmitVertex", "X:"},
    {"EndPrimitive", "X:"},
    {"EmitStreamVertex", "X:i"},
    {"EndStreamPrimitive", "X:i"},
    {"barrier", "X:"},
    {"memoryBarrier", "X:"},
    {"packUnorm2x16", "u:2"},
    {"unpackUnorm2x16", "2:u"},
    {"packUnorm4x8", "u:4"},
    {"unpackUnorm4x8", "4:u"},
    {"packHalf2x16", "u:2"},
    {"unpackHalf2x16", "2:u"},
    {"imageAtomicAdd", "X:SJX"},
    {"atomicCounterIncrement", "u:S"},
    {"atomicCounterDecrement", "u:S"},
    {"atomicCounter", "u:S"},
};

}  // namespace

std::span<const BuiltinFunction> builtin_functions() { return functions; }

std::string_view builtin_signatures(std::string_view name) {
    static const std::unordered_map<std::string_view, std::string_view> table = [] {
        std::unordered_map<std::string_view, std::string_view> t;
        for (const BuiltinFunction& f : functions) t.emplace(f.name, f.signatures);
        return t;
    }();
    const auto it = table.find(name);
    return it == table.end() ? std::string_view() : it->second;
}

}  // namespace snell::glsl
