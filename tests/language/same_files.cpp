// Files that are read by several names: links, "..", other cases.
#include "tests/language/help.h"

namespace snell::language {
namespace {

using Lines = std::vector<std::string>;

const std::string shader_text = "uniform float uKa;\nvoid main() { gl_FragColor = vec4(uKa); }\n";

TEST(SameFiles, AShaderOfTwoNamesIsOneForItsPrograms) {
    for (const std::string name :
         {"sub/../b.frag", "link.frag", "./sub\\..\\B.FRAG", "sub/far.frag", "folder/b.frag"}) {
        SCOPED_TRACE(name);
        const std::string scene =
            "Fragment b.frag\nProgram A uKa .3\nFragment " + name + "\nProgram B uKa .8\nSphere\n";
        std::string marked = shader_text;
        marked.insert(marked.find("uKa"), "@");
        const Editor editor(scene, {{"b.frag", marked}, {"sub/x", ""}},
                            {{"link.frag", "b.frag"}, {"sub/far.frag", "../b.frag"}, {"folder", "."}});
        EXPECT_EQ(editor.references(), (Lines{"b.frag:1 uKa", "b.frag:2 uKa", "scene.glib:2 uKa", "scene.glib:4 uKa"}));
        std::string after = scene;
        for (int i = 0; i < 2; ++i) after.replace(after.find("uKa"), 3, "uNew");
        EXPECT_EQ(editor.renamed("uNew", "scene.glib"), after);
    }
}

TEST(SameFiles, FromTheSceneToo) {
    const Editor editor("Fragment link.frag\nProgram A u@Ka .3\nFragment b.frag\nProgram B uKa .8\nSphere\n",
                        {{"b.frag", shader_text}}, {{"link.frag", "b.frag"}});
    EXPECT_EQ(editor.references(),
              (Lines{"link.frag:1 uKa", "link.frag:2 uKa", "scene.glib:2 uKa", "scene.glib:4 uKa"}));
    EXPECT_EQ(editor.file("b.frag"), editor.file("link.frag"));
}

TEST(SameFiles, AnIncludedTextIsEditedOnce) {
    for (const std::string name : {"sub/../common.glsl", "c2.glsl", "SUB/../Common.glsl"}) {
        SCOPED_TRACE(name);
        const Editor editor("Fragment b.frag\nProgram A\nSphere\n",
                            {{"b.frag", "#include \"common.glsl\"\n#include \"" + name +
                                            "\"\nvoid main() { gl_FragColor = vec4(h@elper(1.)); }\n"},
                             {"common.glsl", "#ifndef C\n#define C\nfloat helper(float k) { return k; }\n#endif\n"},
                             {"sub/x", ""}},
                            {{"c2.glsl", "common.glsl"}});
        EXPECT_EQ(editor.rename("hh").edits.size(), 2u);
        EXPECT_EQ(editor.renamed("hh", "common.glsl"),
                  "#ifndef C\n#define C\nfloat hh(float k) { return k; }\n#endif\n");
    }
}

// The text is one, but what it includes is beside the name by which it was included.
TEST(SameFiles, OtherFilesAreBesideTheOtherName) {
    const Editor editor("Fragment b.frag\nProgram A\nFragment two/b.frag\nProgram B\nSphere\n",
                        {{"b.frag", "#include \"part.glsl\"\nvoid main() { gl_FragColor = vec4(part@()); }\n"},
                         {"part.glsl", "float part() { return 1.; }\n"},
                         {"two/part.glsl", "float part() { return 2.; }\n"}},
                        {{"two/b.frag", "../b.frag"}});
    EXPECT_EQ(editor.references(), (Lines{"b.frag:2 part", "part.glsl:1 part", "part.glsl:1 part"}));
}

TEST(SameFiles, AnIncludedSceneIsEditedOnce) {
    const Editor editor("Include more.inc\nInclude link.inc\nSphere\n",
                        {{"more.inc", "Fragment b.frag\nProgram A u@Ka .3\n"}, {"b.frag", shader_text}},
                        {{"link.inc", "more.inc"}});
    EXPECT_EQ(editor.references(), (Lines{"b.frag:1 uKa", "b.frag:2 uKa", "more.inc:2 uKa"}));
}

// A name that leaves a link by ".." is another file than it seems.
TEST(SameFiles, LinksComeBeforeDots) {
    const Editor editor("Fragment link/../b.frag\nProgram A u@Ka .3\nSphere\n",
                        {{"b.frag", "void main() {}\n"}, {"deep/inner/x", ""}, {"deep/b.frag", shader_text}},
                        {{"link", "deep/inner"}});
    EXPECT_EQ(editor.file("b.frag"), ~FileId{0});
    EXPECT_EQ(editor.file("deep/b.frag"), editor.file("link/../b.frag"));
}

}  // namespace
}  // namespace snell::language
