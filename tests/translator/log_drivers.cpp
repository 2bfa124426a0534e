// Logs of NVIDIA, AMD, Intel, Apple and ANGLE, as they are found in bug reports, for one and the same mistakes.
#include <gtest/gtest.h>

#include <array>

#include "tests/translator/log_help.h"

namespace snell::glsl {
namespace {

using test::Program;

struct Case {
    const char* driver;
    const char* log;
};

template <std::size_t N>
Program explained(const char* shader, const std::array<Case, N>& cases, std::size_t i) {
    Program p;
    p.fragment(shader);
    p.explain(cases[i].log);
    return p;
}

constexpr const char* undeclared_shader =
    "in vec3 vNormal;\nvoid main() {\n    vec3 n = normalize(vNorml);\n    vec3 m = vNorml;\n}\n";
constexpr auto undeclared_logs = std::to_array<Case>({
    {"Mesa",
     "0:3(21): error: `vNorml' undeclared\n0:3(11): error: no matching function for call to `normalize(error)'; "
     "candidates are:\n0:4(11): error: `vNorml' undeclared\n"},
    {"NVIDIA",
     "0(3) : error C1503: undefined variable \"vNorml\"\n0(4) : error C1503: undefined variable \"vNorml\"\n"},
    {"NVIDIA, older",
     "0(3) : error C1008: undefined variable \"vNorml\"\n0(4) : error C1008: undefined variable \"vNorml\"\n"},
    {"AMD, older",
     "Fragment shader failed to compile with the following errors:\n"
     "ERROR: 0:3: error(#143) Undeclared identifier: vNorml\n"
     "ERROR: 0:3: error(#202) No matching overloaded function found: normalize\n"
     "ERROR: 0:3: error(#160) Cannot convert from: \"const float\" to: \"highp 3-component vector of vec3\"\n"
     "ERROR: 0:4: error(#143) Undeclared identifier: vNorml\n"
     "ERROR: error(#273) 4 compilation errors.  No code generated\n"},
    {"AMD",
     "ERROR: 0:3: 'vNorml' : undeclared identifier \nERROR: 0:4: 'vNorml' : undeclared identifier \n"
     "ERROR: 0:4: '' : compilation terminated \nERROR: 3 compilation errors.  No code generated.\n"},
    {"ANGLE",
     "ERROR: 0:3: 'vNorml' : undeclared identifier\nERROR: 0:3: 'normalize' : no matching overloaded function found\n"
     "ERROR: 0:4: 'vNorml' : undeclared identifier\n"},
    {"Apple", "ERROR: 0:3: Use of undeclared identifier 'vNorml'\nERROR: 0:4: Use of undeclared identifier 'vNorml'\n"},
});

TEST(DriverLogs, UndeclaredNameIsOneMessageForAll) {
    for (std::size_t i = 0; i < undeclared_logs.size(); ++i) {
        SCOPED_TRACE(undeclared_logs[i].driver);
        const Program p = explained(undeclared_shader, undeclared_logs, i);
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.message(0), "'vNorml' is not declared (fragment shader of 'Demo')");
        EXPECT_EQ(p.place(0), "demo.frag:3:24 vNorml");
        EXPECT_EQ(p.help(0), "did you mean 'vNormal'?");
        EXPECT_TRUE(p.has_note(0, "more that may come from the same mistake"));
    }
}

constexpr const char* narrowing_shader = "in vec4 vP;\nvoid main() {\n    vec3 q = vP;\n}\n";
constexpr auto narrowing_logs = std::to_array<Case>({
    {"Mesa", "0:3(2): error: initializer of type vec4 cannot be assigned to variable of type vec3\n"},
    {"NVIDIA", "0(3) : error C7623: implicit narrowing of type from \"vec4\" to \"vec3\"\n"},
    {"NVIDIA, older", "0(3) : error C7011: implicit cast from \"vec4\" to \"vec3\"\n"},
    {"AMD, older",
     "ERROR: 0:3: error(#160) Cannot convert from: \"4-component vector of vec4\" to: \"highp 3-component "
     "vector of vec3\"\nERROR: error(#273) 1 compilation errors.  No code generated\n"},
    {"AMD, oldest",
     "ERROR: 0:3: error(#160) Cannot convert from '4-component vector of float' to 'default out mediump "
     "3-component vector of float'\n"},
    {"Intel",
     "ERROR: 0:3: '=' :  cannot convert from '4-component vector of float' to '3-component vector of float'\n"},
    {"ANGLE",
     "ERROR: 0:3: '=' : cannot convert from 'in highp 4-component vector of float' to 'highp 3-component vector of "
     "float'\n"},
    {"Apple", "ERROR: 0:3: Incompatible types (vec3 and vec4) in assignment (and no available implicit conversion)\n"},
});

TEST(DriverLogs, NarrowingIsOneMessageForAll) {
    for (std::size_t i = 0; i < narrowing_logs.size(); ++i) {
        SCOPED_TRACE(narrowing_logs[i].driver);
        const Program p = explained(narrowing_shader, narrowing_logs, i);
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.message(0), "a 'vec4' cannot be assigned to a 'vec3' (fragment shader of 'Demo')");
        EXPECT_EQ(p.line(0), 3);
        EXPECT_EQ(p.help(0), "take 3 of its components: write '.xyz' after the vec4");
    }
}

