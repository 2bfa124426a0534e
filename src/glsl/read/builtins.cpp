// The built-in functions: their signatures, as far as the typing of expressions needs them, their parameters, and what
// they do.
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
// clang-format off
constexpr BuiltinFunction functions[] = {
    {"radians", "F:F", "degrees", "Converts degrees to radians."},
    {"degrees", "F:F", "radians", "Converts radians to degrees."},
    {"sin", "F:F", "angle", "Sine of an angle in radians."},
    {"cos", "F:F", "angle", "Cosine of an angle in radians."},
    {"tan", "F:F", "angle", "Tangent of an angle in radians."},
    {"asin", "F:F", "x", "Angle whose sine is x, from -π/2 to π/2. Undefined if |x| > 1."},
    {"acos", "F:F", "x", "Angle whose cosine is x, from 0 to π. Undefined if |x| > 1."},
    {"atan", "F:FF F:F", "y, x", "Angle whose tangent is y / x. With two arguments their signs choose the quadrant: -π to π."},
    {"sinh", "F:F", "x", "Hyperbolic sine."},
    {"cosh", "F:F", "x", "Hyperbolic cosine."},
    {"tanh", "F:F", "x", "Hyperbolic tangent."},
    {"asinh", "F:F", "x", "Inverse of sinh."},
    {"acosh", "F:F", "x", "Inverse of cosh. Undefined if x < 1."},
    {"atanh", "F:F", "x", "Inverse of tanh. Undefined if |x| >= 1."},
    {"pow", "F:FF", "x, y", "x raised to the power y. Undefined if x < 0, or if x is 0 and y <= 0."},
    {"exp", "F:F", "x", "e raised to the power x."},
    {"log", "F:F", "x", "Natural logarithm. Undefined if x <= 0."},
    {"exp2", "F:F", "x", "2 raised to the power x."},
    {"log2", "F:F", "x", "Logarithm to the base 2. Undefined if x <= 0."},
    {"sqrt", "F:F", "x", "Square root. Undefined if x < 0."},
    {"inversesqrt", "F:F", "x", "1 / sqrt(x). Undefined if x <= 0."},
    {"abs", "F:F I:I", "x", "Absolute value."},
    {"sign", "F:F I:I", "x", "-1, 0 or 1, the sign of x."},
    {"floor", "F:F", "x", "Largest whole number that is not above x."},
    {"trunc", "F:F", "x", "x without its fraction."},
    {"round", "F:F", "x", "Nearest whole number; the driver chooses the direction of halves."},
    {"roundEven", "F:F", "x", "Nearest whole number; halves go to the even one."},
    {"ceil", "F:F", "x", "Smallest whole number that is not below x."},
    {"fract", "F:F", "x", "x - floor(x)."},
    {"mod", "F:FF F:Ff", "x, y", "x - y * floor(x / y)."},
    {"modf", "F:FF", "x, whole", "Fraction of x; `whole` receives its whole part."},
    {"min", "F:FF F:Ff I:II I:Ii U:UU U:Uu", "a, b", "The smaller value."},
    {"max", "F:FF F:Ff I:II I:Ii U:UU U:Uu", "a, b", "The larger value."},
    {"clamp", "F:FFF F:Fff I:III I:Iii U:UUU U:Uuu", "x, low, high", "x, but at least `low` and at most `high`. Undefined if low > high."},
    {"mix", "F:FFF F:FFf F:FFB I:IIB U:UUB B:BBB", "a, b, t", "a * (1 - t) + b * t. With a `bool` t: b where it is true, otherwise a."},
    {"step", "F:FF F:fF", "edge, x", "0 if x < edge, otherwise 1."},
    {"smoothstep", "F:FFF F:ffF", "edge0, edge1, x", "0 below edge0, 1 above edge1, a smooth cubic between. Undefined if edge0 >= edge1."},
    {"isnan", "B:F", "x", "True where x is not a number."},
    {"isinf", "B:F", "x", "True where x is infinite."},
    {"floatBitsToInt", "I:F", "x", "The bits of x, read as an int."},
    {"floatBitsToUint", "U:F", "x", "The bits of x, read as a uint."},
    {"intBitsToFloat", "F:I", "x", "The bits of x, read as a float."},
    {"uintBitsToFloat", "F:U", "x", "The bits of x, read as a float."},
    {"fma", "F:FFF", "a, b, c", "a * b + c, rounded once where the driver can."},
    {"frexp", "F:FI", "x, exponent", "Significand of x from .5 to 1; `exponent` receives its power of two."},
    {"ldexp", "F:FI", "x, exponent", "x * 2^exponent."},
    {"length", "f:F", "v", "Length of the vector."},
    {"distance", "f:FF", "a, b", "Length of a - b."},
    {"dot", "f:FF", "a, b", "Scalar product. For unit vectors: the cosine of the angle between them."},
    {"cross", "3:33", "a, b", "Vector product: perpendicular to both, right-handed."},
    {"normalize", "F:F", "v", "Vector of unit length in the direction of v. Undefined for the zero vector."},
    {"faceforward", "F:FFF", "N, I, Nref", "N if dot(Nref, I) < 0, otherwise -N."},
    {"reflect", "F:FF", "I, N", "Direction of I after reflection at a surface with the normal N, which must have unit length."},
    {"refract", "F:FFf", "I, N, eta", "Direction of I after refraction. `eta` is the index of refraction before the surface divided by that behind it; I and N must have unit length. The zero vector at total reflection."},
    {"matrixCompMult", "X:MM", "a, b", "Product component by component."},
    {"outerProduct", "X:CC", "a, b", "Matrix of a as a column times b as a row."},
    {"transpose", "X:M", "m", "Transposed matrix."},
    {"determinant", "f:M", "m", "Determinant."},
    {"inverse", "X:M", "m", "Inverse matrix. Undefined if the determinant is 0."},
    {"lessThan", "B:FF B:II B:UU", "a, b", "a < b, component by component."},
    {"lessThanEqual", "B:FF B:II B:UU", "a, b", "a <= b, component by component."},
    {"greaterThan", "B:FF B:II B:UU", "a, b", "a > b, component by component."},
    {"greaterThanEqual", "B:FF B:II B:UU", "a, b", "a >= b, component by component."},
    {"equal", "B:FF B:II B:UU B:BB", "a, b", "a == b, component by component."},
    {"notEqual", "B:FF B:II B:UU B:BB", "a, b", "a != b, component by component."},
    {"any", "b:B", "b", "True if any component is true."},
    {"all", "b:B", "b", "True if all components are true."},
    {"not", "B:B", "b", "Logical complement, component by component."},
    {"dFdx", "F:F", "p", "Change of p to the next pixel on the right. In fragment shaders, outside of branches."},
    {"dFdy", "F:F", "p", "Change of p to the next pixel above. In fragment shaders, outside of branches."},
    {"fwidth", "F:F", "p", "abs(dFdx(p)) + abs(dFdy(p)): the width of a pixel in units of p."},
    {"dFdxFine", "F:F", "p", "dFdx from the nearest pixels."},
    {"dFdyFine", "F:F", "p", "dFdy from the nearest pixels."},
    {"dFdxCoarse", "F:F", "p", "dFdx that may be shared by four pixels."},
    {"dFdyCoarse", "F:F", "p", "dFdy that may be shared by four pixels."},
    {"bitfieldExtract", "I:Iii U:Uii", "value, offset, bits", "The bits from `offset` on."},
    {"bitfieldInsert", "I:IIii U:UUii", "base, insert, offset, bits", "base with these bits replaced."},
    {"bitfieldReverse", "I:I U:U", "value", "The bits in reverse order."},
    {"bitCount", "I:I I:U", "value", "Number of bits that are 1."},
    {"findLSB", "I:I I:U", "value", "Number of the lowest bit that is 1; -1 if there is none."},
    {"findMSB", "I:I I:U", "value", "Number of the highest significant bit; -1 if there is none."},
    {"texture", "T:SC[f", "image, coordinates, bias", "Looks up a texel, filtered, at these texture coordinates. `bias` is added to the level of detail, in fragment shaders."},
    {"textureProj", "T:SC[f", "image, coordinates, bias", "As texture, at the coordinates divided by their last component."},
    {"textureLod", "T:SCf", "image, coordinates, lod", "As texture, from this level of detail."},
    {"textureProjLod", "T:SCf", "image, coordinates, lod", "As textureProj, from this level of detail."},
    {"textureGrad", "T:SCCC", "image, coordinates, dx, dy", "As texture, with these changes of the coordinates to the next pixels."},
    {"textureProjGrad", "T:SCCC", "image, coordinates, dx, dy", "As textureProj, with these changes of the coordinates."},
    {"textureOffset", "T:SCJ[f", "image, coordinates, offset, bias", "As texture, displaced by a constant number of texels."},
    {"textureLodOffset", "T:SCfJ", "image, coordinates, lod, offset", "As textureLod, displaced by a constant number of texels."},
    {"textureGather", "4:SC[i", "image, coordinates, component", "One component of the four texels that texture would filter."},
    {"texelFetch", "T:SJ[i", "image, texel, lod", "One texel by its number, without filtering."},
    {"texelFetchOffset", "T:SJiJ", "image, texel, lod, offset", "As texelFetch, displaced by a constant number of texels."},
    {"textureSize", "Z:S[i", "image, lod", "Size of a level of detail, in texels."},
    {"textureQueryLod", "2:SC", "image, coordinates", "The level of detail that texture would use."},
    {"textureQueryLevels", "i:S", "image", "Number of levels of detail."},
    {"imageLoad", "T:SJ", "image, texel", "Reads a texel of an image."},
    {"imageStore", "X:SJX", "image, texel, value", "Writes a texel of an image."},
    {"imageSize", "Z:S", "image", "Size of an image, in texels."},
    {"interpolateAtCentroid", "F:F", "input", "The fragment's input at a place that the primitive covers."},
    {"interpolateAtSample", "F:Fi", "input, sample", "The fragment's input at a sample."},
    {"interpolateAtOffset", "F:F2", "input, offset", "The fragment's input, displaced in pixels."},
    {"noise1", "f:F", "p", "Noise of one component. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"noise2", "2:F", "p", "Noise of two components. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"noise3", "3:F", "p", "Noise of three components. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"noise4", "4:F", "p", "Noise of four components. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"ftransform", "4:", "", "gl_ModelViewProjectionMatrix * gl_Vertex. In vertex shaders."},
    {"EmitVertex", "X:", "", "Emits a vertex with the current outputs. In geometry shaders."},
    {"EndPrimitive", "X:", "", "Ends the strip; the next vertex begins another one. In geometry shaders."},
    {"EmitStreamVertex", "X:i", "stream", "As EmitVertex, to a stream."},
    {"EndStreamPrimitive", "X:i", "stream", "As EndPrimitive, of a stream."},
    {"barrier", "X:", "", "Waits for the other invocations of the patch. In tessellation control shaders."},
    {"memoryBarrier", "X:", "", "Orders the writes to memory before those after it."},
    {"packUnorm2x16", "u:2", "v", "Two numbers from 0 to 1 as 16 bits each."},
    {"unpackUnorm2x16", "2:u", "bits", "Inverse of packUnorm2x16."},
    {"packUnorm4x8", "u:4", "v", "Four numbers from 0 to 1 as 8 bits each."},
    {"unpackUnorm4x8", "4:u", "bits", "Inverse of packUnorm4x8."},
    {"packHalf2x16", "u:2", "v", "Two half floats."},
    {"unpackHalf2x16", "2:u", "bits", "Inverse of packHalf2x16."},
    {"imageAtomicAdd", "X:SJX", "image, texel, value", "Adds to a texel and returns what it was."},
    {"atomicCounterIncrement", "u:S", "counter", "Increments the counter and returns what it was."},
    {"atomicCounterDecrement", "u:S", "counter", "Decrements the counter and returns what it is then."},
    {"atomicCounter", "u:S", "counter", "Value of the counter."},
};
// clang-format on

}  // namespace

std::span<const BuiltinFunction> builtin_functions() { return functions; }

const BuiltinFunction* builtin_function(std::string_view name) {
    static const std::unordered_map<std::string_view, const BuiltinFunction*> table = [] {
        std::unordered_map<std::string_view, const BuiltinFunction*> t;
        for (const BuiltinFunction& f : functions) t.emplace(f.name, &f);
        return t;
    }();
    const auto it = table.find(name);
    return it == table.end() ? nullptr : it->second;
}

std::string_view builtin_signatures(std::string_view name) {
    const BuiltinFunction* f = builtin_function(name);
    return f ? f->signatures : std::string_view();
}

}  // namespace snell::glsl
