// Students' mistakes, from their text through the translation and the driver to the message: it must stand at the
// user's own line and column, and say what is wrong.
#include <fmt/format.h>

#include "src/platform/headless.h"
#include "tests/compatibility/draw.h"
#include "tests/std.h"

namespace snell::oracle {
namespace {

constexpr std::string_view plain_vertex =
    "#version 330 compatibility\n"
    "out vec3 vNormal;\n"
    "out vec2 vST;\n"
    "void main() {\n"
    "    vNormal = gl_NormalMatrix * gl_Normal;\n"
    "    vST = gl_MultiTexCoord0.st;\n"
    "    gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n"
    "}\n";

struct Explained {
    Sources sources;
    Diagnostics diagnostics;

    std::string place(std::size_t i) const {
        const Span& span = diagnostics.items().at(i).span;
        const Position p = sources.position(span.file, span.begin);
        return fmt::format("{}:{}:{} {}", sources.name(span.file), p.line, p.column,
                           sources.text(span.file).substr(span.begin, span.end - span.begin));
    }
    const Diagnostic* first_error() const {
        for (const Diagnostic& d : diagnostics.items())
            if (d.severity == Severity::error) return &d;
        return nullptr;
    }
    std::string all() const { return render(diagnostics, sources); }
};

std::string log_of_stage(const glsl::StageOutput& stage) {
    // A stage alone: its own log comes first, and linking has nothing to add to one that does not compile.
    return build({{stage.stage, stage.text}}).log;
}

// Translates, compiles and links as a run would, and explains what goes wrong.
void explain(std::string_view vertex, std::string_view fragment, Explained& e) {
    const FileId scene = e.sources.add("demo.glib", "Program Demo");
    const FileId v = e.sources.add("demo.vert", std::string(vertex)),
                 f = e.sources.add("demo.frag", std::string(fragment));
    glsl::Options options;
    options.target = {.version = 450, .es = false, .fp64 = true};
    const Span where{scene, 0, 12};
    const auto t =
        glsl::translate({{Stage::vertex, v, where}, {Stage::fragment, f, where}}, e.sources, options, e.diagnostics);
    if (!t.ok) return;
    const std::size_t before = e.diagnostics.errors();
    Texts texts;
    for (const glsl::StageOutput& stage : t.stages) {
        texts[stage.stage] = stage.text;
        const std::string log = log_of_stage(stage);
        const bool compiled = log.find("0:") == std::string::npos || log.find("error") == std::string::npos;
        if (!compiled) glsl::explain_log(log, t, &stage, where, "Demo", e.sources, e.diagnostics);
    }
    if (e.diagnostics.errors() > before) return;
    const Program program = build(texts);
    if (!program.id) glsl::explain_log(program.log, t, nullptr, where, "Demo", e.sources, e.diagnostics);
}

struct Mistake {
    const char* name;
    const char* fragment;
    const char* place;    // file:line:column and the words marked
    const char* message;  // part of it
    const char* help;     // part of help or notes
};

constexpr Mistake mistakes[] = {
    {"undeclared",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n\tvec3  n = normalize( vNorml );\n\tgl_FragColor = "
     "vec4(n, 1.);\n}\n",
     "demo.frag:4:23 vNorml", "'vNorml' is not declared", "'vNormal'"},
    {"undeclared after legacy names",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    gl_FragColor = gl_Color * gl_ModelViewMatrix[0] "
     "+ vec4(uColr, 1.);\n}\nuniform vec3 uColor;\n",
     "demo.frag:4:60 uColr", "'uColr' is not declared", "'uColor'"},
    {"input forgotten", "#version 330 compatibility\nvoid main() {\n    gl_FragColor = vec4(vST, 0., 1.);\n}\n",
     "demo.frag:3:25 vST", "'vST' is not declared", "in vec2 vST"},
    {"vec4 to vec3",
     "#version 330 compatibility\nuniform sampler2D uTex;\nin vec2 vST;\nvoid main() {\n    vec3 c;\n    c = "
     "texture2D(uTex, vST);\n    gl_FragColor = vec4(c, 1.);\n}\n",
     "demo.frag:6:5 c", "a 'vec4' cannot be assigned to a 'vec3'", ".xyz"},
    {"vec3 to vec4", "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    gl_FragColor = vNormal;\n}\n",
     "demo.frag:4:5 gl_FragColor", "a 'vec3' cannot be assigned to a 'vec4'", "vec4(…, 1.)"},
    {"missing semicolon",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    float d = abs(vNormal.z)   // here\n\n    "
     "gl_FragColor = vec4(d);\n}\n",
     "demo.frag:6:5 gl_FragColor", "unexpected 'gl_FragColor'", "line 4 seems to lack a ';'"},
    {"no semicolon behind a varying",
     "varying vec3 vNormal\nvarying vec2 vST;\nvoid main() {\n    gl_FragColor = vec4(vNormal, vST.s);\n}\n",
     "demo.frag:1:20 l", "a ';' is missing after this", ""},
    {"no semicolon before a varying",
     "uniform float uKd // of light\nvarying vec2 vST;\nvoid main() {\n    gl_FragColor = vec4(vST.s);\n}\n",
     "demo.frag:1:17 d", "a ';' is missing after this", ""},
    {"no semicolon between a varying and main", "varying vec2 vST\nvoid main() {\n    gl_FragColor = vec4(vST.s);\n}\n",
     "demo.frag:1:16 T", "a ';' is missing after this", ""},
    {"no semicolon behind a structure",
     "struct Light { vec3 color; }\nLight one() { return Light(vec3(1.)); }\nvoid main() {\n    gl_FragColor = "
     "vec4(one().color, 1.);\n}\n",
     "demo.frag:1:28 }", "a ';' is missing after this", "of a struct"},
    {"varying within a function", "void main() {\n    varying vec2 vST;\n    gl_FragColor = vec4(vST.s);\n}\n",
     "demo.frag:2:18 vST", "'vST' cannot be declared within a function", "above"},
    {"missing brace before a varying",
     "float f() {\n    return 1.;\nvarying vec2 vST;\nvoid main() {\n    gl_FragColor = vec4(vST.s);\n}\n",
     "demo.frag:4:13 {", "unexpected '{'", "this '{' is never closed"},
    {"missing brace",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    if (vNormal.x > 0.) {\n        gl_FragColor = "
     "vec4(1.);\n    gl_FragColor = vec4(0.);\n}\n",
     "demo.frag:4:25 {", "'{' is never closed", "close it"},
    {"missing parenthesis",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    gl_FragColor = vec4(abs(vNormal, 1.;\n}\n",
     "demo.frag:4:40 ;", "", "')' is missing"},
    {"call of a macro without its end",
     "#version 330 compatibility\n#define TWICE(x) (2. * (x))\nin vec2 vST;\nvoid main() {\n    float a = "
     "TWICE(vST.s;\n    gl_FragColor = vec4(a);\n}\n",
     "demo.frag:5:20 (", "'(' is never closed", "close it with ')'"},
    {"surplus brace", "#version 330 compatibility\nvoid main() {\n    gl_FragColor = vec4(1.);\n}\n}\n",
     "demo.frag:5:1 }", "'}'", "more '}' than '{'"},
    {"arguments of a built-in",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    gl_FragColor = vec4(mix(vNormal, vec3(1.)), "
     "1.);\n}\n",
     "demo.frag:4:25 mix", "no function 'mix' takes (vec3, vec3)", "takes 3 arguments"},
    {"unknown function",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    gl_FragColor = vec4(normalise(vNormal), "
     "1.);\n}\n",
     "demo.frag:4:25 normalise", "there is no function 'normalise'", "'normalize'"},
    {"unknown type",
     "#version 330 compatibility\nvoid main() {\n    vex3 c = vec3(1., 0., 0.);\n    gl_FragColor = vec4(c, "
     "1.);\n}\n",
     "demo.frag:3:5 vex3", "'vex3' is not a type", "'vec3'"},
    {"conversion beside a constructor of that type",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() { vec3 c = abs(gl_Color); gl_FragColor = "
     "vec4(c, 1.); }\n",
     "demo.frag:3:15 vec3", "a 'vec4' cannot be assigned to a 'vec3'", ".xyz"},
    {"type of a size that is not there",
     "#version 330 compatibility\nvoid main() {\n    vec5 c = vec5(1.);\n    gl_FragColor = vec4(1.);\n}\n",
     "demo.frag:3:5 vec5", "'vec5' is not a type", "vec2, vec3 and vec4"},
    {"type of another language",
     "#version 330 compatibility\nvoid main() {\n    string c;\n    gl_FragColor = vec4(1.);\n}\n",
     "demo.frag:3:5 string", "'string' is not a type", ""},
    {"too few components",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    gl_FragColor = vec4(vNormal);\n}\n",
     "demo.frag:4:20 vec4", "too few components", "vec3 and a float"},
    {"operands",
     "#version 330 compatibility\nin vec3 vNormal;\nvoid main() {\n    vec3 c = vNormal + gl_Color;\n    gl_FragColor "
     "= vec4(c, 1.);\n}\n",
     "demo.frag:4:14 vNormal + gl_Color", "'+' does not take a 'vec3' and a 'vec4'", ".xyz"},
    {"main misspelt", "#version 330 compatibility\nvoid Main() {\n    gl_FragColor = vec4(1.);\n}\n",
     "demo.frag:2:6 Main", "no function 'main'", "instead of 'Main'"},
    {"assignment to a constant",
     "#version 330 compatibility\nconst float uA = 2.;\nvoid main() {\n    uA = 1.;\n    gl_FragColor = vec4(uA);\n}\n",
     "demo.frag:4:5 uA", "'uA' cannot be assigned to", "copy it"},
    {"declared twice",
     "#version 330 compatibility\nvoid main() {\n    float a = 1.;\n    float a = 2.;\n    gl_FragColor = "
     "vec4(a);\n}\n",
     "demo.frag:4:11 a", "'a' is declared twice", "first declared here"},
    {"swizzle", "#version 330 compatibility\nin vec2 vST;\nvoid main() {\n    gl_FragColor = vec4(vST.xyz, 1.);\n}\n",
     "demo.frag:4:29 xyz", "'.xyz' asks for components", ""},
    {"return type",
     "#version 330 compatibility\nin vec3 vNormal;\nvec3 f() {\n    return gl_Color;\n}\nvoid main() { gl_FragColor = "
     "vec4(f(), 1.); }\n",
     "demo.frag:4:5 return", "the value returned is no 'vec3'", "declares that it returns 'vec3'"},
    {"commas in a for",
     "#version 330 compatibility\nin vec2 vST;\nvoid main() {\n    for (int i = 0, i < 3, i++) gl_FragColor = "
     "vec4(1.);\n}\n",
     "demo.frag:4:23 <", "unexpected '<'", "separated by ';'"},
    {"semicolon in a macro",
     "#version 330 compatibility\nin vec2 vST;\n#define PI 3.14;\nvoid main() {\n    gl_FragColor = vec4(PI * "
     "2.);\n}\n",
     "demo.frag:5:25 PI", "", "the macro 'PI' ends with a ';'"},
    {"function in a function",
     "#version 330 compatibility\nin vec2 vST;\nvoid main() {\n    float f() { return 1.; }\n    gl_FragColor = "
     "vec4(f());\n}\n",
     "demo.frag:4:15 {", "unexpected '{'", "inside another"},
    {"no semicolon before a brace",
     "#version 330 compatibility\nin vec2 vST;\nvoid main() {\n    gl_FragColor = vec4(1.) }\n", "demo.frag:4:29 }",
     "unexpected '}'", "missing before '}'"},
    {"typographic quote", "#version 330 compatibility\nin vec2 vST;\nvoid main() {\n    gl_FragColor = vec4(1.)’;\n}\n",
     "demo.frag:4:28 ’", "GLSL does not know", "pasted"},
    {"scope",
     "#version 330 compatibility\nin vec2 vST;\nvoid main() {\n    if (vST.s > 0.) { float d = 1.; }\n    gl_FragColor "
     "= vec4(d);\n}\n",
     "demo.frag:5:25 d", "'d' is not declared", "inside the { }"},
};

TEST(Errors, StandAtTheUsersOwnWords) {
    std::string error;
    const auto context = HeadlessContext::make({.version = 45}, error);
    if (!context) GTEST_SKIP() << "no graphics: " << error;
    for (const Mistake& m : mistakes) {
        SCOPED_TRACE(m.name);
        Explained e;
        explain(plain_vertex, m.fragment, e);
        const Diagnostic* first = e.first_error();
        EXPECT_TRUE(first) << e.all();
        if (!first) continue;
        const auto index = static_cast<std::size_t>(first - e.diagnostics.items().data());
        EXPECT_EQ(e.place(index), m.place) << e.all();
        EXPECT_NE(first->message.find(m.message), std::string::npos) << e.all();
        std::string hints = first->help;
        for (const Note& note : first->notes) hints += "\n" + note.message;
        EXPECT_NE(hints.find(m.help), std::string::npos) << e.all();
        EXPECT_EQ(e.diagnostics.errors(), 1u) << e.all();
        EXPECT_EQ(first->message.find("snell_"), std::string::npos) << e.all();
    }
}

}  // namespace
}  // namespace snell::oracle
