// Finding and reading files by the names that scenes write.
#include <sys/stat.h>
#include <unistd.h>

#include "parser/text/words.h"
#include "src/plan/files.h"
#include "src/plan/locate.h"
#include "src/plan/texts.h"
#include "tests/sanitized.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

TEST(Resolve, ExactNameIsUsedAsItIs) {
    const Scratch folder;
    folder.write("wall.bmp", "x");
    folder.write("Wall.bmp", "y");
    const Files files(folder.path());
    for (const char* name : {"wall.bmp", "Wall.bmp"}) {
        const Resolved found = files.resolve(name);
        EXPECT_EQ(found.path, folder.path(name));
        EXPECT_FALSE(found.inexact);
    }
}

TEST(Resolve, AFolderWhoseNameIsTooLongIsNotThere) {
    const Scratch folder;
    folder.write("a.frag", "x");
    const Files files(folder.path());
    const Resolved found = files.resolve_beside(folder.path("a.frag"), std::string(300, 'b') + "/a.frag");
    EXPECT_EQ(found.path + std::string(found.refused), "");
}

// By two spellings it would be two files for all that compare paths: changes would be offered twice.
TEST(Resolve, OneFileHasOnePath) {
    const Scratch folder;
    folder.write("a.frag", "x");
    folder.write("sub/b.inc", "x");
    folder.write("far/deep/a.frag", "y");
    const Files files(folder.path());
    for (const char* name : {"a.frag", "./a.frag", "sub/../a.frag", "sub/./..//a.frag"}) {
        EXPECT_EQ(files.resolve(name).path, folder.path("a.frag")) << name;
        EXPECT_EQ(files.find(name).path, folder.path("a.frag")) << name;
    }
    EXPECT_EQ(files.resolve_beside(folder.path("sub/b.inc"), "../a.frag").path, folder.path("a.frag"));
    EXPECT_EQ(files.resolve_beside(folder.path("sub/../sub/b.inc"), "b.inc").path, folder.path("sub/../sub/b.inc"));
    EXPECT_EQ(files.resolve("sub/b.inc").path, folder.path("sub/../sub/b.inc")) << "the first one stays";
    ASSERT_EQ(symlink(folder.path("far/deep").c_str(), folder.path("link").c_str()), 0);
    folder.write("far/a.frag", "z");
    EXPECT_EQ(files.resolve("link/../a.frag").path, folder.path("link/../a.frag")) << "that is far/a.frag";
}

TEST(Resolve, CaseOfEveryComponentIsForgiven) {
    const Scratch folder;
    folder.write("Textures/Stone/Wall.BMP", "x");
    const Files files(folder.path());
    for (const char* name : {"textures/stone/wall.bmp", "TEXTURES\\Stone\\wall.bmp", "./textures//STONE/Wall.bmp",
                             "\"Textures\\\\Stone\\\\wall.BMP\"", " textures/stone/wall.bmp "}) {
        const Resolved found = files.resolve(name);
        EXPECT_EQ(found.path, folder.path("Textures/Stone/Wall.BMP")) << name;
    }
    EXPECT_TRUE(files.resolve("textures/stone/wall.bmp").inexact);
    EXPECT_FALSE(files.resolve("Textures\\Stone\\Wall.BMP").inexact) << "a backslash is no other name";
}

TEST(Resolve, LooksIntoEveryFolderThatFits) {
    const Scratch folder;
    folder.write("DATA/other.obj", "x");
    folder.write("Data/cow.obj", "x");
    EXPECT_EQ(Files(folder.path()).resolve("data/COW.obj").path, folder.path("Data/cow.obj"));
}

