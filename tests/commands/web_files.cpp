// The files of a page: all of them, to the bit, and by names by which the scene finds them.
#include "src/content/image/image.h"
#include "tests/commands/web.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class WebFiles : public WebTest {
protected:
    // The unpacked page must draw what the scene draws.
    void expect_same(const std::string& scene) {
        const Outcome made = web("'" + scene + "' -o p.html");
        ASSERT_EQ(made.status, 0) << made.output;
        const std::string inside = unpack("p.html", "un")["scene"];
        const content::Image first = drawn(scene);
        // Elsewhere, so that no other file of the scene's folder is found.
        const std::string moved = moved_.path("page");
        fs::rename(at("un"), moved);
        const content::Image second = drawn(moved + "/" + inside);
        EXPECT_TRUE(first.pixels == second.pixels) << scene;
        EXPECT_FALSE(first.pixels.empty());
        EXPECT_NE(first.pixels, std::vector<std::byte>(first.pixels.size(), first.pixels[0])) << "shows something";
        fs::remove_all(moved);
    }
    Folder moved_;
    // Its texture decides the picture.
    std::string quad(const std::string& texture) const {
        return "Ortho -1 1 -1 1\nTexture2D 6 " + texture +
               "\nFragment paint.frag\nProgram P uRed <0. .25 1.> uWood 6\nQuadXY 0. .6\n";
    }
};

