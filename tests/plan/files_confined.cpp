// Files that are confined to a folder, whatever happens meanwhile.
#include "src/plan/files.h"
#include "src/plan/texts.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

Access inside(const Scratch& folder) { return {{}, folder.path("in")}; }

TEST(Confined, ResolvesOnlyWhatLiesInside) {
    const Scratch folder;
    folder.write("in/a.bmp", "inside");
    folder.write("out/a.bmp", "outside");
    folder.write("in2/a.bmp", "a folder with a longer name");
    fs::create_symlink("../out/a.bmp", folder.path("in/link.bmp"));
    fs::create_symlink("a.bmp", folder.path("in/own.bmp"));
    const Files files(folder.path("in"), inside(folder));
    EXPECT_FALSE(files.resolve("a.bmp").path.empty());
    EXPECT_FALSE(files.resolve("own.bmp").path.empty()) << "a link that stays inside";
    EXPECT_FALSE(files.resolve("../in/a.bmp").path.empty());
    EXPECT_TRUE(files.resolve("link.bmp").path.empty());
    EXPECT_NE(files.resolve("link.bmp").refused, "");
    EXPECT_TRUE(files.resolve("../out/b.bmp").nearest.empty()) << "what stands outside is not told";
    // Only the own file of that name, never the other's.
    for (const char* name : {"../out/a.bmp", "../in2/a.bmp", "../OUT/A.bmp"}) {
        const std::string path = files.resolve(name).path;
        EXPECT_TRUE(path.empty() || fs::canonical(path) == fs::canonical(folder.path("in/a.bmp"))) << name << path;
    }
    const Files beside(folder.path("in"), inside(folder));
    EXPECT_NE(beside.resolve_beside(folder.path("out/s.glib"), "a.bmp").path, folder.path("out/a.bmp"));
}

TEST(Confined, ReadsOnlyWhatLiesInside) {
    const Scratch folder;
    folder.write("in/a", "inside");
    folder.write("out/a", "outside");
    fs::create_symlink("../out", folder.path("in/up"));
    Files files(folder.path("in"), inside(folder));
    std::string error;
    EXPECT_EQ(files.read(folder.path("in/a"), error), "inside");
    for (const std::string& path : {folder.path("out/a"), folder.path("in/../out/a"), folder.path("in/up/a")}) {
        EXPECT_FALSE(files.read(path, error)) << path;
        EXPECT_NE(error.find("outside"), std::string::npos) << error;
    }
    Files nowhere(folder.path("in"), {{}, folder.path("missing")});
    EXPECT_FALSE(nowhere.read(folder.path("in/a"), error)) << "a folder that is not there holds nothing";
}

TEST(Confined, AllowedFoldersAreReadToo) {
    const Scratch folder;
    folder.write("in/a", "inside");
    folder.write("shared/a.bmp", "shared");
    folder.write("shared2/b.bmp", "a folder with a longer name");
    fs::create_symlink("../shared/a.bmp", folder.path("in/link.bmp"));
    Access access = inside(folder);
    access.allow = {folder.path("shared"), folder.path("missing")};
    Files files(folder.path("in"), access);
    std::string error;
    for (const char* name : {"../shared/a.bmp", "link.bmp"}) {
        const std::string path = files.resolve(name).path;
        EXPECT_EQ(files.read(path, error), "shared") << name << path << error;
    }
    EXPECT_EQ(files.read(folder.path("in/a"), error), "inside");
    EXPECT_TRUE(files.resolve("../shared2/b.bmp").path.empty());
    EXPECT_NE(files.resolve("../shared2/b.bmp").refused, "");
    EXPECT_FALSE(files.read(folder.path("shared2/b.bmp"), error));
    EXPECT_FALSE(files.read(folder.path("shared/../shared2/b.bmp"), error));
}

TEST(Confined, AllowedFoldersAreASearchPath) {
    const Scratch folder;
    for (const char* file :
         {"in/own.bmp", "shared/own.bmp", "shared/a/wall.bmp", "shared/b/wall.bmp", "shared/Pig.obj"})
        folder.write(file, file);
    Access access = inside(folder);
    access.allow = {folder.path("shared")};
    const Files files(folder.path("in"), access);
    const auto found = [&](const std::string& name) {
        const Resolved resolved = files.resolve(name, {"obj"});
        const std::string path =
            resolved.path.empty() ? "" : fs::path(resolved.path).lexically_relative(folder.path("")).string();
        return path + (resolved.inexact ? " (inexact)" : "");
    };
    EXPECT_EQ(found("own.bmp"), "in/own.bmp");
    EXPECT_EQ(found("wall.bmp"), "shared/a/wall.bmp") << "the first of them";
    EXPECT_EQ(found("b/wall.bmp"), "shared/b/wall.bmp");
    EXPECT_EQ(found("../../b/wall.bmp"), "shared/b/wall.bmp");
    EXPECT_EQ(found("C:\\models\\Pig.obj"), "shared/Pig.obj");
    EXPECT_EQ(found("pig"), "shared/Pig.obj (inexact)");
    EXPECT_EQ(found("Pug.obj"), "");
    EXPECT_EQ(files.resolve_beside(folder.path("shared/a/x.glib"), "own.bmp").path, folder.path("in/own.bmp"))
        << "the scene's own files come first";
    EXPECT_EQ(files.resolve_beside(folder.path("shared/a/x.glib"), "wall.bmp").path, folder.path("shared/a/wall.bmp"));
}

