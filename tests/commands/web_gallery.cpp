// Galleries: every scene is in the index, whatever is wrong with it.
#include <fmt/format.h>

#include "tests/commands/web.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class WebGallery : public WebTest {
protected:
    void SetUp() override {
        WebTest::SetUp();
        if (IsSkipped()) return;
        for (const std::string name : {"class/ann/", "class/bob/"}) {
            folder.write(name + "ball.glib", plain);
            folder.write(name + "paint.frag", bytes_of(at("paint.frag")));
            folder.write(name + "wood.bmp", bytes_of(at("wood.bmp")));
        }
        folder.write("class/bob/broken<i>.glib", "Sphre 1\n");
        folder.write("class/bob/Index.glib", "Sphere 1\n");
        folder.write("class/buffer.frag",
                     "uniform samplerBuffer uData;\nvoid main() { gl_FragColor = texelFetch(uData, 0); }\n");
        folder.write("class/buffer.glib", "Fragment buffer.frag\nProgram P uData 3\nQuadXY 0. 1.\n");
    }
    std::size_t count(const std::string& page, const std::string& text) const {
        std::size_t n = 0;
        for (std::size_t i = page.find(text); i != std::string::npos; i = page.find(text, i + 1)) ++n;
        return n;
    }
};

TEST_F(WebGallery, EverySceneIsInTheIndex) {
    const Outcome made = web("--gallery class -o out");
    ASSERT_EQ(made.status, 0) << made.output;
    EXPECT_TRUE(made.says("3 of 5 scenes")) << made.output;
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(at("out"))) found.insert(entry.path().filename().string());
    EXPECT_EQ(found,
              (std::set<std::string>{"index.html", "runtime.js", "ann-ball.html", "bob-ball.html", "Index-2.html"}));
    const std::string index = bytes_of(at("out/index.html"));
    for (const char* link : {"href=\"ann-ball.html\"", "href=\"bob-ball.html\"", "href=\"Index-2.html\""})
        EXPECT_EQ(count(index, link), 1u) << link;
    EXPECT_EQ(count(index, "<h2>"), 5u);
    EXPECT_EQ(count(index, "<img alt=\"Picture of "), 4u) << "all but the broken one";
    EXPECT_NE(index.find("broken&lt;i&gt;.glib:1:1: "), std::string::npos);
    EXPECT_EQ(index.find("<i>"), std::string::npos);
    EXPECT_NE(index.find("buffer.frag:1:"), std::string::npos);
    EXPECT_EQ(index.find("class/"), std::string::npos) << "no folder is named";
    EXPECT_NE(index.find("Content-Security-Policy"), std::string::npos);
    EXPECT_EQ(index.find(folder.path()), std::string::npos);
    for (const char* title : {"<h2>ann/ball</h2>", "<h2>bob/ball</h2>", "<h2>Index</h2>"})
        EXPECT_EQ(count(index, title), 1u) << title << ": folders where names repeat";
    EXPECT_NE(bytes_of(at("out/ann-ball.html")).find("<title>ann/ball</title>"), std::string::npos);
    EXPECT_TRUE(bytes_of(at("out/runtime.js")).ends_with("\n// runtime\n"));
    EXPECT_EQ(count(bytes_of(at("out/runtime.js")), R"(=[["ann-ball.html","ann/ball"],["Index-2.html","Index"],)"
                                                    R"(["bob-ball.html","bob/ball"]];)"),
              1u)
        << "each page finds its neighbours in it";
    EXPECT_EQ(unpack("out/bob-ball.html", "un")["scene"], "ball.glib");
    EXPECT_EQ(bytes_of(at("un/wood.bmp")), bytes_of(at("wood.bmp")));
    const Outcome within = web("--gallery class ./class class/ann -o again");
    EXPECT_TRUE(within.says("3 of 5 scenes")) << "each once: " << within.output;
    for (const std::string& name : found) EXPECT_EQ(bytes_of(at("again/" + name)), bytes_of(at("out/" + name))) << name;
}

TEST_F(WebGallery, PagesAreNamedAfterTheirScenes) {
    // Characters that Windows refuses, and names that differ in case only.
    for (const std::string name : {"ö", "Ünï 1.2", "b#c%", "d?e", "d*e", ".hidden", "one/ä", "two/Ä", "two-Ä"})
        folder.write("names/" + name + ".glib", "Sphere 1\n");
    ASSERT_EQ(web("--gallery names -o out").status, 0);
    std::set<std::string> found;
    for (const auto& entry : fs::directory_iterator(at("out"))) found.insert(entry.path().filename().string());
    EXPECT_EQ(found,
              (std::set<std::string>{"index.html", "runtime.js", "ö.html", "Ünï 1.2.html", "b-c-.html", "d-e.html",
                                     "d-e-2.html", "-hidden.html", "one-ä.html", "two-Ä.html", "two-Ä-2.html"}));
    EXPECT_EQ(unpack("out/two-Ä.html", "un")["scene"], "two-Ä.glib") << "a name that no other scene has is kept";
    const std::string index = bytes_of(at("out/index.html"));
    for (const char* link : {"href=\"%C3%B6.html\"", "href=\"%C3%9Cn%C3%AF%201.2.html\"", "href=\"two-%C3%84-2.html\""})
        EXPECT_EQ(count(index, link), 1u) << link;
}

