// Random shaders of what compilers fold: uniforms, what differs between pixels, and numbers of the text.
#pragma once

#include <fmt/format.h>

#include "tests/std.h"

namespace snell::test::random_shader {

inline constexpr int floats = 6, ints = 3, bools = 2;

class Writer {
public:
    explicit Writer(std::mt19937& random) : random_(random) {}

    template <class... Choices>
    std::string any(Choices... choices) {
        const std::string all[] = {choices...};
        return all[turn(sizeof...(choices))];
    }
    std::size_t turn(std::size_t n) { return random_() % n; }

    std::string uniform() { return "uF" + std::to_string(turn(floats)); }
    std::string whole() { return "uI" + std::to_string(turn(ints)); }

    std::string leaf() {
        switch (turn(8)) {
            case 0:
            case 1:
            case 2:
                return uniform();
            case 3:
                return any("vST.x", "vST.y", "live.x", "live.y", "live.z", "vK");
            case 4:
                return any("0.", "1.", "-1.", "2.", ".5", "zero", "one");
            case 5:
                return any("float(" + whole() + ")", "uV.x", "uV.y", "uW.z");
            default:
                return any("a", "b", "c", "v.x", "v.y", "float(k)");
        }
    }
    std::string scalar(int depth) {
        if (depth <= 0) return leaf();
        const auto s = [&] { return scalar(depth - 1 - static_cast<int>(turn(2))); };
        switch (turn(14)) {
            case 0:
                return "(" + s() + " + " + s() + ")";
            case 1:
                return "(" + s() + " - " + s() + ")";
            case 2:
            case 3:
            case 4:
                return "(" + s() + " * " + s() + ")";
            case 5:
            case 6:
                return "(" + s() + " / " + s() + ")";
            case 7:
                return any("sin", "cos", "sqrt", "log", "exp", "inversesqrt", "abs", "exp2", "log2", "atan", "fract",
                           "floor", "sign", "length", "acos") +
                       "(" + s() + ")";
            case 8:
                return any("pow", "mod", "atan", "min", "max", "step", "quotient", "raised", "chosen", "changed",
                           "parted") +
                       "(" + s() + ", " + s() + ")";
            case 9:
                return "mix(" + s() + ", " + s() + ", " + any(uniform(), uniform(), s()) + ")";
            case 10:
                return any("smoothstep", "clamp") + "(" + s() + ", " + s() + ", " + s() + ")";
            case 11:
                return "(" + condition(depth - 1) + " ? " + s() + " : " + s() + ")";
            case 12:
                return any("normalize(" + vector(depth - 1) + ").x", "dot(" + vector(depth - 1) + ", v)",
                           "length(" + vector(depth - 1) + ")",
                           "(" + vector(depth - 1) + " / " + vector(depth - 1) + ").y",
                           "texture(uPicture, " + vector(depth - 1) + ".xy).r * " + uniform());
            default:
                return "-(" + leaf() + ")";
        }
    }
    std::string vector(int depth) {
        return any("vec3(" + scalar(depth) + ", " + scalar(depth) + ", " + leaf() + ")", "vec3(" + scalar(depth) + ")",
                   "(uV * " + leaf() + ")", "(uV - uW)", "v", "(live * " + uniform() + ")",
                   "mix(v, uV, " + uniform() + ")");
    }
    std::string condition(int depth) {
        return any(uniform() + any(" > ", " < ", " == ", " != ", " >= ") + any("0.", ".5", "1.", uniform()), "uB0",
                   "!uB1", "uB0 && " + scalar(depth) + " > 0.", "uB1 || " + scalar(depth) + " > 0.", whole() + " == 1",
                   "k > " + whole(), scalar(depth) + " < " + scalar(depth), "int(" + uniform() + ") == 1", "on",
                   whole() + " < " + whole());
    }
    std::string statement(int depth) {
        const std::string target = any("a", "b", "c", "v.x", "v.y");
        switch (turn(12)) {
            case 0:
            case 1:
                return fmt::format("{} = {};", target, scalar(depth));
            case 2:
                return fmt::format("{} {} {};", target, any("+=", "*=", "-=", "/="), scalar(depth - 1));
            case 3:
                return fmt::format("v = {};", vector(depth - 1));
            case 4:
            case 5:
                return fmt::format("if ({}) {{ {} }}", condition(depth - 1), statement(depth - 1));
            case 6:
                return fmt::format("if ({}) {} = {}; else {} = {};", condition(depth - 1), target,
                                   any("0.", "1.", scalar(depth - 1)), target, scalar(depth - 1));
            case 7:  // few, and none within another, because LLVM takes long for them
                if (loops_++ > 0) return fmt::format("{} = float(k);", target);
                return fmt::format("for (int i = 0; i < {}; ++i) {} {} {};",
                                   any(whole(), "k", "int(" + uniform() + ")"), target, any("+=", "*=", "="),
                                   any("float(i)", "pow(a, float(i))", "float(i) * " + leaf(), scalar(depth - 1),
                                       "list[i % 5]", "(i == 0 ? 0. : " + leaf() + ")"));
            case 8:
            case 9:
                return fmt::format("set({}, {});", target, scalar(depth - 1));
            case 10:
                return any(fmt::format("k = {};", any(whole(), "0", "2", "k + 1")), "on = " + condition(0) + ";");
            default:
                return fmt::format("if ({}) {};", condition(depth - 1), any("discard", target + " = 0."));
        }
    }

    std::string statements() {
        loops_ = 0;
        std::string text;
        for (std::size_t k = 2 + turn(4); k-- > 0;) text += statement(2) + "\n";
        return text;
    }

private:
    std::mt19937& random_;
    int loops_ = 0;
};

inline std::string declared() {
    std::string text = "uniform vec3 uV, uW;\n";
    for (int n = 0; n < floats; ++n) text += fmt::format("uniform float uF{};\n", n);
    for (int n = 0; n < ints; ++n) text += fmt::format("uniform int uI{};\n", n);
    for (int n = 0; n < bools; ++n) text += fmt::format("uniform bool uB{};\n", n);
    return text;
}

inline constexpr std::string_view functions =
    "const float zero = 0., one = 1.;\nconst float list[5] = float[5](0., 1., -1., .5, 0.);\n"
    "float quotient(float x, float y) { float w = y * .5; w += y * .5; return x / w; }\n"
    "float raised(float x, float y) { if (y == 0.) return 1.; if (y == 1.) return x; return pow(x, y); }\n"
    "float chosen(float x, float y) { float r = 0.; if (uB0) r = x; if (uF0 > .5) r *= y; return r; }\n"
    "float changed(float x, float y) { if (uB1) x = y; return x; }\n"
    "struct Part { float a; vec2 b; };\n"
    "float parted(float x, float y) { Part p = Part(0., vec2(x, 0.)); if (uB0) p = Part(x, vec2(1., y)); else p.b.y = "
    "y;\n"
    "return p.a + p.b.x * p.b.y; }\n"
    "void set(out float r, float x) { r = 0.; if (uB1) r = x; }\n";

// What the statements know besides.
inline constexpr std::string_view variables =
    "float a = vST.x, b = 0., c = 1.;\nvec3 v = vec3(0., vST.y, -1.);\nint k = 0;\nbool on = uB0;\n";

}  // namespace snell::test::random_shader