TEST(Resolve, ExtensionsInTheirOrder) {
    const Scratch folder;
    folder.write("light.vert", "x");
    folder.write("light.glsl", "x");
    folder.write("shade.VS", "x");
    const Files files(folder.path());
    const Resolved light = files.resolve("light", {"vert", "vs", "glsl"});
    EXPECT_EQ(light.path, folder.path("light.vert"));
    EXPECT_TRUE(light.inexact);
    EXPECT_EQ(files.resolve("light.", {"vert"}).path, folder.path("light.vert"));
    EXPECT_EQ(files.resolve("Shade", {"vert", "vs", "glsl"}).path, folder.path("shade.VS"));
    EXPECT_TRUE(files.resolve("light").path.empty()) << "without extensions nothing is added";
}

TEST(Resolve, NamesFromOtherMachines) {
    const Scratch folder, elsewhere;
    folder.write("cow.obj", "x");
    elsewhere.write("far.obj", "x");
    const Files files(folder.path());
    for (const char* name : {"C:\\Users\\me\\Cow.obj", "/no/such/place/cow.obj", "models/cow.obj", "../lost/cow.obj"}) {
        const Resolved found = files.resolve(name);
        EXPECT_EQ(found.path, folder.path("cow.obj")) << name;
        EXPECT_TRUE(found.inexact) << name;
    }
    EXPECT_EQ(files.resolve(elsewhere.path("far.obj")).path, elsewhere.path("far.obj"));
    folder.write("scene/a.glib", "x");
    EXPECT_EQ(Files(folder.path("scene")).resolve("../cow.obj").path, folder.path("scene/../cow.obj"));
    EXPECT_EQ(Files(folder.path("scene")).resolve("../COW.obj").path, folder.path("scene/../cow.obj"));
}

// What a scene may do without is found where resolve() finds it, and nothing is suggested in its place.
TEST(Resolve, FindsWhatMayBeMissing) {
    const Scratch folder, handed_out;
    folder.write("Noise2d.064.TEX", "x");
    handed_out.write("deep/noise3d.064.tex", "x");
    Access access;
    access.confine = folder.path("");
    EXPECT_EQ(Files(folder.path(), access).find("noise2d.064.tex").path, folder.path("Noise2d.064.TEX"));
    EXPECT_EQ(Files(folder.path(), access).find("noise3d.064.tex").path, "");
    access.allow = {handed_out.path("")};
    EXPECT_EQ(Files(folder.path(), access).find("noise3d.064.tex").path, handed_out.path("deep/noise3d.064.tex"));
}

TEST(Resolve, SuggestsTheNearestName) {
    const Scratch folder;
    folder.write("reflect.vert", "x");
    folder.write("refract.frag", "x");
    folder.write("img/kitchen.bmp", "x");
    const Files files(folder.path());
    EXPECT_EQ(files.resolve("reflct.vert").nearest, "reflect.vert");
    EXPECT_EQ(files.resolve("img/kichen.bmp").nearest, "img/kitchen.bmp");
    EXPECT_EQ(files.resolve("img/kitchen.jpeg2000").nearest, "img/kitchen.bmp") << "only the extension differs";
    EXPECT_TRUE(files.resolve("entirely-different-thing").nearest.empty());
    EXPECT_TRUE(files.resolve("nofolder/entirely-different").nearest.empty());
}