TEST_F(WebFiles, EveryFileIsThereToTheBit) {
    folder.write("s/way.glsl", "#include \"deep.glsl\"\n");
    folder.write("s/deep.glsl", "const float deep = .5;\n");
    folder.write("s/far.glsl", "const float deep = .7;\n");
    folder.write("s/a.frag",
                 "#if WAY == WAY_near\n#include \"way.glsl\"\n#else\n#include \"far.glsl\"\n#endif\n"
                 "void main() { gl_FragColor = vec4(deep); }\n");
    folder.write("s/one.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    folder.write("s/inc/more.inc", "Texture2D 7 unused.bmp\n");
    folder.write("s/inc/unused.bmp", bytes_of(at("wood.bmp")));
    folder.write("s/other.txt", "not read");
    folder.write("s/s.glib", "Ladder WAY <near> far\nInclude inc/more.inc\nFragment a.frag\nProgram P\nObj one.obj\n");
    ASSERT_EQ(web("s/s.glib -o p.html").status, 0);
    unpack("p.html", "un");
    std::set<std::string> found;
    for (const auto& entry : fs::recursive_directory_iterator(at("un")))
        if (entry.is_regular_file()) found.insert(fs::relative(entry.path(), at("un")).string());
    EXPECT_EQ(found, (std::set<std::string>{"page.json", "s.glib", "way.glsl", "deep.glsl", "far.glsl", "a.frag",
                                            "one.obj", "inc/more.inc", "inc/unused.bmp"}));
    for (const std::string& name : found)
        EXPECT_TRUE(name == "page.json" || bytes_of(at("un/" + name)) == bytes_of(at("s/" + name))) << name;
}

TEST_F(WebFiles, AShippedSceneIsFoundInItsPage) {
    fs::copy(SNELL_ROOT "/scenes", at("scenes"), fs::copy_options::recursive);
    expect_same("scenes/refraction-room/refraction-room.glib");
    expect_same("scenes/light/glass/glass.glib");
}

TEST_F(WebFiles, FoldersKeepTheirPlaces) {
    for (const char* name : {"paint.frag", "wood.bmp"}) {
        fs::create_directories(at("c/env"));
        fs::copy(at(name), at(std::string("c/env/") + name));
    }
    fs::create_directories(at("c/x/y"));
    folder.write("c/env/room.inc", quad("wood.bmp"));
    folder.write("c/x/y/up.glib", "Include ../../env/room.inc\n");
    folder.write("c/x/y/round.glib", "Include ../../../c/env/../env/room.inc\n");
    folder.write("c/x/y/case.glib", "Include ..\\..\\ENV\\Room.INC\n");
    folder.write("c/x/y/through.glib", "Include ../y/../../env/room.inc\n");
    for (const char* scene : {"c/x/y/up.glib", "c/x/y/round.glib", "c/x/y/case.glib", "c/x/y/through.glib"})
        expect_same(scene);
    expect_same(at("c/x/y/up.glib"));
}

TEST_F(WebFiles, AbsoluteNamesLeadToTheScenesFolder) {
    folder.write("elsewhere/deep/tree.bmp", bytes_of(at("wood.bmp")));
    folder.write("h/paint.frag", bytes_of(at("paint.frag")));
    folder.write("h/tex/own.bmp", bytes_of(at("wood.bmp")));
    folder.write("h/far.glib", quad(at("elsewhere/deep/tree.bmp")));
    folder.write("h/near.glib", quad(at("h/tex/own.bmp")));
    folder.write("h/both.glib", "Texture2D 7 tex/own.bmp\n" + quad(at("h/tex/own.bmp")));
    for (const char* scene : {"h/far.glib", "h/near.glib", "h/both.glib"}) {
        ASSERT_EQ(web(std::string(scene) + " -o p.html").status, 0);
        unpack("p.html", "look");
        EXPECT_TRUE(there("look/" + std::string(scene == std::string("h/far.glib") ? "tree.bmp" : "own.bmp"))) << scene;
        fs::remove_all(at("look"));
    }
    // As on another machine, where the absolute name leads nowhere.
    const content::Image here = drawn("h/far.glib");
    unpack("p.html", "page");
    ASSERT_EQ(web("h/far.glib -o p.html").status, 0);
    fs::remove_all(at("page"));
    unpack("p.html", "page");
    fs::remove_all(at("elsewhere"));
    EXPECT_TRUE(drawn("page/far.glib").pixels == here.pixels);
}

TEST_F(WebFiles, TwoFilesOfOneNameAreRefusedWhereOneMustMove) {
    folder.write("elsewhere/wood.bmp", bytes_of(SNELL_ROOT "/scenes/environments/room/negy.bmp"));
    folder.write("t.glib", "Texture2D 7 wood.bmp\n" + quad(at("elsewhere/wood.bmp")));
    const Outcome outcome = web("t.glib -o p.html");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_TRUE(outcome.says("rename one")) << outcome.output;
    EXPECT_FALSE(there("p.html"));
}

// Pages of cube maps are mostly these: without what neighbours foretell, they pack into much less.
TEST_F(WebFiles, ABmpImageIsPackedWithoutLoss) {
    const std::string bytes = bytes_of(SNELL_ROOT "/scenes/environments/room/posx.bmp");
    folder.write("wood.bmp", bytes);
    folder.write("w.glib", quad("wood.bmp"));
    ASSERT_EQ(web("w.glib -o p.html").status, 0);
    unpack("p.html", "un");
    EXPECT_TRUE(bytes_of(at("un/wood.bmp")) == bytes);
    folder.write("plain", bytes);
    run("gzip -9 '" + at("plain") + "'");
    const auto packed = static_cast<double>(bytes_of(at("p.html")).size()) * 3 / 4;
    EXPECT_LT(packed, .8 * static_cast<double>(bytes_of(at("plain.gz")).size()));
    for (const std::string name : {"letter", "rainbow"}) {  // rows that are padded
        const std::string other = bytes_of(SNELL_ROOT "/tests/cases/files/" + name + ".bmp");
        folder.write("wood.bmp", other);
        ASSERT_EQ(web("w.glib -o p.html").status, 0);
        unpack("p.html", name);
        EXPECT_TRUE(bytes_of(at(name + "/wood.bmp")) == other) << name;
    }
}

TEST_F(WebFiles, NamesThatPagesRefuseAreRefused) {
    for (const char* name : {"C:foo.glib", "a\\b.glib"}) {
        folder.write(name, quad("wood.bmp"));
        const Outcome outcome = web("'" + std::string(name) + "' -o p.html");
        EXPECT_EQ(outcome.status, 1) << outcome.output;
        EXPECT_TRUE(outcome.says("has a name that a page cannot hold")) << outcome.output;
        EXPECT_FALSE(there("p.html"));
    }
}

TEST_F(WebFiles, FoldersOfTheMachineAreNotNamed) {
    folder.write("home/pupil/tree.bmp", bytes_of(at("wood.bmp")));
    folder.write("home/pupil/course/week/paint.frag", bytes_of(at("paint.frag")));
    folder.write("home/pupil/course/week/s.glib", quad("../../tree.bmp"));
    folder.write("home/shared/far.bmp", bytes_of(at("wood.bmp")));
    folder.write("home/pupil/course/week/t.glib", quad("../../../shared/far.bmp"));
    const std::string home = "HOME='" + at("home/pupil") + "'";
    ASSERT_EQ(web("home/pupil/course/week/s.glib -o p.html", home).status, 0);
    EXPECT_EQ(unpack("p.html", "a")["scene"], "course/week/s.glib");
    ASSERT_EQ(web("home/pupil/course/week/t.glib -o p.html", home).status, 0);
    EXPECT_EQ(unpack("p.html", "b")["scene"], "t.glib");
    EXPECT_TRUE(there("b/far.bmp"));
}

TEST_F(WebFiles, ImagesThatPagesDoNotDecodeAreThereTwice) {
    const auto image = content::decode_image("wood.bmp", bytes_of(at("wood.bmp")));
    ASSERT_TRUE(image.image);
    for (const char* name : {"w.exr", "w.tif", "w.png", "w.jpg", "w.tga"})
        ASSERT_EQ(content::write_image(at(name), *image.image), "");
    for (const std::string name : {"w.exr", "w.tif", "w.png", "w.jpg", "w.tga"}) {
        folder.write("s.glib", quad(name));
        ASSERT_EQ(web("s.glib -o p.html").status, 0);
        unpack("p.html", "un");
        EXPECT_EQ(bytes_of(at("un/" + name)), bytes_of(at(name)));
        const bool twice = name == "w.exr" || name == "w.tif";
        EXPECT_EQ(there("un/" + name + ".decoded"), twice) << name;
        if (twice) {
            const content::Image expected = *content::decode_image(name, bytes_of(at(name))).image;
            const std::string found = bytes_of(at("un/" + name + ".decoded"));
            ASSERT_EQ(found.size(), 28 + expected.pixels.size());
            EXPECT_EQ(found.substr(0, 8), "SNELLIMG");
            const auto number = [&](std::size_t i) {
                std::uint32_t value = 0;
                for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(found[8 + 4 * i + k]);
                return static_cast<int>(value);
            };
            EXPECT_EQ(number(0), expected.width);
            EXPECT_EQ(number(1), expected.height);
            EXPECT_EQ(number(2), expected.depth);
            EXPECT_EQ(number(3), expected.channels);
            EXPECT_EQ(number(4), static_cast<int>(expected.type));
            EXPECT_EQ(std::memcmp(found.data() + 28, expected.pixels.data(), expected.pixels.size()), 0);
        }
        fs::remove_all(at("un"));
    }
}

TEST_F(WebFiles, ConfinedScenesReadNothingElse) {
    folder.write("elsewhere/tree.bmp", bytes_of(at("wood.bmp")));
    folder.write("h/paint.frag", bytes_of(at("paint.frag")));
    folder.write("h/s.glib", quad("../elsewhere/tree.bmp"));
    EXPECT_EQ(web("h/s.glib -o p.html --grade").status, 1);
    EXPECT_FALSE(there("p.html"));
    EXPECT_EQ(web("h/s.glib -o p.html").status, 0);
}

}  // namespace

}  // namespace snell::test
