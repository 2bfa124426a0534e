// Logs of drivers, explained: those of tests/logs, those that need a translation, and any bytes.
//
// A file of tests/logs begins with what it is about. Then come the shaders ("== demo.frag"), what the driver saw of
// them if that differs ("== translated demo.frag"), its logs ("== log DRIVER", "== link log DRIVER"), and the
// diagnostics that each of these logs must give ("== expect"). A log whose name ends in "unnumbered" is of the text
// without its #line. Further logs are about the same shaders, unless shaders
// come before them.
#include "tests/translator/translate_help.h"

namespace snell::glsl {
namespace {

using test::fragment;
using test::Translated;

// A program whose shaders did not compile.
struct Program {
    Sources sources;
    Translation translation;

    const StageOutput* stage(Stage which) const {
        for (const StageOutput& s : translation.stages)
            if (s.stage == which) return &s;
        return nullptr;
    }
    // Another file belongs to the stage before it, which includes it.
    void add(const std::string& name, const std::string& text) {
        const FileId file = sources.add(name, text);
        if (name.ends_with(".vert") || name.ends_with(".frag")) {
            const Stage which = name.ends_with(".vert") ? Stage::vertex : Stage::fragment;
            translation.stages.push_back({.stage = which, .text = text, .files = {}});
        }
        translation.stages.back().files.push_back(file);
    }
    Diagnostics explain(std::string_view log, const StageOutput* stage, Lines lines = Lines::numbered) {
        const FileId scene = sources.add("demo.glib", "Vertex demo.vert\nFragment demo.frag\nProgram Demo\n");
        Diagnostics said;
        explain_log(log, translation, stage, {scene, 36, 48}, "Demo", sources, said, lines);
        return said;
    }
};

struct Part {
    std::string name, text;
};

std::vector<Part> parts_of(const std::filesystem::path& path) {
    std::ifstream file(path);
    std::vector<Part> parts;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("== "))
            parts.push_back({line.substr(3), ""});
        else if (!parts.empty())
            parts.back().text += line + "\n";
    }
    return parts;
}

void check(const std::filesystem::path& path) {
    Program program;
    std::vector<Part> logs;
    std::string before;
    for (const Part& part : parts_of(path)) {
        if (part.name == "expect") {
            for (const Part& log : logs) {
                SCOPED_TRACE(path.filename().string() + ": " + log.name);
                const StageOutput* stage = log.name.starts_with("link") ? nullptr : &program.translation.stages.back();
                // Drivers end their logs with a new line or without.
                const Lines lines = log.name.ends_with("unnumbered") ? Lines::unnumbered : Lines::numbered;
                for (const std::string& text : {log.text, log.text.substr(0, log.text.size() - 1)})
                    EXPECT_EQ(render(program.explain(text, stage, lines), program.sources), part.text);
            }
            logs.clear();
        } else if (part.name.starts_with("log") || part.name.starts_with("link log")) {
            logs.push_back(part);
        } else if (part.name.starts_with("translated ")) {
            program.translation.stages.back().text = part.text;
        } else {
            if (before == "expect") program = {};
            program.add(part.name, part.text);
        }
        before = part.name;
    }
    EXPECT_EQ(before, "expect") << path;
}

TEST(Logs, AreExplainedWordForWord) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SNELL_ROOT "/tests/logs")) {
        check(entry.path());
        ++files;
    }
    EXPECT_GE(files, 30);
}