constexpr const char* semicolon_shader = "void main() {\n    float x = 1.0\n    vec3 y = vec3(x);\n}\n";
constexpr auto semicolon_logs = std::to_array<Case>({
    {"Mesa", "0:3(2): error: syntax error, unexpected BASIC_TYPE_TOK, expecting ',' or ';'\n"},
    {"NVIDIA",
     "0(3) : error C0000: syntax error, unexpected reserved word \"vec3\", expecting ',' or ';' at token \"vec3\"\n"
     "0(3) : error C1503: undefined variable \"y\"\n"},
    {"AMD, older", "ERROR: 0:3: error(#132) Syntax error: \"vec3\" parse error\n"},
    {"ANGLE", "ERROR: 0:3: 'vec3' : syntax error\n"},
    {"Apple", "ERROR: 0:3: 'vec3' : syntax error: syntax error\n"},
    {"Intel", "ERROR: 0:3: 'vec3' : syntax error syntax error\n"},
});

TEST(DriverLogs, MissingSemicolonIsHintedForAll) {
    for (std::size_t i = 0; i < semicolon_logs.size(); ++i) {
        SCOPED_TRACE(semicolon_logs[i].driver);
        const Program p = explained(semicolon_shader, semicolon_logs, i);
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.code(0), "glsl-syntax");
        EXPECT_EQ(p.message(0).substr(0, 17), "unexpected 'vec3'");
        EXPECT_EQ(p.place(0), "demo.frag:3:5 vec3");
        EXPECT_EQ(p.help(0), "line 2 seems to lack a ';' at its end");
    }
}

constexpr const char* call_shader = "void main() {\n    float z = mix(1., 2.);\n}\n";
constexpr auto call_logs = std::to_array<Case>({
    {"Mesa",
     "0:2(12): error: no matching function for call to `mix(float, float)'; candidates are:\n"
     "0:2(12): error:    float mix(float, float, float)\n"},
    {"NVIDIA", "0(2) : error C1115: unable to find compatible overloaded function \"mix(float, float)\"\n"},
    {"AMD, older", "ERROR: 0:2: error(#202) No matching overloaded function found: mix\n"},
    {"AMD, oldest", "ERROR: 0:2: error(#202) No matching overloaded function found mix\n"},
    {"ANGLE", "ERROR: 0:2: 'mix' : no matching overloaded function found\nERROR: 0:2: '=' : dimension mismatch\n"},
    {"Apple", "ERROR: 0:2: No matching function for call to mix(float, float)\n"},
});

TEST(DriverLogs, WrongArgumentCountIsHintedForAll) {
    for (std::size_t i = 0; i < call_logs.size(); ++i) {
        SCOPED_TRACE(call_logs[i].driver);
        const Program p = explained(call_shader, call_logs, i);
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.code(0), "glsl-call");
        EXPECT_EQ(p.place(0), "demo.frag:2:15 mix");
        EXPECT_EQ(p.help(0), "mix(a, b, t) takes 3 arguments");
    }
}

