// What is offered and said in shaders.
#include "shaders/embedded.h"
#include "src/glsl/read/words.h"
#include "src/language/shader/builtins.h"
#include "tests/language/help.h"

namespace snell::language {
namespace {

const std::string program =
    "Vertex a.vert\nFragment a.frag\nProgram A uKa <0. .2 1.> uWanted <0. 1. 2.> uTint {1 1 1 1}\nSphere\n";

// The fragment shader of a scene, with a cursor.
Editor shader(std::string_view text, const std::string& scene = program) {
    return {scene, {{"a.vert", std::string(vertex)}, {"a.frag", std::string(text)}}};
}

bool offers(const Editor& editor, std::string_view label) { return find(editor.completions(), label) != nullptr; }

TEST(CompleteShader, NamesOfTheLanguageAndTheText) {
    const Editor editor = shader(
        "uniform float uKa;\nvarying vec3 vN;\n#define TWICE(x) (2. * x)\nconst float PI = 3.14;\n"
        "float shade(float k) { return k; }\nvoid main() {\n    float near = 1.;\n    { float inner = 2.; }\n"
        "    gl_FragColor = vec4(@);\n    float later = 1.;\n}\n");
    const auto all = editor.completions();
    for (const std::string_view wanted : {"uKa", "vN", "TWICE", "PI", "shade", "near", "refract", "gl_FragCoord",
                                          "gl_FragColor", "texture2D", "vec3", "uTime", "uWanted"})
        EXPECT_NE(find(all, wanted), nullptr) << wanted;
    for (const std::string_view other : {"inner", "later", "gl_Vertex", "aVertex", "gl_TessCoord", "main"})
        EXPECT_EQ(find(all, other), nullptr) << other;
    EXPECT_EQ(find(all, "shade")->detail, "float shade(float k)");
    EXPECT_NE(find(all, "refract")->documentation.find("index of refraction"), std::string::npos);
    EXPECT_LT(find(all, "near")->rank, find(all, "refract")->rank);
    // A loop without braces reaches to the end of its statement, whatever branches that has.
    const std::string loop =
        "void main() {\n    for (int turn = 0; turn < 3; ++turn) if (turn > 1) gl_FragColor.x += 1.;";
    EXPECT_TRUE(offers(shader(loop + " else gl_FragColor.x = @; }\n"), "turn"));
    EXPECT_FALSE(offers(shader(loop + " gl_FragColor.x = @; }\n"), "turn"));
}

TEST(CompleteShader, TheDialectDecides) {
    const Editor core = shader("#version 330 core\nout vec4 f;\nvoid main() { f = @; }\n");
    EXPECT_FALSE(offers(core, "texture2D"));
    EXPECT_FALSE(offers(core, "gl_FragColor"));
    EXPECT_TRUE(offers(core, "texture"));
    EXPECT_TRUE(offers(shader("#version 330 compatibility\nvoid main() { @ }\n"), "gl_FragColor"));
}

TEST(CompleteShader, NothingInCommentsNumbersAndNewNames) {
    EXPECT_TRUE(shader("void main() { // re@\n}").completions().empty());
    EXPECT_TRUE(shader("void main() { /* re@ */ }").completions().empty());
    EXPECT_TRUE(shader("void main() { float x = 1.@; }").completions().empty());
    EXPECT_TRUE(shader("void main() { float re@ }").completions().empty());
    EXPECT_TRUE(shader("#version 33@0\nvoid main() {}").completions().empty());
    EXPECT_FALSE(shader("void main() { /* re */@ }").completions().empty());
}

TEST(CompleteShader, WhatTheSceneSetsIsDeclared) {
    EXPECT_EQ(
        completed(shader("#version 120\nuniform float uKa;\nvoid main() { gl_FragColor = vec4(uWan@); }\n"), "uWanted"),
        "#version 120\nuniform float uWanted;\nuniform float uKa;\nvoid main() { gl_FragColor = vec4(uWanted); }\n");
    EXPECT_EQ(completed(shader("#version 120\r\nvoid main() { gl_FragColor = @; }\r\n"), "uTint"),
              "#version 120\r\nuniform vec4 uTint;\r\nvoid main() { gl_FragColor = uTint; }\r\n");
    EXPECT_EQ(completed(shader("uniform @\nvoid main() {}"), "float uWanted;"),
              "uniform float uWanted;\nvoid main() {}");
    EXPECT_EQ(completed(shader("@\nvoid main() {}"), "uniform float uKa;"), "uniform float uKa;\nvoid main() {}");
    EXPECT_FALSE(offers(shader("uniform float uKa;\n@\nvoid main() {}"), "uniform float uKa;"));
    EXPECT_EQ(completed(shader("#version 120\nvoid main() { float t = uTi@; }\n"), "uTime"),
              "#version 120\nuniform float uTime;\nvoid main() { float t = uTime; }\n");
    EXPECT_EQ(completed(shader("#version 120\nvoid main() { gl_FragColor.xyz = uTu@[0]; }\n",
                               "Vertex a.vert\nFragment a.frag\nProgram A uTurn [1 0 0 0 1 0 0 0 1]\nSphere\n"),
                        "uTurn"),
              "#version 120\nuniform mat3 uTurn;\nvoid main() { gl_FragColor.xyz = uTurn[0]; }\n");
}

TEST(CompleteShader, Members) {
    EXPECT_EQ(labels(shader("void main() { vec2 st; st.@ }").completions()),
              (std::vector<std::string>{"x", "y", "xy", "r", "g", "rg"}));
    EXPECT_EQ(
        labels(shader("struct Ray { vec3 from; float far; };\nvoid main() { Ray rays[2]; rays[1].@ }").completions()),
        (std::vector<std::string>{"from", "far"}));
    EXPECT_TRUE(offers(shader("void main() { gl_LightSource[0].@ }"), "spotCutoff"));
    EXPECT_TRUE(offers(shader("struct A { vec3 p; };\nstruct B { A a; };\nvoid main() { B b; b.a.@ }"), "p"));
    EXPECT_TRUE(shader("void main() { float x; x.@ }").completions().empty());
    EXPECT_TRUE(shader("void main() { unknown.@ }").completions().empty());
}

TEST(CompleteShader, Directives) {
    EXPECT_TRUE(offers(shader("#@\n"), "ifdef"));
    EXPECT_FALSE(offers(shader("#@\n"), "vec3"));
    const Editor editor("Ladder BEND none both\nFragment a.frag\nProgram A\n",
                        {{"a.frag", "#if BEND == @\n#endif\nvoid main() {}"}});
    EXPECT_TRUE(offers(editor, "BEND_both"));
    const Editor included("Fragment a.frag\nProgram A\n",
                          {{"a.frag", "#include \"@\"\nvoid main() {}"}, {"b.glsl", ""}, {"c.png", ""}});
    EXPECT_EQ(labels(included.completions()), std::vector<std::string>{"b.glsl"});
    EXPECT_TRUE(offers(shader("#include <@>\n"), "snell/fresnel.glsl"));
}

TEST(HoverShader, NamesTellWhatTheyAre) {
    const auto says = [](std::string_view text, std::string_view what) {
        const std::string said = shader(text).hover();
        EXPECT_NE(said.find(what), std::string::npos) << text << "\n" << said;
    };
    says("void main() { refr@act(a, b, 1.); }", "genType refract(genType I, genType N, float eta)");
    says("void main() { texture@2D(a, b); }", "Today it is called `texture`");
    says("void main() { gl_Frag@Coord; }", "vec4 gl_FragCoord");
    says("uniform float uKa; // ambient\nvoid main() { u@Ka; }", "uniform float uKa");
    says("uniform float uKa; // ambient\nvoid main() { u@Ka; }", "ambient");
    says("uniform float uKa;\nvoid main() { u@Ka; }", "Program 'A' sets it at scene.glib:3: `<0. .2 1.>`");
    says("uniform float uTime;\nvoid main() { u@Time; }", "snell sets it: Time of the animation");
    says("void main() { u@Wanted; }", "Program 'A' sets it");
    says("// The light.\nfloat shade(float k) { return k; }\nvoid main() { sh@ade(1.); }", "The light.");
    says("void main() { vec3 here; he@re; }", "vec3 here");
    says("struct Ray { vec3 from; };\nvoid main() { Ray r; r.fr@om; }", "vec3 from");
    EXPECT_EQ(shader("void main() { // refr@act\n}").hover(), "");
}

TEST(SignatureShader, CallsOfTheLanguageAndOfTheText) {
    const SignatureHelp mixed = shader("void main() { mix(a, f(b, c), @ }").signature();
    ASSERT_FALSE(mixed.signatures.empty());
    EXPECT_EQ(mixed.parameter, 2u);
    EXPECT_EQ(mixed.signatures[0].label, "genType mix(genType a, genType b, genType t)");
    const SignatureHelp own =
        shader("float shade(vec3 n, float k) { return k; }\nvoid main() { shade(vec3(1., 2., 3.), @) }").signature();
    ASSERT_EQ(own.signatures.size(), 1u);
    EXPECT_EQ(own.signatures[0].label, "float shade(vec3 n, float k)");
    EXPECT_EQ(own.parameter, 1u);
    const auto [begin, end] = own.signatures[0].parameters.at(1);
    EXPECT_EQ(own.signatures[0].label.substr(begin, end - begin), "float k");
    EXPECT_EQ(shader("void main() { atan(y, @) }").signature().signature, 0u);
    EXPECT_TRUE(shader("void main() { if (@) }").signature().signatures.empty());
    EXPECT_TRUE(shader("float shade(vec3 n, @float k) { return k; }").signature().signatures.empty());
}

TEST(ShaderTables, EveryFunctionIsDocumentedWithAllItsParameters) {
    for (const glsl::BuiltinFunction& function : glsl::builtin_functions()) {
        EXPECT_FALSE(function.doc.empty()) << function.name;
        for (const std::string& signature : function_signatures(function.name)) {
            EXPECT_EQ(signature.find(" ,"), std::string::npos) << signature;
            EXPECT_EQ(signature.find(" )"), std::string::npos) << signature;
        }
    }
    for (const std::string_view name : function_names(true)) EXPECT_FALSE(function_signatures(name).empty()) << name;
}

TEST(ShaderTables, TheHeadersAreThoseOfTheLibrary) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator("shaders/snell")) {
        ++files;
        const std::string name = "snell/" + entry.path().filename().string();
        EXPECT_NE(std::find(library_headers().begin(), library_headers().end(), name), library_headers().end()) << name;
    }
    EXPECT_EQ(files, library_headers().size());
}

}  // namespace
}  // namespace snell::language
