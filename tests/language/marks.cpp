// Symbols, colours, folds, semantic tokens and lenses.
#include <algorithm>

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
}

TEST(Colors, EditsKeepTheAuthorsStyle) {
    const std::array<double, 4> violet{128 / 255., .25, 1, 1};
    EXPECT_EQ(recolored(Editor("Background 0. .5 1\n"), 0, violet), "Background 0.502 .25 1\n");
    EXPECT_EQ(recolored(Editor("Background 1 1 1\n"), 0, {1, 0, 0, 1}), "Background 1 0 0\n");
    EXPECT_EQ(recolored(Editor("Color [1.0, 1.0, 1.0]\n"), 0, {0, .5, 1, 1}), "Color [0.0, 0.5, 1.0]\n");
    EXPECT_EQ(recolored(Editor("Color 1. 1. 1.\n"), 0, {1, 1, 1, .5}), "Color 1. 1. 1. 0.5\n");
    EXPECT_EQ(recolored(Editor("Color .1234 .5 .5\n"), 0, {.1234, .5, .5, 1}), "Color .1234 .5 .5\n");
    EXPECT_EQ(recolored(Editor("Program A uC {2. -1 5}\n"), 0, {.25, .5, 1, 1}), "Program A uC {0.25 .5 1}\n");
    EXPECT_EQ(recolored(Editor("Color 255 0 0\n"), 0, {1, .5, 0, 1}), "Color 1 .5 0\n");
    EXPECT_EQ(recolored(Editor("Program A uC {1 1 1}\n"), 0, {1, 1, 1, 0}), "Program A uC {1 1 1 0}\n");
}

std::vector<std::string> folded(const Editor& editor) {
    std::vector<std::string> lines;
    for (const Fold& fold : folds(editor.project(), editor.file())) {
        const auto line = [&](std::uint32_t at) {
            return std::to_string(editor.project().sources.position(editor.file(), at).line);
        };
        lines.push_back(line(fold.span.begin) + "-" + line(fold.span.end) +
                        (fold.kind == Fold::Kind::comment ? " comment" : ""));
    }
    return lines;
}

TEST(Folds, OfScenes) {
    EXPECT_EQ(
        folded(Editor(
            "# a\n# b\n\n# c\nProgram A \\\n  uKa 1.\nSphere\nRenderToTexture 7\nBox\nPushMatrix\nBox\nPopMatrix\n")),
        (std::vector<std::string>{"1-2 comment", "5-7", "5-6", "8-12", "10-12"}));
    EXPECT_TRUE(folded(Editor("Sphere\nBox # a\nCone # b\n")).empty());
}

TEST(Folds, OfShaders) {
    const Editor editor("Fragment a.frag\nProgram A\n",
                        {{"a.frag", "/* a\n b */\nvoid main()\n{\n#if A\n  f();\n#else\n  g();\n#endif\n}\n@"}});
    EXPECT_EQ(folded(editor), (std::vector<std::string>{"1-2 comment", "4-10", "5-6", "7-9"}));
}

std::string colored(const Editor& editor) {
    std::string text;
    constexpr const char* names[] = {"comment",  "keyword",   "number",   "string", "operator", "type", "function",
                                     "variable", "parameter", "property", "enum",   "macro",    "name"};
    for (const SemanticToken& token : semantic_tokens(editor.project(), editor.file()))
        text += (text.empty() ? "" : " ") + editor.text(token.span) + ":" + names[static_cast<int>(token.type)];
    return text;
}

TEST(SemanticTokens, OfScenes) {
    EXPECT_EQ(colored(Editor("Program A uKa <0. true>\n", none_else)),
              "Program:keyword A:name uKa:property 0.:number true:enum");
    EXPECT_EQ(colored(Editor("Fragment a.frag # b\n")), "Fragment:keyword a.frag:string # b:comment");
    EXPECT_EQ(colored(Editor("Ladder L a <b>\nCullFace back\n")),
              "Ladder:keyword L:macro a:enum b:enum CullFace:keyword back:enum");
}

TEST(SemanticTokens, OfShaders) {
    const Editor editor("Fragment a.frag\nProgram A\n",
                        {{"a.frag", "@uniform float uKa;\nfloat f(float k) { return mix(k, uKa, 1.); }\n"}});
    EXPECT_EQ(colored(editor),
              "uniform:keyword float:type uKa:variable float:type f:function float:type k:parameter return:keyword "
              "mix:function k:parameter uKa:variable 1.:number");
}

TEST(CodeLenses, StandAboveProgramsAndPasses) {
    const Editor editor("# scene\nPerspective 50\nRenderToTexture 7\nProgram A uKa 1.\nSphere\nProgram\nBox\n");
    const auto all = code_lenses(editor.project(), editor.file());
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].kind, CodeLens::Kind::open);
    EXPECT_EQ(all[1].kind, CodeLens::Kind::render);
    EXPECT_EQ(editor.text(all[1].span), "Perspective 50");
    EXPECT_EQ(all[2].name, "RenderToTexture");
    EXPECT_EQ(all[3].name, "A");
    EXPECT_EQ(all[3].kind, CodeLens::Kind::cost);
}

}  // namespace
}  // namespace snell::language