constexpr const char* operand_shader = "in vec4 vP;\nvoid main() {\n    vec3 q = vec3(1.) * vP;\n}\n";
constexpr auto operand_logs = std::to_array<Case>({
    {"AMD",
     "ERROR: 0:3: '*' :  wrong operand types no operation '*' exists that takes a left-hand operand of type "
     "'3-component vector of float' and a right operand of type 'smooth in 4-component vector of float' (or there is "
     "no acceptable conversion)\n"},
    {"ANGLE",
     "ERROR: 0:3: '*' : wrong operand types - no operation '*' exists that takes a left-hand operand of type 'const "
     "3-component vector of float' and a right operand of type 'in highp 4-component vector of float' (or there is no "
     "acceptable conversion)\n"},
    {"Apple", "ERROR: 0:3: '*' does not operate on 'vec3' and 'vec4'\n"},
});

TEST(DriverLogs, OperandsOfDifferentSize) {
    for (std::size_t i = 0; i < operand_logs.size(); ++i) {
        SCOPED_TRACE(operand_logs[i].driver);
        const Program p = explained(operand_shader, operand_logs, i);
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.message(0), "a 'vec3' and a 'vec4' do not fit each other here (fragment shader of 'Demo')");
        EXPECT_NE(p.help(0).find(".xyz"), std::string::npos);
    }
}

constexpr auto link_logs = std::to_array<Case>({
    {"Mesa, older versions of GLSL", "error: fragment shader varying vNormal not written by vertex shader\n."},
    {"Mesa", "error: fragment shader input `vNormal' has no matching output in the previous stage\n"},
    {"NVIDIA", "Fragment info\n-------------\nerror: \"vNormal\" not declared as an output from the previous stage\n"},
    {"Apple", "ERROR: Input of fragment shader 'vNormal' not written by vertex shader\n"},
    {"Intel",
     "The fragment shader uses varying vNormal, but previous shader does not write to it.\nOut of resource error.\n"},
    {"AMD",
     "Vertex shader(s) linked, fragment shader(s) failed to link.\nfragment link error: INVALID_OPERATION.\n"
     "ERROR: error(#277) Input of fragment shader 'vNormal' not written by vertex shader\n"},
});

TEST(DriverLogs, LinkErrorsNameTheOutputThatDiffersByCase) {
    for (const Case& c : link_logs) {
        SCOPED_TRACE(c.driver);
        Program p;
        p.vertex("out vec3 vnormal;\nvoid main() { vnormal = vec3(1.); }\n");
        p.fragment("in vec3 vNormal;\nvoid main() { }\n");
        p.explain_link(c.log);
        ASSERT_EQ(p.diagnostics.items().size(), 1u);
        EXPECT_EQ(p.code(0), "glsl-interface");
        EXPECT_EQ(p.place(0), "demo.frag:1:9 vNormal");
        EXPECT_EQ(p.help(0), "the vertex shader calls it 'vnormal': the names must agree, capitals included");
    }
}

TEST(DriverLogs, NvidiasLinkLogNamesTheStageInAHeadline) {
    Program p;
    p.vertex("void main() { }\n");
    p.fragment("void Mian() { }\n");
    p.explain_link("Fragment info\n-------------\n(0) : error C3001: no program defined\n");
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.message(0), "there is no function 'main' (fragment shader of 'Demo')");
    EXPECT_EQ(p.place(0), "demo.frag:1:6 Mian");
}

TEST(DriverLogs, WarningsStandAloneOnlyWhenThereIsNoError) {
    const char* warning = "0(3) : warning C7050: \"q\" might be used before being initialized\n";
    Program p;
    p.fragment(narrowing_shader);
    p.explain(warning);
    ASSERT_EQ(p.diagnostics.items().size(), 1u);
    EXPECT_EQ(p.at(0).severity, Severity::warning);
    Program q;
    q.fragment(narrowing_shader);
    q.explain(std::string(warning) + narrowing_logs[1].log);
    ASSERT_EQ(q.diagnostics.items().size(), 1u);
    EXPECT_EQ(q.at(0).severity, Severity::error);
}

TEST(DriverLogs, ManyIndependentErrorsEndInACount) {
    std::string log, shader = "void main() {\n";
    for (int i = 0; i < 10; ++i) {
        shader += fmt::format("    float x{} = name{};\n", i, i);
        log += fmt::format("0({}) : error C1503: undefined variable \"name{}\"\n", i + 2, i);
    }
    Program p;
    p.fragment(shader + "}\n");
    p.explain(log);
    ASSERT_EQ(p.diagnostics.items().size(), 6u);
    EXPECT_EQ(p.line(0), 2);
    EXPECT_TRUE(p.has_note(5, "and 4 more errors"));
}

}  // namespace
}  // namespace snell::glsl
