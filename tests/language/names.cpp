// Definitions, references and renames: by scopes, stages and files.
#include "tests/language/help.h"

namespace snell::language {
namespace {

using Lines = std::vector<std::string>;

const std::string scene = "Vertex a.vert\nFragment a.frag\nProgram A uKa <0. .2 1.> uKd 1.\nSphere\n";

std::map<std::string, std::string> files(std::string_view text) {
    return {{"a.vert", std::string(vertex)}, {"a.frag", std::string(text)}};
}

TEST(Names, AUniformIsOneInTheSceneAndAllStages) {
    const Editor editor("Vertex b.vert\nFragment b.frag\nProgram A u@Ka <0. .2 1.>\nSphere\n",
                        {{"b.vert", "uniform float uKa;\nvoid main() { gl_Position = vec4(uKa); }\n"},
                         {"b.frag", "#include \"c.glsl\"\nvoid main() { gl_FragColor = vec4(uKa); }\n"},
                         {"c.glsl", "uniform float uKa;\n"}});
    EXPECT_EQ(editor.references(),
              (Lines{"b.frag:2 uKa", "b.vert:1 uKa", "b.vert:2 uKa", "c.glsl:1 uKa", "scene.glib:3 uKa"}));
    EXPECT_EQ(editor.definition(), (Lines{"b.vert:1 uKa", "c.glsl:1 uKa"}));
    EXPECT_EQ(editor.renamed("uAmbient", "b.frag"),
              "#include \"c.glsl\"\nvoid main() { gl_FragColor = vec4(uAmbient); }\n");
    EXPECT_EQ(editor.renamed("uAmbient", "scene.glib"),
              "Vertex b.vert\nFragment b.frag\nProgram A uAmbient <0. .2 1.>\nSphere\n");
}

TEST(Names, CommentsMembersAndHidingLocalsStay) {
    const Editor editor(
        scene,
        files("uniform float u@Ka; // uKa\nstruct S { float uKa; };\n"
              "float f(float uKa) { return uKa; }\n"
              "float g(S s) { return s.uKa * uKa; }\n"
              "void main() {\n    { float uKa = uKa; uKa += 1.; }\n    for (int uKa = 0; uKa < 2; ++uKa) f(1.);\n"
              "    gl_FragColor = vec4(uKa); /* uKa */\n}\n"));
    EXPECT_EQ(editor.renamed("uNew", "a.frag"),
              "uniform float uNew; // uKa\nstruct S { float uKa; };\n"
              "float f(float uKa) { return uKa; }\n"
              "float g(S s) { return s.uKa * uNew; }\n"
              "void main() {\n    { float uKa = uNew; uKa += 1.; }\n    for (int uKa = 0; uKa < 2; ++uKa) f(1.);\n"
              "    gl_FragColor = vec4(uNew); /* uKa */\n}\n");
}

TEST(Names, HidingEndsWithLoopsBlocksAndStatements) {
    const Editor editor(scene,
                        files("uniform float u@Ka;\nvoid f(float uKa);\nvoid main() {\n"
                              "    for (int uKa = 0; uKa < 1; ++uKa) for (;;) uKa;\n    uKa;\n"
                              "    while (bool uKa = false) { uKa; } uKa;\n    do { float uKa; } while (uKa > 0.);\n"
                              "    if (uKa > 0.) { float uKa; uKa; } else uKa;\n"
                              "    { struct T { float uKa; } t = T(uKa); t.uKa; }\n"
                              "    float x = uKa, uKa = x, y = uKa;\n}\n"));
    EXPECT_EQ(editor.renamed("uN", "a.frag"),
              "uniform float uN;\nvoid f(float uKa);\nvoid main() {\n"
              "    for (int uKa = 0; uKa < 1; ++uKa) for (;;) uKa;\n    uN;\n"
              "    while (bool uKa = false) { uKa; } uN;\n    do { float uKa; } while (uN > 0.);\n"
              "    if (uN > 0.) { float uKa; uKa; } else uN;\n"
              "    { struct T { float uKa; } t = T(uN); t.uKa; }\n"
              "    float x = uN, uKa = x, y = uKa;\n}\n");
}

TEST(Names, MacrosAndEveryBranchAreRenamed) {
    const Editor editor(scene, files("uniform float uKa;\n#define LIT(k) (k * uKa)\n#define SQUARE(uKa) (uKa * uKa)\n"
                                     "#if 0\nfloat f() { return uKa; }\n#else\nfloat f() { return 2. * uKa; }\n#endif\n"
                                     "void main() { gl_FragColor = vec4(u@Ka); }\n"));
    EXPECT_EQ(editor.renamed("uNew", "a.frag"),
              "uniform float uNew;\n#define LIT(k) (k * uNew)\n#define SQUARE(uKa) (uKa * uKa)\n"
              "#if 0\nfloat f() { return uNew; }\n#else\nfloat f() { return 2. * uNew; }\n#endif\n"
              "void main() { gl_FragColor = vec4(uNew); }\n");
}

TEST(Names, BranchesMayOpenTheSameBraceTwice) {
    const Editor editor(scene,
                        files("uniform float uKa;\n#ifdef A\nvoid main() {\n#else\nvoid main(void) {\n#endif\n"
                              "    float uKd = uKa;\n    gl_FragColor = vec4(uK@d);\n}\nfloat uKd() { return 1.; }\n"));
    EXPECT_EQ(editor.references(), (Lines{"a.frag:7 uKd", "a.frag:8 uKd"}));
}

TEST(Names, AVaryingPassesBetweenStages) {
    const Editor editor(
        scene, files("#version 330 compatibility\nin vec3 v@N;\nvoid main() { gl_FragColor = vec4(vN, 1.); }\n"));
    EXPECT_EQ(editor.references(), (Lines{"a.frag:2 vN", "a.frag:3 vN", "a.vert:2 vN", "a.vert:4 vN"}));
    EXPECT_EQ(editor.definition(), Lines{"a.vert:2 vN"});
}

TEST(Names, InputsOfVerticesAndOutputsOfFragmentsPassNowhere) {
    const Editor editor("Vertex b.vert\nFragment b.frag\nProgram A\n",
                        {{"b.vert", "#version 330\nin vec3 thing;\nvoid main() { gl_Position = vec4(thing, 1.); }\n"},
                         {"b.frag", "#version 330\nout vec4 th@ing;\nvoid main() { thing = vec4(1.); }\n"}});
    EXPECT_EQ(editor.references(), (Lines{"b.frag:2 thing", "b.frag:3 thing"}));
}

TEST(Names, FunctionsAreOfTheirStageUnlessAFileIsShared) {
    const std::map<std::string, std::string> own{
        {"b.vert", "float f() { return 1.; }\nvoid main() { f(); }\n"},
        {"b.frag", "float f();\nfloat f() { return 2.; }\nvoid main() { @f(); }\n"}};
    const Editor apart("Vertex b.vert\nFragment b.frag\nProgram A\n", own);
    EXPECT_EQ(apart.references(), (Lines{"b.frag:1 f", "b.frag:2 f", "b.frag:3 f"}));
    EXPECT_EQ(apart.definition(), Lines{"b.frag:2 f"});
    const std::map<std::string, std::string> shared{{"c.glsl", "float f() { return 1.; }\n"},
                                                    {"b.vert", "#include \"c.glsl\"\nvoid main() { f(); }\n"},
                                                    {"b.frag", "#include \"c.glsl\"\nvoid main() { @f(); }\n"}};
    const Editor both("Vertex b.vert\nFragment b.frag\nProgram A\n", shared);
    EXPECT_EQ(both.references(), (Lines{"b.frag:2 f", "b.vert:2 f", "c.glsl:1 f"}));
}

TEST(Names, ASharedShaderCoversAllItsPrograms) {
    const Editor editor(
        "Fragment s.frag\nVertex one.vert\nProgram One u@K 1.\nVertex two.vert\nProgram Two uK 2. uK 3.\n"
        "Fragment\nVertex three.vert\nProgram Three uK 4.\n",
        {{"s.frag", "uniform float uK; void main() { gl_FragColor = vec4(uK); }"},
         {"one.vert", "void main() {}"},
         {"two.vert", "uniform float uK; void main() { gl_Position = vec4(uK); }"},
         {"three.vert", "uniform float uK; void main() { gl_Position = vec4(uK); }"}});
    EXPECT_EQ(editor.renamed("uNew", "scene.glib"),
              "Fragment s.frag\nVertex one.vert\nProgram One uNew 1.\nVertex two.vert\nProgram Two uNew 2. uNew 3.\n"
              "Fragment\nVertex three.vert\nProgram Three uK 4.\n");
    EXPECT_EQ(editor.renamed("uNew", "two.vert"), "uniform float uNew; void main() { gl_Position = vec4(uNew); }");
    EXPECT_EQ(editor.renamed("uNew", "three.vert"), "uniform float uK; void main() { gl_Position = vec4(uK); }");
}

TEST(Names, IncludedScenesAndElementsOfArrays) {
    const Editor editor("Include more.inc\nSphere\n",
                        {{"more.inc", "Fragment s.frag\nProgram P uA[0] 1. uA[1] 2. uS.k 3.\n"},
                         {"s.frag",
                          "struct S { float k; };\nuniform S uS;\nuniform float u@A[2];\nvoid main() { gl_FragColor = "
                          "vec4(uA[1] * uS.k); }\n"}});
    EXPECT_EQ(editor.renamed("uB", "more.inc"), "Fragment s.frag\nProgram P uB[0] 1. uB[1] 2. uS.k 3.\n");
}

TEST(Names, LocalsAreRenamedInTheirFunction) {
    const Editor editor(scene,
                        files("float f(float k) { float a = k; return a; }\nvoid main() { float a@ = 1.; a += a; }\n"));
    EXPECT_EQ(editor.renamed("b", "a.frag"),
              "float f(float k) { float a = k; return a; }\nvoid main() { float b = 1.; b += b; }\n");
    EXPECT_EQ(editor.renamed("k", "a.frag"),
              "float f(float k) { float a = k; return a; }\nvoid main() { float k = 1.; k += k; }\n");
}

TEST(Names, RefusedRenames) {
    const Editor editor(scene,
                        files("uniform float u@Ka;\nuniform float uKd;\nfloat f() { float local = 1.; return local; }\n"
                              "void main() { gl_FragColor = vec4(uKa * uKd); }\n"));
    for (const std::string_view name :
         {"uKd", "f", "local", "vN", "float", "mix", "discard", "gl_Thing", "snellThing", "a b", "", "1x", "a__b",
          "uTime", "aVertex", "Sphere", "main", "GL_x", "texture2D"}) {
        EXPECT_NE(editor.rename(name).refused, "") << name;
        EXPECT_TRUE(editor.rename(name).edits.empty()) << name;
    }
    EXPECT_EQ(editor.rename("uKa").refused, "");
    const auto refused = [](std::string_view text, const std::string& of = scene) {
        const Editor other(of, files(text));
        return renaming(other.project(), other.file(), other.offset()).refused;
    };
    EXPECT_NE(refused("uniform float u@Time; void main() { uTime; }"), "");
    EXPECT_NE(refused("void main() { gl_Frag@Color; }"), "");
    EXPECT_NE(refused("void ma@in() {}"), "");
    EXPECT_NE(refused("void main() { refr@act(); }"), "");
    EXPECT_NE(refused("struct S { float a; }; void main() { S s; s.@a; }"), "");
    EXPECT_NE(refused("uniform float u@X;\n#define uX 1.\nvoid main() { uX; }"), "");
    EXPECT_NE(refused("#define J(a) u ## a\nuniform float u@X;\nvoid main() { J(X); }"), "");
    EXPECT_NE(refused("#include <snell/fresnel.glsl>\nvoid main() { snellFresnel@Exact(1., 1., 1.); }"), "");
    EXPECT_NE(refused("void main() { bl@ah; }"), "");
    EXPECT_NE(refused("float rou@nd(float x) { return x; }\nvoid main() { round(vec3(1.)); }"), "");
    EXPECT_EQ(refused("uniform float u@X; void main() { uX; }"), "");
    EXPECT_NE(refused("uniform float u\\\nX; void main() { u@X; }"), "");
    EXPECT_NE(refused("uniform float u@X; void main() { u\\\r\nX; }"), "");
    EXPECT_NE(refused("void main() { float lo@cal = 1.; lo\\\ncal; }"), "");
    EXPECT_EQ(refused("#define F(a) \\\n    a\nuniform float u@X; void main() { F(uX); }"), "");
    // In another text of the program.
    for (const std::string_view text : {"#define J(a) u ## a\nvoid main() { J(Ka); }", "void main() { u\\\nKa; }"})
        EXPECT_NE(Editor("Vertex b.vert\nFragment a.frag\nProgram A u@Ka 1.\n",
                         {{"b.vert", std::string(text)}, {"a.frag", "uniform float uKa; void main() { uKa; }"}})
                      .rename("uNew")
                      .refused,
                  "");
    const Editor vertices(
        "Vertex b.vert\nProgram A\n",
        {{"b.vert", "#version 330\nin vec3 my@Pos;\nvoid main() { gl_Position = vec4(myPos, 1.); }"}});
    EXPECT_NE(vertices.rename("other").refused, "");
}

TEST(Names, LaddersAndFilesAreFound) {
    const std::string ladder = "Ladder BEND none <both>\nFragment l.frag\nProgram L\n";
    const std::string text = "#include \"c.glsl\"\n#if BEND == BEND_both\n#endif\nvoid main() {}\n";
    const auto at = [&](std::string marked) { return Editor(ladder, {{"l.frag", std::move(marked)}, {"c.glsl", ""}}); };
    EXPECT_EQ(at("#include \"c.glsl\"\n#if BE@ND == BEND_both\n#endif\nvoid main() {}\n").definition(),
              Lines{"scene.glib:1 BEND"});
    EXPECT_EQ(at("#include \"c.glsl\"\n#if BEND == BEND_b@oth\n#endif\nvoid main() {}\n").definition(),
              Lines{"scene.glib:1 both"});
    EXPECT_EQ(at("#include \"c.@glsl\"\nvoid main() {}\n").definition(), Lines{"c.glsl:1 "});
    EXPECT_EQ(Editor("Ladder BEND none <bo@th>\nFragment l.frag\nProgram L\n", {{"l.frag", text}, {"c.glsl", ""}})
                  .references(),
              (Lines{"l.frag:2 BEND_both", "scene.glib:1 both"}));
    EXPECT_EQ(Editor("Fragment l.fr@ag\nProgram L\n", {{"l.frag", text}, {"c.glsl", ""}}).definition(),
              Lines{"l.frag:1 "});
}

}  // namespace
}  // namespace snell::language
