// Pages: what they say, what they refuse, and what they leave alone.
#include "tests/commands/web.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Web : public WebTest {};

TEST_F(Web, APageHoldsTheValuesAndTheView) {
    folder.write("s.glib", "Ladder WAY dark <light> bright\n" + plain);
    const Outcome made = web(
        "s.glib -o p.html --set uRed=.75 --ladder WAY=dark --view rotate_x=30,scale=2 --link https://example.org/s");
    ASSERT_EQ(made.status, 0) << made.output;
    const json data = unpack("p.html", "un");
    EXPECT_EQ(data["scene"], "s.glib");
    EXPECT_EQ(data["title"], "s");
    EXPECT_EQ(data["values"], json::array({"Paint.uRed=0.75"}));
    EXPECT_EQ(data["rungs"], json::array({"WAY=dark"}));
    EXPECT_EQ(data["view"], "rotate_x=30,scale=2");
    EXPECT_EQ(data["link"], "https://example.org/s");
    EXPECT_NE(bytes_of(at("p.html")).find("UlVO"), std::string::npos) << "the runtime stays";
    for (const char* name : {"s.glib", "paint.frag", "wood.bmp"}) EXPECT_TRUE(made.says(name)) << made.output;
    EXPECT_TRUE(made.says("12 kB  wood.bmp")) << made.output;
}

TEST_F(Web, LoopsThatMayNotEndAreNamed) {
    folder.write("l.frag",
                 "void main() {\n  float x = 0.;\n  while (true) x += gl_FragCoord.x;\n  gl_FragColor = vec4(x);\n}\n");
    folder.write("l.glib", "Fragment l.frag\nProgram L\nQuadXY 0. 1.\n");
    const Outcome made = web("l.glib -o p.html");
    EXPECT_EQ(made.status, 0) << made.output;
    EXPECT_TRUE(made.says("[many-rounds]")) << made.output;
    EXPECT_TRUE(made.says("l.frag:3:")) << made.output;
}

TEST_F(Web, WithoutValuesThePageIsTheScenes) {
    folder.write("s.glib", plain);
    ASSERT_EQ(web("s.glib -o p.html").status, 0);
    const json data = unpack("p.html", "un");
    EXPECT_EQ(data["values"], json::array());
    EXPECT_EQ(data["rungs"], json::array());
    EXPECT_EQ(data["view"], "");
    EXPECT_EQ(data["link"], "");
}

TEST_F(Web, TheSameSceneGivesTheSameBytesWhoeverMakesIt) {
    folder.write("a/s.glib", plain);
    folder.write("b/else where/s.glib", plain);
    for (const char* name : {"a", "b/else where"})
        for (const char* file : {"paint.frag", "wood.bmp"}) fs::copy(at(file), at(std::string(name) + "/" + file));
    ASSERT_EQ(web("a/s.glib -o 1.html").status, 0);
    fs::last_write_time(at("a/wood.bmp"), fs::file_time_type{} + std::chrono::hours(1));
    ASSERT_EQ(web("'" + at("a/s.glib") + "' -o 2.html", "USER=other HOME=/ TZ=Asia/Tokyo LC_ALL=C").status, 0);
    ASSERT_EQ(web("'b/else where/s.glib' -o 3.html").status, 0);
    const std::string first = bytes_of(at("1.html"));
    EXPECT_EQ(first, bytes_of(at("2.html")));
    EXPECT_EQ(first, bytes_of(at("3.html")));
    EXPECT_EQ(first.find(folder.path()), std::string::npos);
}

