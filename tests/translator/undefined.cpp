// Marks on operands of undefined results: for programs some of whose uniforms become constants.
#include "tests/translator/translate_help.h"

namespace snell::glsl::test {
namespace {

Texts program(std::string_view statements, std::string_view before = "") {
    return {{Stage::fragment, "uniform float a, b;\nuniform int n;\nuniform vec3 v;\n" + std::string(before) +
                                  "void main() {\nfloat x = gl_FragCoord.x;\n" + std::string(statements) +
                                  "\ngl_FragColor = vec4(x); }\n"},
            {Stage::vertex, "void main() { gl_Position = ftransform(); }"}};
}

// The fragment shader with marks, which the reference compiler takes in every target.
std::string marked(const Texts& texts) {
    std::string first;
    for (const Target& target : {core450, core330, es300, es320}) {
        Options options;
        options.target = target;
        options.settle = [](const auto&) { return std::vector<Settled>(); };
        Translated out;
        translate_texts(out, texts, options);
        expect_accepted(out.translation, first.empty());
        if (first.empty()) first = out.text(Stage::fragment);
    }
    return first.substr(first.find("void main()"));
}

// Numbers of the text are folded whether uniforms are constants or not; the user's own functions are defined.
TEST(GlslUndefined, NumbersOfTheTextAreNotMarked) {
    const Texts texts = program(
        "const float k = 3.;\nx = x / 2. + x / k + x / sqrt(2.) + 1. / radians(90.);\nx = mod(x, 2.) + pow(2., a);\n"
        "x = pow(k, 2.) + atan(0., -1.) + atan(x);\nx = mod(x, a, b);\nmat2 m = mat2(x);\nm = m / m;",
        "float mod(float x, float y, float z) { return x + y + z; }\n");
    const std::string text = marked(texts);
    for (const char* mark : {"snell_divisor", "snell_base", "snell_pow"})
        EXPECT_EQ(text.find(mark), std::string::npos) << text;
}

// In every program, asked for or not.
TEST(GlslUndefined, DivisorsThatTheTextMakesZeroAreMarked) {
    for (const char* zero :
         {"float w = 0.;\nx = x / w;", "x = x / 0.;", "x = mod(x, 0.);", "const float w = 0.;\nx /= w;",
          "vec2 w = vec2(0., 2.);\nx = (vec2(x) / w).x;", "float w = 3.;\nw -= 3.;\nx = x / w;",
          "float w = 0.;\nx = x / (w * 2.);\nw = a;", "x = x / k;", "x = x / sin(0.);", "x = x / f(0.);",
          "x = float(int(x) / 0);", "mat2 m = mat2(x) / 0.;\nx = m[0].x;"}) {
        const Texts texts = program(zero, "const float k = 0.;\nfloat f(float y) { return 2. * y; }\n");
        EXPECT_TRUE(translated(texts).has(Stage::fragment, "snell_divisor(")) << zero;
    }
    const std::string every_target = marked(program("x = x / 0.;\nx = float(int(x) / 0);\nx /= 0.;"));
    EXPECT_NE(every_target.find("snell_divisor("), std::string::npos) << every_target;
    // What is not, keeps its text.
    for (const char* other :
         {"x = x / (a + 1.);", "float w = 2.;\nx = x / w;", "x = x / tan(radians(30.));", "x = 1. / 2. + x / 3.;",
          "float w = 0.;\nfor (int i = 0; i < 4; ++i) w += x;\nx = (x * x) / (w);", "float w = 0.;\nw = x;\nx /= w;",
          "const float k3 = 1. / 0.;\nx = k3;", "x = mod(x, 3.);"}) {
        const Translated out = translated(program(other));
        EXPECT_FALSE(out.has(Stage::fragment, "snell_Zero")) << other;
        EXPECT_TRUE(out.has(Stage::fragment, other)) << other;
    }
}

TEST(GlslUndefined, NothingIsMarkedUnlessAskedFor) {
    const Texts texts = program("x = x / a + pow(x, b) + mod(x, a) + atan(a, b) + float(n % 3);");
    EXPECT_FALSE(translated(texts).has(Stage::fragment, "snell_divisor"));
    EXPECT_FALSE(translated(texts).has(Stage::fragment, "snell_Zero"));
    EXPECT_FALSE(translated(texts).has(Stage::fragment, "snell_pow"));
}

}  // namespace
}  // namespace snell::glsl::test
