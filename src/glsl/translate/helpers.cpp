// Functions that core profiles lack, or leave undefined where a result is expected: declared where they are called.
// A text that was translated before declares them already.

#include "src/glsl/translate/program.h"

#include "parser/text/ranges.h"

namespace snell::glsl {

namespace {

// Gradient noise in four dimensions, about -1 … 1, zero at lattice points; a hash of integers picks one of the
// 32 gradients with one zero component. Lower dimensions are its slices.
constexpr std::string_view noise_text =
    "uint snell_hash(uint h, int k) { h = (h ^ uint(k)) * 0x9E3779B1u; return h ^ (h >> 15u); }\n"
    "float snell_gradient(ivec4 c, vec4 d) { uint h = snell_hash(snell_hash(snell_hash(snell_hash(0x68E31DA4u, c.x), "
    "c.y), "
    "c.z), c.w) * 0x85EBCA77u; h ^= h >> 13u; vec4 s = vec4((h & 1u) == 0u ? 1.0 : -1.0, (h & 2u) == 0u ? 1.0 : -1.0, "
    "(h & 4u) == 0u ? 1.0 : -1.0, (h & 8u) == 0u ? 1.0 : -1.0); s[int((h >> 8u) & 3u)] = 0.0; return dot(s, d); }\n"
    "float snell_noise(vec4 p) { vec4 f = floor(p); ivec4 c = ivec4(f); vec4 d = p - f; vec4 t = d * d * d * "
    "(d * (d * 6.0 - 15.0) + 10.0); float sum = 0.0; for (int n = 0; n < 16; ++n) { ivec4 o = ivec4(n & 1, (n >> 1) & "
    "1, "
    "(n >> 2) & 1, n >> 3); vec4 v = vec4(o); vec4 w = mix(1.0 - t, t, v); sum += w.x * w.y * w.z * w.w * "
    "snell_gradient(c + o, d - v); } return 0.85 * sum; }\n";

constexpr std::string_view arguments[] = {"float", "vec2", "vec3", "vec4"};
constexpr std::string_view widened[] = {"vec4(p, 0.0, 0.0, 0.0)", "vec4(p, 0.0, 0.0)", "vec4(p, 0.0)", "p"};
constexpr std::string_view results[] = {"float", "vec2", "vec3", "vec4"};

// noise2, noise3, noise4: independent values, far apart in the same field.
std::string noise_function(int n, int argument) {
    std::string text = std::string(results[n - 1]) + " snell_noise" + std::to_string(n) + "(" +
                       std::string(arguments[argument]) + " p) { vec4 q = " + std::string(widened[argument]) +
                       "; return ";
    constexpr std::string_view far[] = {"q", "q + 31.25", "q + 67.5", "q + 113.75"};
    if (n > 1) text += std::string(results[n - 1]) + "(";
    for (int k = 0; k < n; ++k) text += (k ? ", " : "") + ("snell_noise(" + std::string(far[k]) + ")");
    return text + (n > 1 ? "); }\n" : "; }\n");
}

// A step where both edges are the same: OpenGL leaves it undefined, and drivers divide 0 by 0.
std::string smoothstep_function(std::string_view edge, std::string_view type) {
    const std::string t(type), e(edge), same = type == "float" ? "a == b" : "equal(" + t + "(a), " + t + "(b))";
    return t + " snell_smoothstep(" + e + " a, " + e + " b, " + t + " x) { return " +
           (type == "float" ? same + " ? step(a, x) : smoothstep(a, b, x)"
                            : "mix(smoothstep(a, b, x), step(a, x), " + same + ")") +
           "; }\n";
}

// What marks of read/marks.cpp call. Nothing folds what a uniform takes part in, and one that is never set is 0. `n`
// differs from mark to mark and between components, so that nothing knows two of them to be equal, as in x / x.
struct MarkText {
    std::string_view name, text, prefix;  // for a scalar; of the vectors that it is repeated for
};
constexpr std::string_view live_text =
    "float snell_live(int n, float x) { return intBitsToFloat(floatBitsToInt(x) + snell_Zero * n); }\n";
constexpr MarkText marks[] = {
    {"snell_divisor", "float snell_divisor(int n, float x) { return snell_live(n, x); }\n", "vec"},
    {"snell_divisor", "int snell_divisor(int n, int x) { return x <= 0 ? x + snell_Zero * n : x; }\n", "ivec"},
    {"snell_divisor", "uint snell_divisor(int n, uint x) { return x == 0u ? uint(snell_Zero * n) : x; }\n", "uvec"},
    {"snell_value", "float snell_value(int n, float x) { return snell_live(n, x); }\n", "vec"},
    {"snell_value", "int snell_value(int n, int x) { return x + snell_Zero * n; }\n", "ivec"},
    {"snell_value", "uint snell_value(int n, uint x) { return x + uint(snell_Zero * n); }\n", "uvec"},
    {"snell_value", "bool snell_value(int n, bool x) { return int(x) + snell_Zero * n != 0; }\n", "bvec"},
};

std::string by_component(const MarkText& mark, int size) {
    const std::string name(mark.name), type = std::string(mark.prefix) + std::to_string(size);
    std::string text = type + " " + name + "(int n, " + type + " x) { return " + type + "(";
    for (int k = 0; k < size; ++k) {
        const std::string component = std::string(".") + "xyzw"[k];
        text += (k ? ", " : "") + name + "(n + " + std::to_string(k) + ", x" + component + ")";
    }
    return text + "); }\n";
}

std::string mark_functions(std::string_view function) {
    std::string text;
    for (const MarkText& mark : marks) {
        if (mark.name != function) continue;
        text += mark.text;
        for (int size = 2; size <= 4; ++size) text += by_component(mark, size);
    }
    if (function == "snell_divisor") return text;  // nothing divides by a matrix
    for (const std::string_view type : {"mat2", "mat3", "mat4"}) {
        const std::string t(type);
        text += t + " snell_value(int n, " + t + " x) { return " + t + "(";
        for (int column = 0; column < t.back() - '0'; ++column)
            text += (column ? ", snell_value(n + " : "snell_value(n + ") + std::to_string(4 * column) + ", x[" +
                    std::to_string(column) + "])";
        text += "); }\n";
    }
    return text;
}

// Drivers that find a determinant to be 0 by algebra (a * a - a * a) divide by a constant 0, which llvmpipe leaves
// undefined: other bytes in every run. They don't see through this.
std::string of_matrix(std::string_view function) {
    std::string text;
    for (const std::string_view type : {"mat2", "mat3", "mat4"}) {
        const std::string t(type), name(function);
        text += (name == "inverse" ? t : "float") + " snell_" + name + "(" + t + " m) { return " + name +
                "(snell_value(-16, m)); }\n";
    }
    return text;
}

bool has_doubles(const Unit& u) {
    return ranges::any_of(u.tokens, [](const Token& t) {
        return t.text == "double" || t.text.starts_with("dvec") || t.text.ends_with("lf") || t.text.ends_with("LF");
    });
}

}  // namespace

// Calls of a function go to ours; false if there are none, or the function is the user's own.
static bool redirect(Unit& u, const std::string& name) {
    if (user_function(u, name)) return false;
    bool used = false;
    for (std::size_t i = 0; i + 1 < u.tokens.size(); ++i) {
        if (u.tokens[i].text != name || u.tokens[i + 1].text != "(" || u.tokens[i].kind != Kind::identifier) continue;
        used = true;
        u.replace(static_cast<int>(i), "snell_" + name);
    }
    return used;
}

void provide_mark(Unit& u, std::string_view function) {
    const std::string text = mark_functions(function);
    if (u.header.find(text) != std::string::npos) return;
    declare_once(u, "snell_Zero", "uniform int snell_Zero;");
    if (u.header.find(live_text) == std::string::npos) u.header += live_text;
    u.header += text;
}

void provide_helpers(const Target& target, Unit& u) {
    bool declared = false;
    for (int n = 1; n <= 4; ++n) {
        if (!redirect(u, "noise" + std::to_string(n))) continue;
        if (!declared) u.header += noise_text;
        declared = true;
        for (int argument = 0; argument < 4; ++argument) u.header += noise_function(n, argument);
    }
    if (!has_doubles(u) && !user_function(u, "snell_smoothstep") && redirect(u, "smoothstep"))
        for (const std::string_view type : arguments) {
            u.header += smoothstep_function(type, type);
            if (type != "float") u.header += smoothstep_function("float", type);
        }
    for (const std::string_view function : {"inverse", "determinant"})
        if (!has_doubles(u) && redirect(u, std::string(function))) {
            provide_mark(u, "snell_value");
            u.header += of_matrix(function);
        }
    if (target.es && target.version < 320 && redirect(u, "fma"))
        for (const std::string_view type : arguments) {
            const std::string t(type);
            u.header += t + " snell_fma(" + t + " a, " + t + " b, " + t + " c) { return a * b + c; }\n";
        }
}

}  // namespace snell::glsl