TEST_F(Web, NothingInATitleOrANameIsHtml) {
    const std::string name = "<b>&\"'</script><img src=x>";
    folder.write("h/" + std::string("s<i>.glib"), plain);
    for (const char* file : {"paint.frag", "wood.bmp"}) fs::copy(at(file), at(std::string("h/") + file));
    folder.write("title", name);
    const Outcome made =
        web("'h/s<i>.glib' -o p.html --title \"$(cat title)\" --link 'https://example.org/\"><script>'");
    ASSERT_EQ(made.status, 0) << made.output;
    const std::string page = bytes_of(at("p.html"));
    EXPECT_NE(page.find("<title>&lt;b&gt;&amp;&quot;&#39;&lt;/script&gt;&lt;img src=x&gt;</title>"), std::string::npos);
    for (const char* tag : {"<b>", "<i>", "<img", "<script>"}) EXPECT_EQ(page.find(tag), std::string::npos) << tag;
    const json data = unpack("p.html", "un");
    EXPECT_EQ(data["title"], name);
    EXPECT_EQ(data["scene"], "s<i>.glib");
    for (const char* link : {"javascript:alert(1)", "data:text/html,x", "//example.org", "https://"})
        EXPECT_EQ(web("'h/s<i>.glib' -o q.html --link '" + std::string(link) + "'").status, 2) << link;
    EXPECT_FALSE(there("q.html"));
}

TEST_F(Web, WhatBrowsersLackIsRefusedAtItsPlace) {
    const std::string cases = SNELL_ROOT "/tests/cases/";
    folder.write("buffer.frag", "uniform samplerBuffer uData;\nvoid main() { gl_FragColor = texelFetch(uData, 0); }\n");
    folder.write("buffer.glib", "Fragment buffer.frag\nProgram P uData 3\nQuadXY 0. 1.\n");
    folder.write("image.frag",
                 "#version 430\nlayout(rgba8) uniform writeonly image2D uOut;\n"
                 "void main() { imageStore(uOut, ivec2(0), vec4(1.)); gl_FragColor = vec4(1.); }\n");
    folder.write("image.glib", "Fragment image.frag\nProgram P\nQuadXY 0. 1.\n");
    const std::map<std::string, std::string> refused{{cases + "Shp.glib", "Shp.glib:4:1: error: "},
                                                     {at("buffer.glib"), "buffer.frag:1:"},
                                                     {at("image.glib"), "image.frag:2:"}};
    for (const auto& [scene, place] : refused) {
        const Outcome outcome = web("'" + scene + "' -o p.html");
        EXPECT_EQ(outcome.status, 1) << outcome.output;
        EXPECT_TRUE(outcome.says(place)) << outcome.output;
        EXPECT_FALSE(there("p.html")) << scene;
    }
    const Outcome thin = web("'" + cases + "Wireframe.glib' -o p.html");
    EXPECT_EQ(thin.status, 0) << thin.output;
    EXPECT_TRUE(thin.says("warning: ")) << thin.output;
}

// Vertex shaders stand for them (tests/resources/stages.cpp, and the browser's pictures).
TEST_F(Web, GeometryAndTessellationHavePages) {
    for (const std::string scene : {"cases/Geometry", "cases/TessControl"}) {
        const Outcome made = web("'" SNELL_ROOT "/tests/" + scene + ".glib' -o p.html");
        EXPECT_EQ(made.status, 0) << made.output;
        EXPECT_FALSE(made.says("error")) << made.output;
    }
}

// An error of the scene is no fault of browsers.
TEST_F(Web, AnErrorOfTheSceneIsReportedAsEver) {
    folder.write("s.glib", plain + "Sphre 1\nTexture2D 7 gone.png\n");
    const Outcome outcome = web("s.glib -o p.html");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("s.glib:6:1: error: ")) << outcome.output;
    EXPECT_FALSE(outcome.says("WebGL")) << outcome.output;
    EXPECT_FALSE(there("p.html"));
    EXPECT_EQ(web("s.glib -o p.html --set uNope=1").status, 1);
    EXPECT_EQ(web("gone.glib -o p.html").status, 1);
}

TEST_F(Web, ARungThatBrowsersLackIsAWarning) {
    folder.write("way.frag",
                 "#if WAY == WAY_far\nuniform samplerBuffer uData;\n#endif\nvoid main() {\n#if WAY == WAY_far\n"
                 "gl_FragColor = texelFetch(uData, 0);\n#else\ngl_FragColor = vec4(1.);\n#endif\n}\n");
    folder.write("s.glib", "Ladder WAY <near> far\nFragment way.frag\nProgram P\nQuadXY 0. 1.\n");
    const Outcome made = web("s.glib -o p.html");
    EXPECT_EQ(made.status, 0) << made.output;
    EXPECT_TRUE(made.says("WAY=far")) << made.output;
    EXPECT_EQ(web("s.glib -o q.html --ladder WAY=far").status, 1);
    EXPECT_FALSE(there("q.html"));
}

