// What is offered in scenes, and what is not.
#include "tests/language/help.h"

namespace snell::language {
namespace {

TEST(CompleteScene, CommandsComeWithTheirArguments) {
    const Editor editor("Persp@", {});
    const auto all = editor.completions();
    EXPECT_EQ(inserted(all, "Perspective"), "Perspective ${1:50}");
    EXPECT_EQ(inserted(all, "Sphere"), "Sphere ${1:1} ${2:60} ${3:60}");
    EXPECT_EQ(inserted(all, "CullFace"), "CullFace ${1|none,back,front|}");
    ASSERT_NE(find(all, "Sphere"), nullptr);
    EXPECT_TRUE(find(all, "Sphere")->snippet);
    EXPECT_NE(find(all, "Sphere")->documentation.find("poles on Y"), std::string::npos);
    EXPECT_EQ(editor.text(find(all, "Sphere")->replaced), "Persp");
}

TEST(CompleteScene, ThereIsNothingInCommentsAndTexts) {
    EXPECT_TRUE(Editor("# Sph@ere").completions().empty());
    EXPECT_TRUE(Editor("Sphere // @").completions().empty());
    EXPECT_TRUE(Editor("Sphere # a\n# @\nBox").completions().empty());
    EXPECT_TRUE(Editor("MessageBox \"Sph@ere\"").completions().empty());
    EXPECT_FALSE(Editor("Sphere # a\n@").completions().empty());
}

TEST(CompleteScene, ChoicesAreThoseOfTheArgument) {
    EXPECT_EQ(labels(Editor("CullFace @").completions()), (std::vector<std::string>{"back", "front", "none"}));
    const auto blend = labels(Editor("Blend o@").completions());
    EXPECT_NE(std::find(blend.begin(), blend.end(), "one_minus_src_alpha"), blend.end());
    EXPECT_NE(std::find(blend.begin(), blend.end(), "off"), blend.end());
    const auto second = labels(Editor("Blend one @").completions());
    EXPECT_EQ(std::find(second.begin(), second.end(), "off"), second.end());
    EXPECT_NE(std::find(second.begin(), second.end(), "zero"), second.end());
    EXPECT_TRUE(Editor("Sphere @").completions().empty());
}

TEST(CompleteScene, FilesAreThoseThatTheArgumentTakesAsTheyAreOnDisk) {
    const std::map<std::string, std::string> files{{"Glass.FRAG", ""},     {"glass.vert", ""},  {"Stripes.bmp", ""},
                                                   {"with blank.png", ""}, {"more/x.frag", ""}, {"notes.txt", ""},
                                                   {"ball.obj", ""}};
    EXPECT_EQ(labels(Editor("Fragment @", files).completions()), (std::vector<std::string>{"Glass.FRAG", "more/"}));
    EXPECT_EQ(labels(Editor("Fragment gl@", files).completions()), (std::vector<std::string>{"Glass.FRAG", "more/"}));
    EXPECT_EQ(completed(Editor("Fragment more/@\n", files), "x.frag"), "Fragment more/x.frag\n");
    EXPECT_EQ(completed(Editor("Texture2D 5 w@\n", files), "with blank.png"), "Texture2D 5 \"with blank.png\"\n");
    EXPECT_EQ(completed(Editor("Texture2D 5 \"w@\n", files), "with blank.png"), "Texture2D 5 \"with blank.png\"\n");
    EXPECT_EQ(completed(Editor("Texture2D 5 \"w@x\" raw\n", files), "with blank.png"),
              "Texture2D 5 \"with blank.png\" raw\n");
    EXPECT_EQ(completed(Editor("Fragment \"more/@\"\n", files), "x.frag"), "Fragment \"more/x.frag\"\n");
    const auto images = Editor("Texture2D 5 @", files).completions();
    EXPECT_EQ(inserted(images, "Stripes.bmp"), "Stripes.bmp");
    EXPECT_EQ(inserted(images, "with blank.png"), "\"with blank.png\"");
    EXPECT_EQ(find(images, "ball.obj"), nullptr);
    EXPECT_EQ(find(images, "notes.txt"), nullptr);
    EXPECT_EQ(labels(Editor("Obj @", files).completions()), (std::vector<std::string>{"ball.obj", "more/"}));
}

TEST(CompleteScene, UniformsThatShadersDeclareAndTheSceneDoesNotSet) {
    const Editor editor("Texture2D 6 64 64\nVertex a.vert\nFragment a.frag\nProgram A uKa <0. .2 1.> \\\n  @\nSphere\n",
                        shaders());
    const auto all = editor.completions();
    EXPECT_EQ(labels(all), (std::vector<std::string>{"uKd", "uColor", "uOn", "uPicture"}));
    EXPECT_EQ(inserted(all, "uKd"), "uKd <${1:0.} ${2:.6} ${3:1.}>");
    EXPECT_EQ(inserted(all, "uColor"), "uColor {${1:.8} ${2:.8} ${3:.8} ${4:1.}\\}");
    EXPECT_EQ(inserted(all, "uOn"), "uOn <${1:true}>");
    EXPECT_EQ(inserted(all, "uPicture"), "uPicture ${1:6}");
    EXPECT_NE(find(all, "uPicture")->documentation.find("the stripes"), std::string::npos);
    EXPECT_NE(find(all, "uKd")->documentation.find("a.frag:2"), std::string::npos);
}

TEST(CompleteScene, WhatSnellSetsIsNotOffered) {
    const Editor editor("Fragment t.frag\nProgram T @",
                        {{"t.frag", "uniform float uTime, uEta; uniform mat4 uViewMatrix; void main() {}"}});
    EXPECT_EQ(labels(editor.completions()), std::vector<std::string>{"uEta"});
    EXPECT_EQ(inserted(editor.completions(), "uEta"), "uEta <${1:.1} ${2:1.1} ${3:5.}>");
}

TEST(CompleteScene, RangesGoByInitialisersAndWords) {
    const auto proposed = [](std::string_view declaration, const std::string& name) {
        const Editor editor("Fragment t.frag\nProgram T @", {{"t.frag", std::string(declaration) + " void main() {}"}});
        const auto all = editor.completions();
        return find(all, name) == nullptr ? "" : find(all, name)->detail;
    };
    EXPECT_EQ(proposed("uniform float uX = 3.;", "uX"), "float <0. 3. 6.>");
    EXPECT_EQ(proposed("uniform float uX = -.5;", "uX"), "float <-1. -.5 1.>");
    EXPECT_EQ(proposed("uniform int uSteps;", "uSteps"), "int <1 8 64>");
    EXPECT_EQ(proposed("uniform float uLightX;", "uLightX"), "float <-20. 5. 20.>");
    EXPECT_EQ(proposed("uniform float uBeta;", "uBeta"), "float <0. .5 1.>");  // not uEta
    EXPECT_EQ(proposed("uniform vec3 uCentre;", "uCentre"), "vec3 [0. 0. 0.]");
    EXPECT_EQ(proposed("uniform vec3 uTintColor;", "uTintColor"), "vec3 {.8 .8 .8}");
    EXPECT_EQ(proposed("uniform mat2 uTurn;", "uTurn"), "mat2 [1. 0. 0. 1.]");
}

TEST(CompleteScene, ValuesBehindANameAndWithinItsBrackets) {
    const Editor bare("Fragment a.frag\nProgram A uOn @\n", shaders());
    EXPECT_EQ(labels(bare.completions()), (std::vector<std::string>{"<true>", "<false>"}));
    const Editor within("Fragment a.frag\nProgram A uOn <@\n", shaders());
    EXPECT_EQ(labels(within.completions()), (std::vector<std::string>{"true", "false"}));
    const Editor range("Fragment a.frag\nProgram A uKa @\n", shaders());
    EXPECT_EQ(labels(range.completions()), std::vector<std::string>{"<0. .2 1.>"});
    EXPECT_TRUE(Editor("Fragment a.frag\nProgram A uKa <0. @", shaders()).completions().empty());
    EXPECT_TRUE(Editor("Fragment a.frag\nProgram @", shaders()).completions().empty());
}

TEST(CompleteScene, RungsAreThoseThatShadersCompare) {
    const std::map<std::string, std::string> files{
        {"l.frag", "#if BEND == BEND_none\n#elif BEND == BEND_both\n#endif\nvoid main() {}\n"}};
    EXPECT_EQ(labels(Editor("Ladder BEND @\nFragment l.frag\nProgram L\n", files).completions()),
              (std::vector<std::string>{"both", "none"}));
    EXPECT_EQ(labels(Editor("Ladder BEND none @\nFragment l.frag\nProgram L\n", files).completions()),
              std::vector<std::string>{"both"});
    EXPECT_EQ(labels(Editor("Ladder @\nFragment l.frag\nProgram L\n", files).completions()),
              std::vector<std::string>{"BEND"});
}

TEST(CompleteScene, UnitsAreThoseThatFit) {
    const std::string textures = "Texture2D 7 64 64\nCubeMap 8 64\nTexture2D 9 a.bmp\n";
    EXPECT_EQ(labels(Editor(textures + "RenderToTexture @").completions()), std::vector<std::string>{"7"});
    EXPECT_EQ(labels(Editor(textures + "RenderToCube @").completions()), std::vector<std::string>{"8"});
    EXPECT_EQ(labels(Editor(textures + "Irradiance 11 @").completions()), std::vector<std::string>{"8"});
    EXPECT_EQ(labels(Editor(textures + "Texture2D @").completions()), std::vector<std::string>{"10"});
}

// ---- What is said of the words of a scene.

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
