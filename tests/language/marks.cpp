// Symbols and colours.
#include "tests/language/help.h"

namespace snell::language {
namespace {

std::string tree(const std::vector<Symbol>& symbols, const std::string& indent = "") {
    std::string text;
    for (const Symbol& symbol : symbols) text += indent + symbol.name + "\n" + tree(symbol.children, indent + "  ");
    return text;
}

const std::map<std::string, std::string> none_else;

TEST(Symbols, ProgramsHoldUniformsAndDrawsPassesHoldPrograms) {
    const Editor editor(
        "Ladder BEND none <both>\nTexture2D 7 64 64\nRenderToTexture 7\nProgram Low uKa 1. uKd <0 1 2>\nSphere 1\n"
        "RenderToTexture\nProgram High\nglBegin gl_points\nglVertex 1 2 3\nglEnd\nBox\n",
        none_else);
    EXPECT_EQ(tree(symbols(editor.project(), editor.file())),
              "BEND\n  none\n  both\nTexture2D\nRenderToTexture\n  Low\n    uKa\n    uKd\n    Sphere\n"
              "Window\n  High\n    glBegin\n    Box\n");
    const auto all = symbols(editor.project(), editor.file());
    EXPECT_NE(editor.text(all[3].children[0].children[0].span).find("glEnd"), std::string::npos);
    EXPECT_EQ(editor.text(all[2].span), "RenderToTexture 7\nProgram Low uKa 1. uKd <0 1 2>\nSphere 1");
}

TEST(Symbols, ShadersListWhatTheyDeclare) {
    const Editor editor("Fragment a.frag\nProgram A\n",
                        {{"a.frag",
                          "#define TWO 2\nuniform float uKa, uKd;\nstruct Ray { vec3 a; };\n"
                          "float f(float k) { float x = k; return x; }\nvoid main() {@}\n"}});
    EXPECT_EQ(tree(symbols(editor.project(), editor.file())), "TWO\nuKa\nuKd\nRay\n  a\nf\nmain\n");
}

// As drivers read it, whatever ends the lines.
TEST(Symbols, AContinuedCommentDeclaresNothing) {
    for (const std::string backslash : {"\\\n", "\\\r\n", "\\\\\n", "\\\\\r\n"}) {
        const Editor editor("Fragment a.frag\nProgram A\n",
                            {{"a.frag", "// in C:" + backslash + "uniform float uA;\nvoid main() {@}\n"}});
        EXPECT_EQ(tree(symbols(editor.project(), editor.file())), "main\n");
    }
}

std::string recolored(const Editor& editor, std::size_t which, const std::array<double, 4>& rgba) {
    const auto all = colors(editor.project(), editor.file());
    if (which >= all.size()) return "";
    return with_edits(editor.text("scene.glib"), editor.file(), color_edits(editor.project(), all[which].span, rgba));
}

TEST(Colors, AreFoundWhereNumbersAreColours) {
    const Editor editor(
        "Background 0 .5 1\nColor [1. 0. 0.]\nFragment a.frag\nProgram A uC {.1, .2, .3, .4} uV [1 1 1]\nglColor 1 1 0 "
        ".5\nTranslate 1 1 1\n",
        {{"a.frag", "void main() {}"}});
    const auto all = colors(editor.project(), editor.file());
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(editor.text(all[0].span), "0 .5 1");
    EXPECT_EQ(editor.text(all[1].span), "1. 0. 0.");
    EXPECT_EQ(editor.text(all[2].span), ".1, .2, .3, .4");
    EXPECT_EQ(all[2].rgba, (std::array<double, 4>{.1, .2, .3, .4}));
    EXPECT_EQ(all[0].rgba[3], 1);
    EXPECT_EQ(editor.text(all[3].span), "1 1 0 .5");
    const Editor beyond("Color 255 -1 .5\n");
    EXPECT_EQ(colors(beyond.project(), beyond.file()).at(0).rgba, (std::array<double, 4>{1, 0, .5, 1}));
}

TEST(Colors, EditsKeepTheAuthorsStyle) {
    const std::array<double, 4> violet{128 / 255., .25, 1, 1};
    EXPECT_EQ(recolored(Editor("Background 0. .5 1\n"), 0, violet), "Background 0.502 .25 1\n");
    EXPECT_EQ(recolored(Editor("Background 1 1 1\n"), 0, {1, 0, 0, 1}), "Background 1 0 0\n");
    EXPECT_EQ(recolored(Editor("Color [1.0, 1.0, 1.0]\n"), 0, {0, .5, 1, 1}), "Color [0.0, 0.5, 1.0]\n");
    EXPECT_EQ(recolored(Editor("Color 1. 1. 1.\n"), 0, {1, 1, 1, .5}), "Color 1. 1. 1. 0.5\n");
    EXPECT_EQ(recolored(Editor("Color .1234 .5 .5\n"), 0, {.1234, .5, .5, 1}), "Color .1234 .5 .5\n");
    EXPECT_EQ(recolored(Editor("Program A uC {2. -1 5}\n"), 0, {.25, .5, 1, 1}), "Program A uC {0.25 .5 1}\n");
    EXPECT_EQ(recolored(Editor("Color .5 .5 .5\n"), 0, {.51, .501, .5, 1}), "Color .51 .5 .5\n") << "of bytes";
    EXPECT_EQ(recolored(Editor("Color 255 0 0\n"), 0, {1, .5, 0, 1}), "Color 1 .5 0\n");
    EXPECT_EQ(recolored(Editor("Program A uC {1 1 1}\n"), 0, {1, 1, 1, 0}), "Program A uC {1 1 1 0}\n");
}

}  // namespace
}  // namespace snell::language