TEST_F(Web, NoFileOfTheSceneIsOverwritten) {
    folder.write("s.glib", plain + "Include more.html\n");
    folder.write("more.html", "Sphere 1\n");
    for (const char* output : {"more.html", "./more.html", "web/../more.html"}) {
        const Outcome outcome = web(std::string("s.glib -o ") + output);
        EXPECT_EQ(outcome.status, 2) << outcome.output;
        EXPECT_TRUE(outcome.says("is read, and would be overwritten")) << outcome.output;
    }
    EXPECT_EQ(bytes_of(at("more.html")), "Sphere 1\n");
    EXPECT_EQ(web("s.glib -o nowhere/p.html").status, 1);
    folder.write("p.html", "old");
    const Outcome full =
        run("cd '" + folder.path() + "' && ulimit -f 1 && SNELL_WEB=web exec " SNELL_BIN "/snell web s.glib -o p.html");
    EXPECT_EQ(full.status, 1) << full.output;
    EXPECT_EQ(bytes_of(at("p.html")), "old") << "whole, or not at all";
}

TEST_F(Web, APagesNameEndsWithHtml) {
    folder.write("s.glib", plain);
    const std::map<std::string, std::string> better{{"x.glib", "-o 'x.html'"},
                                                    {"version\\ 1.2", "-o 'version 1.2.html'"}};
    for (const auto& [name, help] : better) {
        const Outcome outcome = web("s.glib -o " + name);
        EXPECT_EQ(outcome.status, 2) << outcome.output;
        EXPECT_TRUE(outcome.says(help)) << outcome.output;
    }
    for (const char* none : {"x.glib", "version 1.2"}) EXPECT_FALSE(there(none)) << none;
    EXPECT_EQ(web("s.glib -o p.HTM").status, 0);
}

// What a file is decides, not where it is.
TEST_F(Web, FilesAreReplacedAndListedAndStreamsHoldThePageAlone) {
    folder.write("s.glib", plain);
    ASSERT_EQ(web("s.glib -o p.html").status, 0);
    const std::string page = bytes_of(at("p.html"));
    EXPECT_EQ(web("s.glib -o /dev/stdout >out.html").status, 0);
    EXPECT_EQ(bytes_of(at("out.html")), page);
    EXPECT_EQ(web("s.glib -o /dev/stdout | cat >piped.html").status, 0);
    EXPECT_EQ(bytes_of(at("piped.html")), page);
    EXPECT_EQ(web("s.glib -o /dev/null").output, "");
    char name[] = "/dev/shm/snell-XXXXXX";
    if (!mkdtemp(name)) GTEST_SKIP() << "there is no /dev/shm";
    const std::string shared = std::string(name) + "/p.html";
    for (int time = 1; time <= 2; ++time) {
        const Outcome made = web("s.glib -o " + shared);
        EXPECT_EQ(made.status, 0) << made.output;
        EXPECT_TRUE(made.says("wood.bmp")) << made.output;
        EXPECT_EQ(bytes_of(shared), page) << "replaced, not appended to";
    }
    fs::remove_all(name);
}

TEST_F(Web, WithoutTheBrowsersPartItSaysHowToMakeIt) {
    folder.write("s.glib", plain);
    const Outcome none = web("s.glib -o p.html", "SNELL_WEB=nowhere");
    EXPECT_EQ(none.status, 1);
    EXPECT_TRUE(none.says("./dev web")) << none.output;
    folder.write("old/page.html", "<title>snell</title>");
    const Outcome old = web("s.glib -o p.html", "SNELL_WEB=old");
    EXPECT_EQ(old.status, 1);
    EXPECT_TRUE(old.says("./dev web")) << old.output;
    EXPECT_FALSE(there("p.html"));
}

}  // namespace

}  // namespace snell::test
