// Messages of drivers about conditions and statements, which a translated program seldom shows.
#include <gtest/gtest.h>

#include "tests/translator/log_help.h"
#include "tests/translator/translate_help.h"

namespace snell::glsl {
namespace {

using test::fragment;
using test::Program;
using test::Translated;

TEST(MesaLog, ConditionsThatAreNumbers) {
    Program p;
    p.fragment(
        "void main() {\n    float a;\n    if (a) a = 1.;\n    if (a = 1.) a = 2.;\n    if (!a) a = 1.;\n    while (a "
        ">= 1. && a) a = 2.;\n}\n");
    p.explain(
        "0:3(6): error: if-statement condition must be scalar boolean\n"
        "0:4(6): error: if-statement condition must be scalar boolean\n"
        "0:5(7): error: operand of `!' must be scalar boolean\n"
        "0:6(20): error: RHS of `&&' must be scalar boolean\n");
    ASSERT_EQ(p.diagnostics.items().size(), 4u);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_EQ(p.message(i), "a condition must be true or false (fragment shader of 'Demo')");
    EXPECT_EQ(p.place(0), "demo.frag:3:9 a");
    EXPECT_EQ(p.help(0), "compare it with something, as in 'x > 0.' or 'n != 0'");
    EXPECT_EQ(p.help(1), "'=' assigns; '==' compares");
    EXPECT_EQ(p.help(3), p.help(0));
}

// Mesa says that types do not fit, and not which: the translation knows them.
TEST(MesaLog, RefusedOperandsAreNamed) {
    struct Case {
        const char *statement, *log, *message, *help;
    };
    for (const Case& c : {
             Case{"if (v == 0) c = w;", "0:4(5): error: operands of `==' must have the same type",
                  "'==' does not take a 'vec3' and an 'int'", "vec3(…)"},
             Case{"if (v != w) c = w;", "0:4(5): error: operands of `!=' must have the same type",
                  "'!=' does not take a 'vec3' and a 'vec4'", "same number"},
             Case{"if (v < f) c = w;", "0:4(5): error: operands to relational operators must be scalar and numeric",
                  "'<' does not take a 'vec3' and a 'float'", "length(v)"},
             Case{"int k = n % 2.;", "0:4(9): error: RHS of operator % must be an integer",
                  "'%' does not take an 'int' and a 'float'", "mod(x, y)"},
             Case{"int k = n & f;", "0:4(9): error: RHS of `&' must be an integer",
                  "'&' does not take an 'int' and a 'float'", "'&&'"},
             Case{"vec3 q = v + w.xy;", "0:4(10): error: vector size mismatch for arithmetic operator",
                  "'+' does not take a 'vec3' and a 'vec2'", "same number of components"},
             Case{"vec3 q = m * w;", "0:4(10): error: size mismatch for matrix multiplication",
                  "'*' does not take a 'mat3' and a 'vec4'", "a mat3 goes with a vec3"},
             Case{"v2 += w;", "0:4(1): error: vector size mismatch for arithmetic operator",
                  "'+' does not take a 'vec3' and a 'vec4'", "same number of components"},
             Case{"float g = -b;", "0:4(11): error: operands to arithmetic operators must be numeric",
                  "'-' does not take a 'bool'", "float(…)"},
             Case{"if (!v) c = w;", "0:4(5): error: operand of `!' must be scalar boolean",
                  "'!' does not take a 'vec3'", "compare"},
             Case{"float g = b ? f : v;",
                  "0:4(11): error: second and third operands of ?: operator must have matching "
                  "types",
                  "'? :' chooses between a 'float' and a 'vec3'", "same type"},
         }) {
        Translated t = fragment(
            "#version 330\nuniform float f; uniform int n; uniform vec3 v; uniform bool b; uniform mat3 m; uniform "
            "vec4 "
            "w; out vec4 c;\nvoid main() { vec3 v2 = v;\n" +
            std::string(c.statement) + "\n}\n");
        Diagnostics said;
        const StageOutput* stage = nullptr;
        for (const StageOutput& s : t.translation.stages)
            if (s.stage == Stage::fragment) stage = &s;
        ASSERT_NE(stage, nullptr);
        explain_log(std::string(c.log) + "\n", t.translation, stage, {}, "Demo", t.sources, said);
        ASSERT_EQ(said.items().size(), 1U) << c.statement;
        const Diagnostic& d = said.items()[0];
        EXPECT_EQ(d.message, std::string(c.message) + " (fragment shader of 'Demo')");
        EXPECT_EQ(d.code, "glsl-type");
        EXPECT_NE(d.help.find(c.help), std::string::npos) << c.statement << ": " << d.help;
        EXPECT_EQ(t.sources.position(d.span.file, d.span.begin).line, 4) << c.statement;
    }
}

// What is allowed is not remembered as a misfit, or another error on its line would be explained by it.
TEST(MesaLog, OperandsThatFitAreNoMisfits) {
    const Translated t = fragment(
        "#version 330\nuniform float f; uniform int n; uniform uint u; uniform vec3 v; uniform bool b; uniform mat3 "
        "m;\n"
        "uniform mat2x3 m23; uniform ivec3 i; out vec4 c;\nvoid main() {\n"
        "vec3 a = m * v; a = v * m; a = v * f; a = f * v; a = v + v; a *= m; a /= 2; a = v / 2; mat3 q = m * m; q = f "
        "* m;\n"
        "vec3 p = m23 * vec2(1.); vec2 r = v * m23; i = i % 2; i = i << 1; i = i & 3; n & 1; u >> 1u; i % i; 1 << n;\n"
        "b = v == a; b = m == q; b = f < 1; b = n != 0; b = b && f > 0.; b = b == true; b = !b; f + n; -v; -i; ~n; b ? "
        "v : a;\n"
        "c = vec4(a, 1.); }\n");
    for (const StageOutput& s : t.translation.stages)
        for (const Misfit& m : s.misfits) ADD_FAILURE() << m.left << " " << m.op << " " << m.right;
}

TEST(MesaLog, ReturnedValues) {
    Program p;
    p.fragment("void f() {\n    return 1.;\n}\nfloat g() { }\n");
    p.explain(
        "0:2(2): error: could not implicitly convert return value to void, in function `f'\n"
        "0:4(7): error: function `g' has non-void return type float, but no return statement\n");
    ASSERT_EQ(p.diagnostics.items().size(), 2u);
    EXPECT_NE(p.help(0).find("in place of 'void'"), std::string::npos);
    EXPECT_EQ(p.message(1), "function 'g' returns no value (fragment shader of 'Demo')");
}

TEST(MesaLog, ReadOnlyThings) {
    Program p;
    p.fragment("in vec2 vST;\nvoid main() {\n    vST = vec2(1.);\n}\n");
    p.explain("0:3(2): error: assignment to read-only variable 'vST'\n");
    EXPECT_EQ(p.code(0), "glsl-read-only");
    EXPECT_EQ(p.place(0), "demo.frag:3:5 vST");
    EXPECT_EQ(p.help(0), "'vST' is declared as 'in': copy it to a variable of its own first");
}

TEST(MesaLog, NamesOfVariablesAndFunctionsMixedUp) {
    Program p;
    p.fragment("float f(float x) { return x; }\nvoid main() {\n    float a = f;\n    a = a(1.);\n}\n");
    p.explain("0:3(12): error: `f' undeclared\n0:4(6): error: no function with name 'a'\n");
    EXPECT_EQ(p.help(0), "a function is called with its arguments: f(…)");
    EXPECT_EQ(p.help(1), "'a' is a variable, not a function");
}

TEST(AngleLog, ArticlesFitTheType) {
    Program p;
    p.fragment("void main() {\n    int a = 1.5;\n}\n");
    p.explain("ERROR: 0:2: '=' : cannot convert from 'const float' to 'highp int'\n");
    EXPECT_EQ(p.message(0), "a 'float' cannot be assigned to an 'int' (fragment shader of 'Demo')");
    EXPECT_EQ(p.help(0), "convert it: int(…)");
}

}  // namespace
}  // namespace snell::glsl
