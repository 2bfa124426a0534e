// Signatures of the built-in functions, as far as the typing of expressions needs them.
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
struct Entry {
    std::string_view name, signatures;
};
constexpr Entry entries[] = {
    {"radians", "F:F"},
    {"degrees", "F:F"},
    {"sin", "F:F"},
    {"cos", "F:F"},
    {"tan", "F:F"},
    {"asin", "F:F"},
    {"acos", "F:F"},
    {"atan", "F:FF F:F"},
    {"sinh", "F:F"},
    {"cosh", "F:F"},
    {"tanh", "F:F"},
    {"asinh", "F:F"},
    {"acosh", "F:F"},
    {"atanh", "F:F"},
    {"pow", "F:FF"},
    {"exp", "F:F"},
    {"log", "F:F"},
    {"exp2", "F:F"},
    {"log2", "F:F"},
    {"sqrt", "F:F"},
    {"inversesqrt", "F:F"},
    {"abs", "F:F I:I"},
    {"sign", "F:F I:I"},
    {"floor", "F:F"},
    {"trunc", "F:F"},
    {"round", "F:F"},
    {"roundEven", "F:F"},
    {"ceil", "F:F"},
    {"fract", "F:F"},
    {"mod", "F:FF F:Ff"},
    {"modf", "F:FF"},
    {"min", "F:FF F:Ff I:II I:Ii U:UU U:Uu"},
    {"max", "F:FF F:Ff I:II I:Ii U:UU U:Uu"},
    {"clamp", "F:FFF F:Fff I:III I:Iii U:UUU U:Uuu"},
    {"mix", "F:FFF F:FFf F:FFB I:IIB U:UUB B:BBB"},
    {"step", "F:FF F:fF"},
    {"smoothstep", "F:FFF F:ffF"},
    {"isnan", "B:F"},
    {"isinf", "B:F"},
    {"floatBitsToInt", "I:F"},
    {"floatBitsToUint", "U:F"},
    {"intBitsToFloat", "F:I"},
    {"uintBitsToFloat", "F:U"},
    {"fma", "F:FFF"},
    {"frexp", "F:FI"},
    {"ldexp", "F:FI"},
    {"length", "f:F"},
    {"distance", "f:FF"},
    {"dot", "f:FF"},
    {"cross", "3:33"},
    {"normalize", "F:F"},
    {"faceforward", "F:FFF"},
    {"reflect", "F:FF"},
    {"refract", "F:FFf"},
    {"matrixCompMult", "X:MM"},
    {"outerProduct", "X:CC"},
    {"transpose", "X:M"},
    {"determinant", "f:M"},
    {"inverse", "X:M"},
    {"lessThan", "B:FF B:II B:UU"},
    {"lessThanEqual", "B:FF B:II B:UU"},
    {"greaterThan", "B:FF B:II B:UU"},
    {"greaterThanEqual", "B:FF B:II B:UU"},
    {"equal", "B:FF B:II B:UU B:BB"},
    {"notEqual", "B:FF B:II B:UU B:BB"},
    {"any", "b:B"},
    {"all", "b:B"},
    {"not", "B:B"},
    {"dFdx", "F:F"},
    {"dFdy", "F:F"},
    {"fwidth", "F:F"},
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
    {"noise1", "f:F"},
    {"noise2", "2:F"},
    {"noise3", "3:F"},
    {"noise4", "4:F"},
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

std::string_view builtin_signatures(std::string_view name) {
    static const std::unordered_map<std::string_view, std::string_view> table = [] {
        std::unordered_map<std::string_view, std::string_view> t;
        for (const Entry& e : entries) t.emplace(e.name, e.signatures);
        return t;
    }();
    const auto it = table.find(name);
    return it == table.end() ? std::string_view() : it->second;
}

}  // namespace snell::glsl