TEST(Logs, AUniformThatOnlyTheSceneHasIsToBeDeclared) {
    const std::string scene = "Program Demo uTex 6 uSky 7 uTint {1. .5 0.} uKd <0. 1. 2.>\n";
    const std::string shader =
        "void main() {\nvec4 c = texture2D(uTex, vec2(0.)) + textureCube(uSky, vec3(1.));\n"
        "gl_FragColor = vec4(uTint * uKd, 1.) + c;\n}\n";
    for (const auto& [log, help] : {std::pair("0:2(20): error: `uTex' undeclared\n", "uniform sampler2D uTex;"),
                                    std::pair("0:2(51): error: `uSky' undeclared\n", "uniform samplerCube uSky;"),
                                    std::pair("0:3(21): error: `uTint' undeclared\n", "uniform vec3 uTint;"),
                                    std::pair("ERROR: 0:3: 'uKd' : undeclared identifier\n", "uniform float uKd;")}) {
        Program program;
        program.add("demo.frag", shader);
        const FileId file = program.sources.add("demo.glib", scene);
        Diagnostics said;
        explain_log(log, program.translation, &program.translation.stages[0],
                    {file, 0, static_cast<std::uint32_t>(scene.size())}, "Demo", program.sources, said);
        ASSERT_EQ(said.items().size(), 1U) << log;
        EXPECT_EQ(said.items()[0].help, "declare it above main: " + std::string(help));
    }
}

// Mesa says that types do not fit, and ANGLE that dimensions do not, but not which: the translation knows them.
TEST(Logs, RefusedOperandsAreNamed) {
    struct Case {
        const char *statement, *log, *message, *help;
    };
    const Case rows[] = {
        {"if (v == 0) c = w;", "0:4(5): error: operands of `==' must have the same type",
         "'==' does not take a 'vec3' and an 'int'", "vec3(…)"},
        {"if (v != w) c = w;", "0:4(5): error: operands of `!=' must have the same type",
         "'!=' does not take a 'vec3' and a 'vec4'", "same number"},
        {"if (v < f) c = w;", "0:4(5): error: operands to relational operators must be scalar and numeric",
         "'<' does not take a 'vec3' and a 'float'", "length(v)"},
        {"int k = n % 2.;", "0:4(9): error: RHS of operator % must be an integer",
         "'%' does not take an 'int' and a 'float'", "mod(x, y)"},
        {"int k = n & f;", "0:4(9): error: RHS of `&' must be an integer", "'&' does not take an 'int' and a 'float'",
         "'&&'"},
        {"vec3 q = v + w.xy;", "0:4(10): error: vector size mismatch for arithmetic operator",
         "'+' does not take a 'vec3' and a 'vec2'", "same number of components"},
        {"vec3 q = m * w;", "0:4(10): error: size mismatch for matrix multiplication",
         "'*' does not take a 'mat3' and a 'vec4'", "a mat3 goes with a vec3"},
        {"v2 += w;", "0:4(1): error: vector size mismatch for arithmetic operator",
         "'+' does not take a 'vec3' and a 'vec4'", "same number of components"},
        {"float g = -b;", "0:4(11): error: operands to arithmetic operators must be numeric",
         "'-' does not take a 'bool'", "float(…)"},
        {"if (!v) c = w;", "0:4(5): error: operand of `!' must be scalar boolean", "'!' does not take a 'vec3'",
         "compare"},
        {"float g = b ? f : v;", "0:4(11): error: second and third operands of ?: operator must have matching types",
         "'? :' chooses between a 'float' and a 'vec3'", "same type"},
        {"float g = v;", "ERROR: 0:4: '=' : dimension mismatch", "a 'vec3' cannot be assigned to a 'float'",
         "length(…)"},
        {"v2 = f;", "ERROR: 0:4: '=' : dimension mismatch", "a 'float' cannot be assigned to a 'vec3'", "vec3(…)"},
        {"c.rg = v;", "ERROR: 0:4: '=' : dimension mismatch", "a 'vec3' cannot be assigned to a 'vec2'", ".xy"}};
    for (const Case& c : rows) {
        SCOPED_TRACE(c.statement);
        Translated t = fragment(
            "#version 330\nuniform float f; uniform int n; uniform vec3 v; uniform bool b; uniform mat3 m; uniform "
            "vec4 w; out vec4 c;\nvoid main() { vec3 v2 = v;\n" +
            std::string(c.statement) + "\n}\n");
        Program program{std::move(t.sources), std::move(t.translation)};
        const Diagnostics said = program.explain(std::string(c.log) + "\n", program.stage(Stage::fragment));
        ASSERT_EQ(said.items().size(), 1U);
        const Diagnostic& d = said.items()[0];
        EXPECT_EQ(d.message, std::string(c.message) + " (fragment shader of 'Demo')");
        EXPECT_EQ(d.code, "glsl-type");
        EXPECT_NE(d.help.find(c.help), std::string::npos) << d.help;
        EXPECT_EQ(program.sources.position(d.span.file, d.span.begin).line, 4);
    }
}

