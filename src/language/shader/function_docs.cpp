// The functions of GLSL: their parameters and what they do.
#include <unordered_map>

#include "parser/text/words.h"
#include "src/glsl/read/words.h"
#include "src/language/shader/builtins.h"

namespace snell::language {

namespace {

// clang-format off
constexpr FunctionDoc docs[] = {
    {"radians", "degrees", "Converts degrees to radians."},
    {"degrees", "radians", "Converts radians to degrees."},
    {"sin", "angle", "Sine of an angle in radians."},
    {"cos", "angle", "Cosine of an angle in radians."},
    {"tan", "angle", "Tangent of an angle in radians."},
    {"asin", "x", "Angle whose sine is x, from -π/2 to π/2. Undefined if |x| > 1."},
    {"acos", "x", "Angle whose cosine is x, from 0 to π. Undefined if |x| > 1."},
    {"atan", "y, x", "Angle whose tangent is y / x. With two arguments their signs choose the quadrant: -π to π."},
    {"sinh", "x", "Hyperbolic sine."},
    {"cosh", "x", "Hyperbolic cosine."},
    {"tanh", "x", "Hyperbolic tangent."},
    {"asinh", "x", "Inverse of sinh."},
    {"acosh", "x", "Inverse of cosh. Undefined if x < 1."},
    {"atanh", "x", "Inverse of tanh. Undefined if |x| >= 1."},
    {"pow", "x, y", "x raised to the power y. Undefined if x < 0, or if x is 0 and y <= 0."},
    {"exp", "x", "e raised to the power x."},
    {"log", "x", "Natural logarithm. Undefined if x <= 0."},
    {"exp2", "x", "2 raised to the power x."},
    {"log2", "x", "Logarithm to the base 2. Undefined if x <= 0."},
    {"sqrt", "x", "Square root. Undefined if x < 0."},
    {"inversesqrt", "x", "1 / sqrt(x). Undefined if x <= 0."},
    {"abs", "x", "Absolute value."},
    {"sign", "x", "-1, 0 or 1, the sign of x."},
    {"floor", "x", "Largest whole number that is not above x."},
    {"trunc", "x", "x without its fraction."},
    {"round", "x", "Nearest whole number; the driver chooses the direction of halves."},
    {"roundEven", "x", "Nearest whole number; halves go to the even one."},
    {"ceil", "x", "Smallest whole number that is not below x."},
    {"fract", "x", "x - floor(x)."},
    {"mod", "x, y", "x - y * floor(x / y)."},
    {"modf", "x, whole", "Fraction of x; `whole` receives its whole part."},
    {"min", "a, b", "The smaller value."},
    {"max", "a, b", "The larger value."},
    {"clamp", "x, low, high", "x, but at least `low` and at most `high`. Undefined if low > high."},
    {"mix", "a, b, t", "a * (1 - t) + b * t. With a `bool` t: b where it is true, otherwise a."},
    {"step", "edge, x", "0 if x < edge, otherwise 1."},
    {"smoothstep", "edge0, edge1, x", "0 below edge0, 1 above edge1, a smooth cubic between. Undefined if edge0 >= edge1."},
    {"isnan", "x", "True where x is not a number."},
    {"isinf", "x", "True where x is infinite."},
    {"floatBitsToInt", "x", "The bits of x, read as an int."},
    {"floatBitsToUint", "x", "The bits of x, read as a uint."},
    {"intBitsToFloat", "x", "The bits of x, read as a float."},
    {"uintBitsToFloat", "x", "The bits of x, read as a float."},
    {"fma", "a, b, c", "a * b + c, rounded once where the driver can."},
    {"frexp", "x, exponent", "Significand of x from .5 to 1; `exponent` receives its power of two."},
    {"ldexp", "x, exponent", "x * 2^exponent."},
    {"length", "v", "Length of the vector."},
    {"distance", "a, b", "Length of a - b."},
    {"dot", "a, b", "Scalar product. For unit vectors: the cosine of the angle between them."},
    {"cross", "a, b", "Vector product: perpendicular to both, right-handed."},
    {"normalize", "v", "Vector of unit length in the direction of v. Undefined for the zero vector."},
    {"faceforward", "N, I, Nref", "N if dot(Nref, I) < 0, otherwise -N."},
    {"reflect", "I, N", "Direction of I after reflection at a surface with the normal N, which must have unit length."},
    {"refract", "I, N, eta", "Direction of I after refraction. `eta` is the index of refraction before the surface divided by that behind it; I and N must have unit length. The zero vector at total reflection."},
    {"matrixCompMult", "a, b", "Product component by component."},
    {"outerProduct", "a, b", "Matrix of a as a column times b as a row."},
    {"transpose", "m", "Transposed matrix."},
    {"determinant", "m", "Determinant."},
    {"inverse", "m", "Inverse matrix. Undefined if the determinant is 0."},
    {"lessThan", "a, b", "a < b, component by component."},
    {"lessThanEqual", "a, b", "a <= b, component by component."},
    {"greaterThan", "a, b", "a > b, component by component."},
    {"greaterThanEqual", "a, b", "a >= b, component by component."},
    {"equal", "a, b", "a == b, component by component."},
    {"notEqual", "a, b", "a != b, component by component."},
    {"any", "b", "True if any component is true."},
    {"all", "b", "True if all components are true."},
    {"not", "b", "Logical complement, component by component."},
    {"dFdx", "p", "Change of p to the next pixel on the right. In fragment shaders, outside of branches."},
    {"dFdy", "p", "Change of p to the next pixel above. In fragment shaders, outside of branches."},
    {"fwidth", "p", "abs(dFdx(p)) + abs(dFdy(p)): the width of a pixel in units of p."},
    {"dFdxFine", "p", "dFdx from the nearest pixels."},
    {"dFdyFine", "p", "dFdy from the nearest pixels."},
    {"dFdxCoarse", "p", "dFdx that may be shared by four pixels."},
    {"dFdyCoarse", "p", "dFdy that may be shared by four pixels."},
    {"bitfieldExtract", "value, offset, bits", "The bits from `offset` on."},
    {"bitfieldInsert", "base, insert, offset, bits", "base with these bits replaced."},
    {"bitfieldReverse", "value", "The bits in reverse order."},
    {"bitCount", "value", "Number of bits that are 1."},
    {"findLSB", "value", "Number of the lowest bit that is 1; -1 if there is none."},
    {"findMSB", "value", "Number of the highest significant bit; -1 if there is none."},
    {"texture", "image, coordinates, bias", "Looks up a texel, filtered, at these texture coordinates. `bias` is added to the level of detail, in fragment shaders."},
    {"textureProj", "image, coordinates, bias", "As texture, at the coordinates divided by their last component."},
    {"textureLod", "image, coordinates, lod", "As texture, from this level of detail."},
    {"textureProjLod", "image, coordinates, lod", "As textureProj, from this level of detail."},
    {"textureGrad", "image, coordinates, dx, dy", "As texture, with these changes of the coordinates to the next pixels."},
    {"textureProjGrad", "image, coordinates, dx, dy", "As textureProj, with these changes of the coordinates."},
    {"textureOffset", "image, coordinates, offset, bias", "As texture, displaced by a constant number of texels."},
    {"textureLodOffset", "image, coordinates, lod, offset", "As textureLod, displaced by a constant number of texels."},
    {"textureGather", "image, coordinates, component", "One component of the four texels that texture would filter."},
    {"texelFetch", "image, texel, lod", "One texel by its number, without filtering."},
    {"texelFetchOffset", "image, texel, lod, offset", "As texelFetch, displaced by a constant number of texels."},
    {"textureSize", "image, lod", "Size of a level of detail, in texels."},
    {"textureQueryLod", "image, coordinates", "The level of detail that texture would use."},
    {"textureQueryLevels", "image", "Number of levels of detail."},
    {"imageLoad", "image, texel", "Reads a texel of an image."},
    {"imageStore", "image, texel, value", "Writes a texel of an image."},
    {"imageSize", "image", "Size of an image, in texels."},
    {"interpolateAtCentroid", "input", "The fragment's input at a place that the primitive covers."},
    {"interpolateAtSample", "input, sample", "The fragment's input at a sample."},
    {"interpolateAtOffset", "input, offset", "The fragment's input, displaced in pixels."},
    {"noise1", "p", "Noise of one component. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"noise2", "p", "Noise of two components. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"noise3", "p", "Noise of three components. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"noise4", "p", "Noise of four components. Most drivers return 0: use the texture Noise2 or Noise3."},
    {"ftransform", "", "gl_ModelViewProjectionMatrix * gl_Vertex. In vertex shaders."},
    {"EmitVertex", "", "Emits a vertex with the current outputs. In geometry shaders."},
    {"EndPrimitive", "", "Ends the strip; the next vertex begins another one. In geometry shaders."},
    {"EmitStreamVertex", "stream", "As EmitVertex, to a stream."},
    {"EndStreamPrimitive", "stream", "As EndPrimitive, of a stream."},
    {"barrier", "", "Waits for the other invocations of the patch. In tessellation control shaders."},
    {"memoryBarrier", "", "Orders the writes to memory before those after it."},
    {"packUnorm2x16", "v", "Two numbers from 0 to 1 as 16 bits each."},
    {"unpackUnorm2x16", "bits", "Inverse of packUnorm2x16."},
    {"packUnorm4x8", "v", "Four numbers from 0 to 1 as 8 bits each."},
    {"unpackUnorm4x8", "bits", "Inverse of packUnorm4x8."},
    {"packHalf2x16", "v", "Two half floats."},
    {"unpackHalf2x16", "bits", "Inverse of packHalf2x16."},
    {"imageAtomicAdd", "image, texel, value", "Adds to a texel and returns what it was."},
    {"atomicCounterIncrement", "counter", "Increments the counter and returns what it was."},
    {"atomicCounterDecrement", "counter", "Decrements the counter and returns what it is then."},
    {"atomicCounter", "counter", "Value of the counter."},
};
// clang-format on

constexpr std::string_view legacy_functions =
    "texture1D texture2D texture3D textureCube texture1DProj texture2DProj texture3DProj texture1DLod texture2DLod "
    "texture3DLod textureCubeLod texture2DProjLod texture2DRect shadow1D shadow2D shadow2DProj";

// A character of a signature, see src/glsl/read/builtins.cpp.
std::string_view type_of(char code, bool result) {
    constexpr std::pair<char, std::string_view> types[] = {
        {'F', "genType"}, {'I', "genIType"}, {'U', "genUType"}, {'B', "genBType"}, {'f', "float"},
        {'i', "int"},     {'u', "uint"},     {'b', "bool"},     {'2', "vec2"},     {'3', "vec3"},
        {'4', "vec4"},    {'n', "ivec2"},    {'m', "ivec3"},    {'M', "mat"},      {'S', "sampler"},
        {'C', "vec"},     {'J', "ivec"},     {'T', "vec4"},     {'Z', "ivec"}};
    for (const auto& [letter, name] : types)
        if (letter == code) return name;
    return result ? "void" : "value";
}

std::string declared(std::string_view name, std::string_view overload, std::string_view parameters) {
    const bool matrix = overload.starts_with("X:M") || overload.starts_with("X:C");
    std::string text(matrix ? "mat" : type_of(overload.front(), true));
    text += " " + std::string(name) + "(";
    bool first = true, optional = false;
    for (const char code : overload.substr(2)) {
        if (code == '[') {
            optional = true;
            continue;
        }
        const std::size_t comma = parameters.find(", ");
        const std::string_view parameter = parameters.substr(0, comma);
        parameters = comma == std::string_view::npos ? std::string_view() : parameters.substr(comma + 2);
        if (optional) text += first ? "[" : " [";
        text += (first ? "" : ", ") + std::string(type_of(code, false)) + " " + std::string(parameter);
        if (optional) text += "]";
        first = false;
    }
    return text + ")";
}

}  // namespace

const FunctionDoc* function_doc(std::string_view name) {
    static const auto table = [] {
        std::unordered_map<std::string_view, const FunctionDoc*> t;
        for (const FunctionDoc& doc : docs) t.emplace(doc.name, &doc);
        return t;
    }();
    auto found = table.find(name);
    if (found == table.end()) found = table.find(glsl::modern_texture_function(name));
    return found == table.end() ? nullptr : found->second;
}

std::vector<std::string> function_signatures(std::string_view name) {
    const FunctionDoc* doc = function_doc(name);
    std::vector<std::string> all;
    if (doc == nullptr) return all;
    for (const std::string_view overload : split(glsl::builtin_signatures(doc->name))) {
        // Of atan, one overload has another first parameter.
        const bool one = name == "atan" && overload.size() == 3;
        all.push_back(declared(name, overload, one ? "y_over_x" : doc->parameters));
    }
    return all;
}

std::vector<std::string_view> function_names(bool legacy) {
    std::vector<std::string_view> names;
    for (const FunctionDoc& doc : docs) names.push_back(doc.name);
    if (legacy)
        for (const std::string_view name : split(legacy_functions)) names.push_back(name);
    return names;
}

}  // namespace snell::language