// What is suggested fits the argument and is near by name: anything else sends its reader astray.
TEST(Resolve, SuggestsFilesOfTheRightKind) {
    const Scratch folder;
    for (const char* name : {"room.glib", "room.vert", "room.frag", "room.obj", "glass.vert.glsl", "glass.frag.glsl",
                             "noise.txt", "rooms.bmp", "posy.bmp", "negx.bmp", "earth_map.png"})
        folder.write(std::string("alone/") + name, "x");  // neighbours of the folder are looked at, too
    const Files files(folder.path("alone"));
    const std::vector<std::string_view> vert{"vert", "vs", "vert.glsl", "glsl"},
        frag{"frag", "fs", "frag.glsl", "glsl"};
    const std::vector<std::string_view> image{"bmp", "png"}, obj{"obj"}, geom{"geom", "gs", "glsl"}, scene{"glib"};
    struct Case {
        const char* asked;
        const std::vector<std::string_view>& extensions;
        const char* nearest;
    };
    for (const Case& c : std::vector<Case>{
             {"room.geom", geom, ""},  // the scene, a vertex and a fragment shader, a mesh: all of another kind
             {"room.glsl", vert, "room.vert"},
             {"rooom.vert", vert, "room.vert"},
             {"rom.frag", frag, "room.frag"},
             {"glas.vert.glsl", vert, "glass.vert.glsl"},
             {"glass.fs", frag, "glass.frag.glsl"},
             {"romes.bmp", image, "rooms.bmp"},
             {"rooms.pgn", image, "rooms.bmp"},
             {"earth-map.jpg", image, "earth_map.png"},
             {"noises.bmp", image, ""},
             {"posx.bmp", image, "posy.bmp"},
             {"negz.obj", image, "negx.bmp"},
             {"posz.frag", frag, ""},
             {"rooms.obj", obj, "room.obj"},
             {"rom.glib", scene, "room.glib"},
             {"kitchen.bmp", image, ""},
             {"wall.bmp", image, ""},
             {"q.bmp", image, ""},
         })
        EXPECT_EQ(files.resolve(c.asked, c.extensions).nearest, c.nearest) << c.asked;
}

TEST(Resolve, SuggestsTheSameNameInAFolderNearby) {
    const Scratch folder;
    folder.write("lab/textures/earth.bmp", "x");
    folder.write("lab/earthy.bmp", "x");
    folder.write("moon.bmp", "x");
    const Files files(folder.path("lab"));
    EXPECT_EQ(files.resolve("earth.bmp", {"bmp"}).nearest, "textures/earth.bmp");
    EXPECT_EQ(files.resolve("moon.bmp", {"bmp"}).nearest, "../moon.bmp");
    EXPECT_EQ(files.resolve("gone/eartth.bmp", {"bmp"}).nearest, "earthy.bmp") << "files were gathered in one folder";
    folder.write("images/wall.bmp", "x");
    folder.write("lab/images/wall.bmp.txt", "x");
    EXPECT_EQ(files.resolve("wall.bmp", {"bmp"}).nearest, "../images/wall.bmp");
    EXPECT_EQ(files.resolve("textures/wall.bmp", {"bmp"}).nearest, "");
    EXPECT_EQ(files.resolve("images/earth.bmp", {"bmp"}).nearest, "textures/earth.bmp");
    folder.write("other/wall.bmp", "x");
    const Files again(folder.path("lab"));
    EXPECT_EQ(again.resolve("wall.bmp", {"bmp"}).nearest, "") << "it is not certain which one";
    const Files confined(folder.path("lab"), {{}, folder.path("lab")});
    EXPECT_EQ(confined.resolve("moon.bmp", {"bmp"}).nearest, "") << "what is outside is not named";
    EXPECT_EQ(confined.resolve("../images/wall.bmp", {"bmp"}).nearest, "");
}

// A search reads whole folders, and scenes ask for the same thousands of times.
TEST(Resolve, WhatIsMissingIsLookedForOnce) {
    const Scratch folder;
    const std::string scene = folder.write("part/s.glib", "");
    const Files files(folder.path());
    EXPECT_EQ(files.resolve("a", {"bmp"}).path, "");
    EXPECT_EQ(files.resolve_beside(scene, "b.bmp").path, "");
    folder.write("a.bmp", "x");
    folder.write("part/b.bmp", "x");
    EXPECT_EQ(files.resolve("a", {"bmp"}).path, "");
    EXPECT_EQ(files.resolve_beside(scene, "b.bmp").path, "");
    EXPECT_EQ(files.resolve("a", {"tex", "bmp"}).path, folder.path("a.bmp")) << "that is another question";
    EXPECT_EQ(Files(folder.path()).resolve("a", {"bmp"}).path, folder.path("a.bmp")) << "the next reading finds it";
    EXPECT_EQ(Files(folder.path()).resolve_beside(scene, "b.bmp").path, folder.path("part/b.bmp"));
}