// As far as it is certain: a whole number may be the first of many others.
TEST(Logs, TheTypeOfWhatAnUndeclaredNameGetsIsNamed) {
    for (const auto& [value, help] : {std::pair("mix( v, v, .5 )", ": vec3 shade = …"),
                                      {"texture( s, v.xy )", ": vec4 shade = …"},
                                      {"texture( s, v.xy ).rgb", ": vec3 shade = …"},
                                      {"dot( v, v )", ": float shade = …"},
                                      {"v.x > 0.", ": bool shade = …"},
                                      {"2", ""},
                                      {"unknown( v )", ""}}) {
        Translated t = fragment(
            "#version 330\nin vec3 v; uniform sampler2D s; out vec4 c;\nvoid main() { c = vec4(1.);\nshade = " +
            std::string(value) + ";\n}\n");
        Program program{std::move(t.sources), std::move(t.translation)};
        const Diagnostics said = program.explain("0:4(1): error: `shade' undeclared\n", program.stage(Stage::fragment));
        ASSERT_EQ(said.items().size(), 1U);
        EXPECT_EQ(said.items()[0].help, "where it first gets a value, its type comes before it" + std::string(help));
    }
}

// An initialiser that is no constant moves to main, and keeps its line.
TEST(Logs, InitialisersAreWrongWhereTheyAreWritten) {
    Translated t = fragment(
        "#version 330\nout vec4 c;\n\nconst float TWO_PI = 2 * PI;\n\nvoid main()\n{\n    c = vec4(TWO_PI);\n}\n");
    EXPECT_TRUE(t.diagnostics.items().empty()) << "not that it is computed at the start of main";
    Program program{std::move(t.sources), std::move(t.translation)};
    for (const auto& [log, place] : {std::pair("0:4(14): error: `PI' undeclared\n", "demo.frag:4:26"),
                                     {"0:8(5): error: `vec4' undeclared\n", "demo.frag:8:9"}}) {
        const Diagnostics said = program.explain(log, program.stage(Stage::fragment));
        ASSERT_EQ(said.items().size(), 1U);
        const Position at = program.sources.position(said.items()[0].span.file, said.items()[0].span.begin);
        EXPECT_EQ("demo.frag:" + std::to_string(at.line) + ":" + std::to_string(at.column), place);
    }
    const std::string& text = program.stage(Stage::fragment)->text;
    EXPECT_NE(text.find("{ \n#line 4 0\nTWO_PI = 2 * PI;\n#line 7 0\n\n    c"), std::string::npos) << text;
}

// What is allowed is not remembered as a misfit, or another error on its line would be explained by it.
TEST(Logs, OperandsThatFitAreNoMisfits) {
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

TEST(Logs, AnyBytesAreSurvived) {
    std::uint32_t seed = 1;
    const std::string alphabet = "0123:() '`\"\n\t.,;{}ERORerrowarning#CvNorml\xff";
    for (int round = 0; round < 3000; ++round) {
        std::string log = round % 2 ? "0:2(" : "ERROR: 0:1: ";
        for (int i = 0; i < 60; ++i) {
            seed = seed * 1664525u + 1013904223u;
            log += alphabet[(seed >> 16) % alphabet.size()];
        }
        Program program;
        program.add("demo.frag", round % 3 ? "void main() {\n  vNorml = 1 /* \n" : "");
        for (const StageOutput* stage : {program.stage(Stage::fragment), static_cast<const StageOutput*>(nullptr)}) {
            const Diagnostics found = program.explain(log, stage);
            for (const Diagnostic& d : found.items()) EXPECT_FALSE(d.message.empty());
        }
    }
}

}  // namespace
}  // namespace snell::glsl
