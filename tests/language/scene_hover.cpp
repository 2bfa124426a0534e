// What is said of the words of a scene.
#include "tests/language/help.h"

namespace snell::language {
namespace {

bool says(const Editor& editor, std::string_view what) {
    const std::string text = editor.hover();
    EXPECT_NE(text.find(what), std::string::npos) << text;
    return text.find(what) != std::string::npos;
}

TEST(HoverScene, CommandsHaveTheirRowAndPicture) {
    const Editor editor("Cu@be 1 2 3\n");
    says(editor, "Box dx=2 dy=2 dz=2");
    says(editor, "`Cube` means the same");
    EXPECT_EQ(hover(editor.project(), editor.file(), editor.offset())->picture, "images/Box.png");
    says(Editor("Filt@er linear"), "glman does not know");
}

TEST(HoverScene, NumbersTellTheirArgument) {
    says(Editor("Sphere 1 6@0 60"), "**slices** of `Sphere`: whole number; default: 60");
    says(Editor("Scale 1 2@ 3"), "**sy** of `Scale`");
    says(Editor("Scale @2"), "**s** of `Scale`");
    says(Editor("Sphere 1 2 3 @4"), "no such argument");
    says(Editor("RenderToCube 6 [1 @2 3]"), "y of **center**");
    says(Editor("CubeMap 6 a.bmp s@rgb"), "**encoding** of `CubeMap`");
}

TEST(HoverScene, UniformsTellTheirTypeAndWhereTheyAreSet) {
    const std::string scene = "Vertex a.vert\nFragment a.frag\nProgram A uK@a <0. .2 1.>\nSphere\n";
    says(Editor(scene, shaders()), "uniform float uKa");
    says(Editor(scene, shaders()), "a.frag:2");
    says(Editor(scene, shaders()), "Program 'A' sets it at scene.glib:3: `<0. .2 1.>`");
    says(Editor("Fragment a.frag\nProgram A uKa <0. @.2 1.>\n", shaders()), "Current value of `uKa`");
    says(Editor("Fragment a.frag\nProgram A uKa <@0. .2 1.>\n", shaders()), "Minimum of `uKa`");
    says(Editor("Fragment a.frag\nProgram A uColor {1 @0 0 1}\n", shaders()), "Green of `uColor`");
    says(Editor("Fragment a.frag\nProgram A uK@x 1.\n", shaders()), "no shader of this program declares it");
}

TEST(HoverScene, LaddersAndFiles) {
    says(Editor("Ladder BEN@D none <both>\n"), "none **<both>**");
    says(Editor("Ladder BEND no@ne <both>\n"), "`#if BEND == BEND_none`");
    says(Editor("Fragment gone.fr@ag\nProgram A\nSphere"), "there is no such file");
    EXPECT_EQ(Editor("# Sph@ere").hover(), "");
    EXPECT_EQ(Editor("Sphere\n@\nBox").hover(), "");
}

TEST(HoverScene, PicturesAreShown) {
    const auto shown = [](const Editor& editor) {
        return hover(editor.project(), editor.file(), editor.offset())->picture;
    };
    const std::map<std::string, std::string> files{{"Wood one.BMP", "BM"}, {"room.exr", "v"}};
    const std::string wood = shown(Editor("Texture2D 5 \"wood @one.bmp\"\nSphere\n", files));
    EXPECT_TRUE(wood.starts_with('/') && wood.ends_with("/Wood one.BMP")) << wood;
    EXPECT_EQ(shown(Editor("Texture2D 5 room@.exr\nSphere\n", files)), "") << "editors do not know the format";
    EXPECT_EQ(shown(Editor("Texture2D 5 gone@.png\nSphere\n", files)), "");
}

TEST(SignatureScene, TheCurrentParameterAndAlternative) {
    const SignatureHelp scale = Editor("Scale 1 @").signature();
    ASSERT_EQ(scale.signatures.size(), 2u);
    EXPECT_EQ(scale.signature, 1u);
    EXPECT_EQ(scale.parameter, 1u);
    EXPECT_EQ(Editor("Background @").signature().signature, 0u) << "what may be left out is not missing";
    const SignatureHelp sphere = Editor("Sphere 1 60@").signature();
    ASSERT_EQ(sphere.signatures.size(), 1u);
    EXPECT_EQ(sphere.parameter, 1u);
    const auto [begin, end] = sphere.signatures[0].parameters.at(1);
    EXPECT_EQ(sphere.signatures[0].label.substr(begin, end - begin), "slices=60");
    EXPECT_TRUE(Editor("Sph@ere 1").signature().signatures.empty());
    EXPECT_TRUE(Editor("Sphere 1\n@").signature().signatures.empty());
    EXPECT_EQ(Editor("Texture2D 5 pic.bmp @").signature().signature, 1u);
}

}  // namespace
}  // namespace snell::language