// The others have their pages all the same. On a busy machine they take their time, too.
TEST_F(WebGallery, ASceneThatTakesForeverEndsNothingElse) {
    std::string loops;
    for (int i = 0; i < 8; ++i) loops += "  for (int i = 0; i < 60000; ++i) x = fract(sin(x + uOne) * 43758.5);\n";
    folder.write("class/ann/slow.frag", "uniform float uOne;\nvoid main() {\n  float x = gl_FragCoord.x;\n" + loops +
                                            "  gl_FragColor = vec4(x);\n}\n");
    folder.write("class/ann/a.glib",
                 "LookAt 0 0 4 0 0 0 0 1 0\nPerspective 90\nFragment slow.frag\nProgram P uOne 1.\nQuadXY 0. 9.\n");
    for (double timeout = .5; timeout < 60 && !there("out/ball.html"); timeout *= 2) {
        const Outcome made = web(fmt::format("--gallery class/ann -o out --timeout {}", timeout));
        EXPECT_EQ(made.status, 0) << made.output;
        EXPECT_EQ(made.says("1 of 2 scenes"), there("out/ball.html")) << made.output;
        EXPECT_NE(bytes_of(at("out/index.html")).find(fmt::format("takes longer than {} seconds", timeout)),
                  std::string::npos);
        EXPECT_FALSE(there("out/a.html"));
    }
    EXPECT_TRUE(there("out/ball.html"));
}

TEST_F(WebGallery, ItIsMadeAgainAndPagesOfScenesThatHaveBecomeBrokenAreRemoved) {
    folder.write("class/ann/other.glib", "Sphere 1\n");
    folder.write("out/notes.txt", "mine");
    ASSERT_EQ(web("--gallery class/ann -o out").status, 0);
    const std::string old = bytes_of(at("out/index.html")), other = bytes_of(at("out/other.html"));
    EXPECT_TRUE(there("out/ball.html"));
    folder.write("class/ann/ball.glib", "Sphre 1\n");
    const Outcome made = web("--gallery class/ann -o out");
    EXPECT_EQ(made.status, 0) << made.output;
    EXPECT_TRUE(made.says("removed 'out/ball.html'")) << made.output;
    EXPECT_FALSE(there("out/ball.html"));
    EXPECT_NE(bytes_of(at("out/index.html")), old);
    EXPECT_EQ(bytes_of(at("out/other.html")), other);
    EXPECT_EQ(bytes_of(at("out/notes.txt")), "mine") << "other files are left alone";
    const Outcome again = web("--gallery class/ann -o out");
    EXPECT_EQ(again.status, 0);
    EXPECT_FALSE(again.says("removed")) << again.output;
}

TEST_F(WebGallery, ItReplacesOnlyFilesOfAGallery) {
    folder.write("class/ann/single.glib", plain);
    ASSERT_EQ(web("class/ann/single.glib -o single.html").status, 0);
    const std::string single = bytes_of(at("single.html"));
    const std::map<std::string, std::string> mine{{"ball.html", "<!DOCTYPE html>my own page"},
                                                  {"runtime.js", "// runtime\n"},
                                                  {"index.html", "my own page"},
                                                  {"single.html", single}};  // made by snell, but for no gallery
    for (const auto& [name, bytes] : mine) {
        folder.write("site/" + name, bytes);
        const Outcome made = web("--gallery class/ann -o site");
        EXPECT_EQ(made.status, 2) << made.output;
        EXPECT_TRUE(made.says("site/" + name)) << made.output;
        EXPECT_EQ(bytes_of(at("site/" + name)), bytes);
        fs::remove(at("site/" + name));
        EXPECT_TRUE(fs::is_empty(at("site"))) << name;
    }
    fs::create_directories(at("site/ball.html"));
    EXPECT_EQ(web("--gallery class/ann -o site").status, 2);
    EXPECT_FALSE(there("site/single.html"));
}

TEST_F(WebGallery, ItOverwritesNoFileOfAScene) {
    folder.write("class/ann/ball.html", "mine");
    folder.write("class/ann/t.glib", "Texture2D 6 ball.html\n" + plain);
    EXPECT_EQ(web("--gallery class/ann -o class/ann").status, 2);
    EXPECT_EQ(bytes_of(at("class/ann/ball.html")), "mine");
    EXPECT_FALSE(there("class/ann/index.html"));
}

TEST_F(WebGallery, FoldersWithoutScenesAndValuesAreRefused) {
    fs::create_directories(at("empty"));
    EXPECT_EQ(web("--gallery empty -o out").status, 1);
    EXPECT_EQ(web("--gallery nowhere -o out").status, 1);
    EXPECT_EQ(web("--gallery class -o out --set uRed=1").status, 2);
    EXPECT_EQ(web("class/ann/ball.glib class/bob/ball.glib -o out").status, 2);
    EXPECT_FALSE(there("out"));
}

}  // namespace

}  // namespace snell::test
