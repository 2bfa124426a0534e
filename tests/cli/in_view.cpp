// A picture that shows nothing of its scene is said to, with the option that shows something.
#include <gtest/gtest.h>

#include "tests/cli/run.h"
#include "tests/pattern.h"
#include "tests/scratch.h"

namespace snell::test {
namespace {

class InView : public testing::Test {
protected:
    Outcome render(const std::string& text, const std::string& arguments = {}, const std::string& to = "o.png") {
        folder.write("s.glib", text);
        const std::string size = arguments.find("--size") == std::string::npos ? "--size 64x48 " : "";
        return snell("render " + size + folder.path("s.glib") + " -o '" + folder.path(to) + "' " + arguments);
    }
    static bool warns(const Outcome& outcome) { return outcome.says("[nothing-in-view]"); }
    // The option that the warning names is tried: the warning is gone, and the picture is another.
    void expect_mended(const std::string& text, const std::string& arguments = {}) {
        const Outcome first = render(text, arguments);
        EXPECT_EQ(first.status, 0) << first.output;
        EXPECT_TRUE(warns(first)) << text << first.output;
        const std::string empty = bytes_of(folder.path("o.png"));
        const auto told = matches(first.output, "'(--view [^']+)' shows it");
        ASSERT_EQ(told.size(), 1U) << first.output;
        const std::string& option = told[0][1];
        const Outcome second = render(text, arguments + " " + option);
        EXPECT_FALSE(warns(second)) << text << option << second.output;
        EXPECT_NE(bytes_of(folder.path("o.png")), empty) << option;
    }
    Scratch folder;
};

// The eye is at the origin, where most scenes have their objects.
TEST_F(InView, TheOptionShowsWhatIsMissing) {
    for (const char* scene :
         {"QuadXY 0 1\n", "Translate 0 0 5\nBox\n", "CullFace back\nSphere .5\n", "Translate 40 -7 30\nTorus\n",
          "LookAt 0 0 4 0 0 8\nTeapot\n", "Ortho\nTranslate 30 0 -5\nSphere\n", "CullFace back\nSphere 5000\n"})
        expect_mended(scene);
}

TEST_F(InView, InEveryContext) {
    for (const char* context : {"3.3", "es3.0"})
        expect_mended("Translate 0 0 5\nBox\n", std::string("--context ") + context);
}

TEST_F(InView, WhatIsInViewIsNotSpokenOf) {
    folder.write("clear.frag", "void main() { gl_FragColor = vec4(1., 1., 1., 0.); }\n");
    for (const char* scene : {"LookAt 0 0 4\nSphere 1\n", "Background 1 1 1\nTranslate 0 0 -5\nBox\n",
                              "Translate 0 0 -5\nFragment clear.frag\nProgram P\nBox\n",
                              "Translate 0 0 -5\nPointSize 1\nglBegin gl_points\nglVertex 0 0 0\nglEnd\n"})
        EXPECT_FALSE(warns(render(scene))) << scene << ": a fragment reached the picture, whatever its colour";
    EXPECT_FALSE(warns(render("Translate 0 0 5\nBox\n", "--quiet")));
    EXPECT_FALSE(warns(render("Translate 0 0 5\nBox\n", "--frames 2", "o{frame}.png"))) << "one of many may be empty";
}

// Whatever the eye does, discarded fragments are not seen: no option is promised.
TEST_F(InView, NothingIsPromisedThatDoesNotShow) {
    folder.write("gone.frag", "void main() { discard; }\n");
    const Outcome gone = render("Translate 0 0 -5\nFragment gone.frag\nProgram P\nBox\n");
    EXPECT_TRUE(warns(gone));
    EXPECT_FALSE(gone.says("--view")) << gone.output;
    EXPECT_EQ(gone.status, 0);
}

TEST_F(InView, ASceneWithoutDrawsHasItsOwnWord) {
    const Outcome none = render("LookAt 0 0 4\n");
    EXPECT_TRUE(none.says("the scene draws nothing [nothing-drawn]")) << none.output;
    const Outcome elsewhere = render("Texture2D 5 8 8\nRenderToTexture 5\nTranslate 0 0 -5\nBox\n");
    EXPECT_TRUE(elsewhere.says("nothing is drawn to the window [nothing-drawn]")) << elsewhere.output;
    const Outcome broken = render("LookAt 0 0 4\nSpher 1\n");
    EXPECT_FALSE(broken.says("nothing-drawn")) << "the error says it";
}

// Parts of a large picture are asked together.
TEST_F(InView, APictureOfParts) {
    EXPECT_FALSE(warns(render("LookAt 0 0 40\nTranslate 12 0 0\nBox\n", "--size 200x130 --tile 64")));
    EXPECT_TRUE(warns(render("Translate 0 0 5\nBox\n", "--size 200x130 --tile 64")));
}

}  // namespace
}  // namespace snell::test