TEST(Resolve, OnlyRegularFilesCount) {
    const Scratch folder;
    std::filesystem::create_directory(folder.path("wall.bmp"));
    folder.write("WALL.bmp", "x");
    std::filesystem::create_symlink("WALL.bmp", folder.path("link.bmp"));
    std::filesystem::create_symlink("nowhere", folder.path("broken.bmp"));
    std::filesystem::create_symlink("loop.bmp", folder.path("loop.bmp"));
    ASSERT_EQ(mkfifo(folder.path("pipe.bmp").c_str(), 0600), 0);
    const Files files(folder.path());
    EXPECT_EQ(files.resolve("wall.bmp").path, folder.path("WALL.bmp")) << "a folder is not a picture";
    EXPECT_EQ(files.resolve("link.bmp").path, folder.path("link.bmp"));
    for (const char* name : {"broken.bmp", "loop.bmp", "pipe.bmp", "", ".", "..", "/", "\\", "   "}) {
        EXPECT_TRUE(files.resolve(name).path.empty()) << name;
    }
    EXPECT_TRUE(files.resolve(std::string_view("a\0b", 3)).path.empty());
    EXPECT_TRUE(files.resolve(std::string(100'000, 'x')).path.empty());
    EXPECT_TRUE(files.resolve("/dev/zero").path.empty());
}

TEST(Resolve, RelativeToTheWorkingDirectory) {
    const Files files("");
    EXPECT_EQ(files.resolve("tests/plan/files.cpp").path, "tests/plan/files.cpp");
    EXPECT_EQ(files.resolve("Tests/Plan/FILES.cpp").path, "tests/plan/files.cpp");
}

TEST(Resolve, BesideAnIncludingFile) {
    const Scratch folder;
    folder.write("lib/optics.glsl", "x");
    folder.write("lib/deep/fresnel.glsl", "x");
    folder.write("common.glsl", "x");
    Files files(folder.path());
    const std::string from = folder.path("lib/optics.glsl");
    EXPECT_EQ(files.resolve_beside(from, "deep/fresnel.glsl").path, folder.path("lib/deep/fresnel.glsl"));
    EXPECT_EQ(files.resolve_beside(from, "../common.glsl").path, folder.path("lib/../common.glsl"));
    EXPECT_EQ(Files(folder.path()).resolve_beside(from, "common.glsl").path, folder.path("common.glsl"))
        << "or the scene's folder";
    EXPECT_TRUE(files.resolve_beside(from, "none.glsl").path.empty());
    // No file system finds it there.
    const glsl::IncludeReader reader = shader_includes(files);
    EXPECT_TRUE(reader(from, "gone/../../common.glsl", false)->inexact);
    EXPECT_FALSE(reader(from, "../common.glsl", false)->inexact);
}

TEST(Read, WholeFileCounted) {
    const Scratch folder;
    const std::string content = std::string("a\0b\r\n", 5) + std::string(200'000, 'z');
    folder.write("a.bin", content);
    folder.write("empty", "");
    Files files(folder.path());
    std::string error;
    EXPECT_EQ(files.read(folder.path("a.bin"), error), content);
    EXPECT_EQ(files.read(folder.path("empty"), error), "");
    EXPECT_EQ(files.read(folder.path("a.bin"), error), content);
    EXPECT_EQ(files.counters().opened, 3U);
    EXPECT_EQ(files.counters().bytes, 2 * content.size());
    EXPECT_EQ(files.read_paths(), (std::vector<std::string>{folder.path("a.bin"), folder.path("empty")}));
}

TEST(Read, RefusesWhatIsNoFileWithoutWaiting) {
    const Scratch folder;
    ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
    Files files(folder.path());
    const auto start = std::chrono::steady_clock::now();
    for (const std::string& path :
         {folder.path("pipe"), folder.path(), std::string("/dev/zero"), folder.path("none")}) {
        std::string error;
        EXPECT_FALSE(files.read(path, error)) << path;
        EXPECT_FALSE(error.empty()) << path;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30) * patience);
    EXPECT_EQ(files.counters().opened, 0U);
    EXPECT_TRUE(files.read_paths().empty());
}

TEST(Read, RefusesWhatIsTooLarge) {
    const Scratch folder;
    folder.write("huge", "");
    std::filesystem::resize_file(folder.path("huge"), Limits{}.file_bytes + 1);  // sparse
    Files files(folder.path());
    std::string error;
    EXPECT_FALSE(files.read(folder.path("huge"), error));
    EXPECT_NE(error.find("file-bytes"), std::string::npos) << error;
}

TEST(Read, CreatesNothing) {
    const Scratch folder;
    folder.write("only", "x");
    Files files(folder.path());
    std::string error;
    (void)files.resolve("missing/name.bmp", {"bmp"});
    (void)files.read(folder.path("missing"), error);
    EXPECT_EQ(folder.entries(), 1U);
}

TEST(Read, ATextThatStandsInForAFile) {
    const Scratch folder;
    folder.write("a", "old");
    folder.write("b", "other");
    Access access;
    access.instead = std::make_shared<const std::map<std::string, std::string>>(
        std::map<std::string, std::string>{{folder.path("a"), "new"}});
    Files files(folder.path(), access);
    std::string error;
    EXPECT_EQ(files.read(files.resolve("A").path, error), "new") << "by whatever name it is found";
    EXPECT_EQ(files.read(files.resolve("b").path, error), "other");
    EXPECT_EQ(*files.read_once(folder.path("a"), error), "new");
}

TEST(Read, FromSeveralThreads) {
    const Scratch folder;
    folder.write("a", "12345");
    Files files(folder.path());
    {
        std::vector<std::jthread> threads;
        for (int t = 0; t < 4; ++t) {
            threads.emplace_back([&] {
                for (int i = 0; i < 200; ++i) {
                    std::string error;
                    ASSERT_TRUE(files.read(files.resolve("A").path, error));
                }
            });
        }
    }
    EXPECT_EQ(files.counters().opened, 800U);
    EXPECT_EQ(files.counters().bytes, 4000U);
    EXPECT_EQ(files.read_paths().size(), 1U);
}

TEST(Endings, CountWithoutRegardToCaseAndOnlyBehindAName) {
    EXPECT_TRUE(has_extension("a/light.VERT", "vert"));
    EXPECT_TRUE(has_extension("light.vert.glsl", "vert.glsl"));
    for (const char* other : {"vert", ".vert", "a/.vert", "lightvert", "light.verte", "light.vert/", ""})
        EXPECT_FALSE(has_extension(other, "vert")) << other;
}

TEST(Endings, OfEveryStageAreThoseOfShaders) {
    for (const char* shader : {"a.vert", "a.tcs", "a.tese", "a.gs", "a.FSH", "a.glsl", "b.frag.glsl"})
        EXPECT_TRUE(is_shader_name(shader)) << shader;
    for (const char* other : {"a.glib", "a.obj", "frag", ".frag", "a.frag.png"})
        EXPECT_FALSE(is_shader_name(other)) << other;
}

TEST(Endings, OfTextsAreTrimmed) {
    EXPECT_EQ(trimmed(" \t a b \r\n"), "a b");
    EXPECT_EQ(trimmed(" \t\n"), "");
    EXPECT_EQ(trimmed("xx a x", "x"), " a ");
    EXPECT_EQ(lowered("uKa_Z\xC3\x84"), "uka_z\xC3\x84") << "ASCII only";
}

}  // namespace
}  // namespace snell