// A link that is turned around between looking and opening.
TEST(Confined, ARaceIsLost) {
    const Scratch folder;
    folder.write("in/a", "inside");
    folder.write("out", "outside");
    fs::create_symlink("a", folder.path("in/good"));
    fs::create_symlink("../out", folder.path("in/bad"));
    fs::copy_symlink(folder.path("in/good"), folder.path("in/x"));
    std::atomic<bool> done = false;
    std::jthread turner([&] {
        for (int i = 0; !done; ++i) {
            fs::copy_symlink(folder.path(i % 2 == 0 ? "in/bad" : "in/good"), folder.path("in/y"));
            fs::rename(folder.path("in/y"), folder.path("in/x"));
        }
    });
    Files files(folder.path("in"), inside(folder));
    int read = 0, refused = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::string error;
        const auto text = files.read(folder.path("in/x"), error);
        ASSERT_EQ(text.value_or("inside"), "inside");
        ++(text ? read : refused);
    }
    done = true;
    EXPECT_GT(read, 0);
    EXPECT_GT(refused, 0);
}

TEST(Limits, OfAFileIsNamed) {
    const Scratch folder;
    folder.write("a", "12345678901");
    Access access;
    access.limits.file_bytes = 10;
    Files files(folder.path(), access);
    std::string error;
    EXPECT_FALSE(files.read(folder.path("a"), error));
    EXPECT_NE(error.find("'file-bytes' is 10"), std::string::npos) << error;
}

TEST(Limits, AreSetByName) {
    Limits limits;
    std::string error;
    for (const LimitFacts& limit : limit_table()) {
        EXPECT_TRUE(set_limit(limits, std::string(limit.name) + "=7", error)) << error;
        EXPECT_EQ(limits.*limit.value, 7U) << limit.name;
        EXPECT_LE(Limits{}.*limit.value, limit.most) << limit.name;
    }
    const Limits before = limits;
    for (const char* wrong : {"", "=", "draws", "draws=", "draws=x", "draws=0", "draws=-1", "draws=1e3", "Draws=1",
                              "draws=99999999999999999999", "draws=1 "}) {
        EXPECT_FALSE(set_limit(limits, wrong, error)) << wrong;
        EXPECT_FALSE(error.empty());
    }
    EXPECT_EQ(limits, before);
}

// ---- which files a program's shaders include, by their texts alone -------------------------------------

class ShaderTexts : public testing::Test {
protected:
    // The paths after the stage, relative to the folder.
    std::vector<std::string> included(const std::string& text) {
        PlannedProgram program;
        program.stages.push_back({Stage::fragment, sources.add(folder.path("main.frag"), text), {}});
        Files reader(folder.path());
        const std::vector<ShaderText> texts = shader_texts(program, sources, reader);
        EXPECT_EQ(texts.at(0).text, text);
        std::vector<std::string> names;
        for (std::size_t i = 1; i < texts.size(); ++i) names.push_back(texts[i].path.substr(folder.path().size() + 1));
        return names;
    }

    Scratch folder;
    Sources sources;
};

using Names = std::vector<std::string>;

TEST_F(ShaderTexts, EveryWayToWriteAnInclude) {
    folder.write("a.glsl", "");
    for (const char* text : {"#include \"a.glsl\"\n", "#include\"a.glsl\"", "  #  include  \"a.glsl\"\n",
                             "// #include \"a.glsl\"\n", "#if 0\n#include \"a.glsl\"\n#endif\n", "#include \"a\"\n"})
        EXPECT_EQ(included(text), Names{"a.glsl"}) << text;
    for (const char* text : {"", "include", "#include <a.glsl>\n", "#include \"a.glsl\n", "#include \"b.glsl\"\n",
                             "#include\n\"a.glsl\"\n"})
        EXPECT_TRUE(included(text).empty()) << text;
}

TEST_F(ShaderTexts, ChainsAndCirclesOfIncludesEnd) {
    folder.write("a.glsl", "#include \"lib/b.glsl\"\n#include \"lib/c.glsl\"\n");
    folder.write("lib/b.glsl", "#include \"c.glsl\"\n");
    folder.write("lib/c.glsl", "#include \"b.glsl\"\n#include \"../a.glsl\"\n");
    for (int i = 0; i < 40; ++i)
        folder.write("f" + std::to_string(i) + ".glsl", "#include \"f" + std::to_string(i + 1) + ".glsl\"\n");
    EXPECT_EQ(included("#include \"f0.glsl\"\n").size(), 40U);
    EXPECT_EQ(included("#include \"a.glsl\"\n"), (Names{"a.glsl", "lib/b.glsl", "lib/c.glsl"}));
}

}  // namespace
}  // namespace snell
