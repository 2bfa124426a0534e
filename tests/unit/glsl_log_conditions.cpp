// Messages of drivers about conditions and statements, which a translated program seldom shows.
#include <gtest/gtest.h>

#include "glsl_log_help.h"

namespace snell::glsl {
namespace {

using test::Program;

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
