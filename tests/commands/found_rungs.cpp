// `snell accuracy --list-found` and --apply: what they write, and what they leave alone.
#include <nlohmann/json.hpp>

#include "src/accuracy/found/change.h"
#include "src/accuracy/found/search.h"
#include "src/app/open/write_copy.h"
#include "tests/cli/run.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;
using namespace snell::accuracy;

constexpr std::string_view ball_scene =
    "##OpenGL GLIB\nOrtho -1.5 1.5 -1.5 1.5\nLookAt 0 0 3 0 0 0 0 1 0\nTexture2D 5 tex/wood.bmp\nVertex lit.vert\n"
    "Fragment lit.frag\nProgram Lit uUnit 5\nSphere 1 30 30\n";
constexpr std::string_view ball_vertex =
    "varying vec3 vN;\nvarying vec2 vST;\nvoid main() {\n  vN = gl_Normal;\n  vST = gl_MultiTexCoord0.st;\n"
    "  gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex;\n}\n";
constexpr std::string_view ball_fragment =
    "#include \"sub/shade.glsl\"\nuniform sampler2D uUnit;\nvarying vec3 vN;\nvarying vec2 vST;\n"
    "void main() { // ends\n  gl_FragColor = vec4(shade(vN) * texture2D(uUnit, vST).rgb, 1.);\n}\n";
constexpr std::string_view ball_shade =
    "// how light it is\r\nfloat shade(vec3 n) {\r\n  float sum = 0.;\r\n  for (int i = 0; i < 8; ++i)\r\n"
    "    sum += .1 * abs(n.z) + .01 * sin(float(i) * n.x);\r\n  return sum;\r\n}";

class FoundRungs : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("work/ball.glib", ball_scene);
        folder.write("work/lit.vert", ball_vertex);
        folder.write("work/lit.frag", ball_fragment);
        folder.write("work/sub/shade.glsl", ball_shade);
        folder.write("work/tex/wood.bmp", bmp(2, 2, {{90, 60, 30}, {200, 150, 90}, {10, 20, 30}, {255, 250, 240}}));
    }
    Outcome accuracy(const std::string& arguments) const { return snell("accuracy " + arguments, "", folder.path()); }
    // The bytes of all files by their names.
    std::map<std::string, std::string> everything(const std::string& name) const {
        std::map<std::string, std::string> files;
        if (!fs::exists(folder.path(name))) return files;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path(name)))
            if (entry.is_regular_file())
                files[fs::relative(entry.path(), folder.path(name)).string()] = bytes_of(entry.path());
        return files;
    }
    Picture drawn(const std::string& path, const Access& access = {}, const RungChooser& choose = nullptr) {
        const auto document = open_document(path, caps, choose, nullptr, {}, access);
        expect_clean(*document);
        return draw(*document, {.width = 48, .height = 48});
    }
    void expect_same_pictures(const std::string& path, std::size_t most = 1000);
};

struct Read {
    Read(const std::string& path, const gl::Caps& caps) : files(scene_folder(path)) {
        plan = read_plan(path, files, sources, unheard).value();
        changes = find_changes(plan, files, sources);
        fill_averages({path, plan, files, sources}, changes, caps);
    }
    Files files;
    Sources sources;
    Diagnostics unheard;
    Plan plan;
    std::vector<Change> changes;
};

// For changes of the scene: what is written is drawn as what is measured.
// `most`: of each kind.
void FoundRungs::expect_same_pictures(const std::string& path, std::size_t most) {
    Read read(path, caps);
    std::string error;
    std::map<ChangeKind, std::size_t> of_kind;
    for (std::size_t i = 0; i < read.changes.size(); ++i) {
        if (++of_kind[read.changes[i].kind] > most) continue;
        const std::string number = std::to_string(i + 1);
        SCOPED_TRACE(path + " " + number + ": " + change_line(read.changes[i], read.sources));
        const auto chosen = choose_changes(number, read.changes, read.sources, error);
        if (!read.changes[i].probes.empty()) continue;  // it shows nowhere
        ASSERT_TRUE(chosen) << error;
        const std::array<const Change*, 1> measured{&read.changes[i]}, plain{&chosen->changes.front()};
        Access instead;
        instead.instead =
            std::make_shared<const std::map<std::string, std::string>>(changed_texts(measured, read.sources));
        const auto tried = open_document(path, caps, nullptr, nullptr, {}, instead);
        if (tried->diagnostics.has_errors()) continue;  // it is refused, and has no number in a report
        const Picture changed = drawn(path, instead);
        const auto copy =
            app::write_copy(path, {}, changed_texts(plain, read.sources), folder.path("applied/" + number));
        ASSERT_EQ(copy.error, "");
        EXPECT_TRUE(drawn(copy.scene) == changed);
    }
    fs::remove_all(folder.path("applied"));
}

TEST_F(FoundRungs, WhatIsWrittenIsDrawnAsWhatIsMeasured) {
    expect_same_pictures(folder.path("work/ball.glib"));
    expect_same_pictures(SNELL_ROOT "/scenes/light/mirror/mirror.glib", 1);
}

TEST_F(FoundRungs, AMeanIsDrawnWhenItIsWritten) {
    folder.write("mean/a.vert",
                 "varying vec2 vP;\nvoid main() { vP = gl_Vertex.xy; gl_Position = vec4(vP, 0., 1.); }\n");
    folder.write("mean/a.frag",
                 "varying vec2 vP;\nvoid main() {\n    float a = exp(vP.x);\n    gl_FragColor = vec4(.3 * a);\n}\n");
    folder.write("mean/a.glib", "Vertex a.vert\nFragment a.frag\nProgram A\nQuadXY 0 1\n");
    const std::string list = accuracy("mean/a.glib --list-found").output;
    const std::size_t line = list.rfind('\n', list.find("expression-mean")) + 1;
    const std::string number = std::to_string(std::atoi(list.c_str() + line));
    EXPECT_NE(list.find("exp(vP.x) → float(its mean over the picture)"), std::string::npos) << list;
    const Outcome applied = accuracy("mean/a.glib --apply " + number + " -o applied");
    ASSERT_EQ(applied.status, 0) << applied.output;
    EXPECT_TRUE(applied.says("exp(vP.x) → float(1.18)")) << applied.output;
    EXPECT_NE(bytes_of(folder.path("applied/a.frag")).find("    float a = float(1.18);\n"), std::string::npos);
}

TEST_F(FoundRungs, TheListHasNumbersAndPlaces) {
    const Outcome outcome = accuracy("work/ball.glib --list-found --json list.json");
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    const auto json = nlohmann::json::parse(bytes_of(folder.path("list.json")));
    EXPECT_EQ(json["scene"], "work/ball.glib");
    ASSERT_FALSE(json["found"].empty());
    EXPECT_TRUE(outcome.says("work/ball.glib:8:1: Sphere 1 30 30 → Sphere 1 ")) << outcome.output;
    for (std::size_t i = 0; i < json["found"].size(); ++i) {
        EXPECT_EQ(json["found"][i]["number"], i + 1);
        EXPECT_TRUE(outcome.says(json["found"][i]["kind"].get<std::string>()));
    }
    EXPECT_EQ(accuracy("work/ball.glib --list-found").output, outcome.output) << "the same numbers in every run";
    EXPECT_EQ(accuracy("work/ball.glib --list-found --json work/lit.vert").status, 2) << "that is a shader";
    EXPECT_EQ(bytes_of(folder.path("work/lit.vert")), ball_vertex);
}

// A branch that a rung compiles has changes of its own, so the numbers are others.
TEST_F(FoundRungs, NumbersAreOfTheRungsThatAreChosen) {
    folder.write("work/two.glib",
                 "##OpenGL GLIB\nOrtho -1 1 -1 1\nLadder WAY <short> long\nVertex q.vert\nFragment q.frag\nProgram Q\n"
                 "QuadXY 0. 1.\n");
    folder.write("work/q.vert", "void main() { gl_Position = gl_Vertex; }\n");
    folder.write("work/q.frag",
                 "void main() {\n  float a = 0.;\n#if WAY == WAY_long\n"
                 "  for (int i = 0; i < 24; ++i)\n    a += sin(float(i));\n#else\n"
                 "  for (int i = 0; i < 16; ++i)\n    a += cos(float(i));\n#endif\n  gl_FragColor = vec4(a);\n}\n");
    const Outcome own = accuracy("work/two.glib --list-found");
    EXPECT_TRUE(own.says("i < 16") && !own.says("i < 24")) << own.output;
    const Outcome other = accuracy("work/two.glib --list-found --ladder WAY=long --json list.json");
    ASSERT_EQ(other.status, 0) << other.output;
    EXPECT_TRUE(other.says("i < 24") && !other.says("i < 16")) << other.output;
    const auto json = nlohmann::json::parse(bytes_of(folder.path("list.json")));
    std::string number;
    for (const auto& one : json["found"])
        if (one["kind"] == "fewer-rounds") number = std::to_string(one["number"].get<int>());
    ASSERT_NE(number, "");
    const Outcome applied = accuracy("work/two.glib --ladder WAY=long -o applied --apply " + number);
    EXPECT_TRUE(applied.status == 0 && applied.says("i < 24 → ")) << applied.output;
    const std::string text = bytes_of(folder.path("applied/q.frag"));
    EXPECT_EQ(text.find("i < 24"), std::string::npos) << text;
    EXPECT_NE(text.find("i < 16"), std::string::npos) << text;
    const Outcome wrong = accuracy("work/two.glib --ladder WAY=none --list-found");
    EXPECT_TRUE(wrong.status == 1 && wrong.says("ladder 'WAY' has no rung 'none'")) << wrong.output;
    const Outcome hint = accuracy("work/two.glib --ladder WAY=long -o out --apply 999");
    EXPECT_TRUE(hint.says("list them by: snell accuracy work/two.glib --ladder WAY=long --list-found\n"))
        << hint.output;
}

TEST_F(FoundRungs, TheFolderHasTheSceneWithTheChangeAndAllItsFiles) {
    const auto before = everything("work");
    const Outcome outcome = accuracy("work/ball.glib --apply 1 -o new/folder/");
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_TRUE(outcome.says("wrote new/folder/ball.glib (5 files)")) << outcome.output;
    EXPECT_TRUE(outcome.says(" → ")) << outcome.output;
    EXPECT_EQ(everything("work"), before) << "nothing of the author's changes";
    auto after = everything("new/folder");
    std::size_t changed = 0;
    for (const auto& [name, bytes] : before) {
        ASSERT_TRUE(after.contains(name)) << name;
        changed += after[name] != bytes;
    }
    EXPECT_EQ(after.size(), before.size());
    EXPECT_EQ(changed, 1u);
    EXPECT_EQ(accuracy("work/ball.glib --apply 1 -o new/folder").status, 0) << "all of it is there already";
    EXPECT_EQ(everything("new/folder"), after);
}

TEST_F(FoundRungs, WrongNumbersAndOptionsAreErrors) {
    const auto before = everything("");
    const auto refused = [&](const std::string& arguments, int status, std::string_view why) {
        const Outcome outcome = accuracy(arguments);
        EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.output;
        EXPECT_TRUE(outcome.says(why)) << arguments << "\n" << outcome.output;
    };
    refused("work/ball.glib --apply 999 -o new", 1, "'999' is not the number of a found rung; they go from 1 to ");
    refused("work/ball.glib --apply 999 -o new", 1, "list them by: snell accuracy work/ball.glib --list-found\n");
    refused("work/ball.glib --apply x -o new", 1, "'x' is not the number");
    refused("work/ball.glib --apply 1,2 -o new", 1, "'1,2' is not the number of a found rung");
    refused("work/ball.glib --apply 1", 2, "add -o FOLDER");
    refused("work/ball.glib --apply 1 -o new --budget 3", 2, "--apply excludes --budget: it only writes a scene");
    refused("work/ball.glib --list-found -o new", 2, "--list-found excludes");
    refused("work/ball.glib work/ball.glib --list-found", 2, "one scene");
    refused("work/none.glib --list-found", 1, "cannot read 'work/none.glib'");
    refused("work/ball.glib --apply 1 -o work/lit.vert", 1, "is not a folder");
    EXPECT_EQ(everything(""), before) << "nothing was written";
}

TEST_F(FoundRungs, NothingOfTheUsersIsReplaced) {
    const auto refused = [&](const std::string& to, std::string_view why) {
        const auto before = everything("");
        const Outcome outcome = accuracy("work/ball.glib --apply 1 -o " + to);
        EXPECT_EQ(outcome.status, 1) << outcome.output;
        EXPECT_TRUE(outcome.says(why)) << outcome.output;
        EXPECT_EQ(everything(""), before) << "all or nothing";
    };
    refused("work", "has the scene itself");
    refused("work/sub/..", "has the scene itself");
    fs::create_directory_symlink(folder.path("work"), folder.path("link"));
    refused("link", "has the scene itself");
    folder.write("mine/lit.frag", "precious");
    refused("mine", "'mine/lit.frag' exists with another content");
    folder.write("file/sub", "precious");
    refused("file", "'file/sub' is a file, where a folder is needed");
    // Links within the folder are not followed to files elsewhere.
    folder.write("elsewhere/empty", "");
    fs::create_directories(folder.path("linked"));
    fs::create_directory_symlink(folder.path("elsewhere"), folder.path("linked/sub"));
    refused("linked", "'linked/sub' is a link");
    fs::create_directories(folder.path("dangling"));
    fs::create_symlink(folder.path("elsewhere/nowhere"), folder.path("dangling/lit.frag"));
    refused("dangling", "'dangling/lit.frag' exists with another content");
    fs::create_directories(folder.path("fifo"));
    ASSERT_EQ(run("mkfifo " + folder.path("fifo/lit.vert")).status, 0);
    refused("fifo", "'fifo/lit.vert' exists with another content");
    // The same bytes by a link are left as they are.
    fs::create_directories(folder.path("same"));
    fs::create_symlink(folder.path("work/lit.frag"), folder.path("same/lit.frag"));
    EXPECT_EQ(accuracy("work/ball.glib --apply 1 -o same").status, 0);
    EXPECT_TRUE(fs::is_symlink(folder.path("same/lit.frag")));
    // A folder that is a link is what the user named.
    fs::create_directories(folder.path("target"));
    fs::create_directory_symlink(folder.path("target"), folder.path("to"));
    EXPECT_EQ(accuracy("work/ball.glib --apply 1 -o to").status, 0);
    EXPECT_EQ(everything("target").size(), 5u);
}

TEST_F(FoundRungs, FilesOfOtherFoldersKeepTheirPlaces) {
    folder.write("work/deep/down.glib", "Include ../ball.inc\n");
    folder.write("work/ball.inc", ball_scene);
    const Outcome outcome = accuracy("work/deep/down.glib --apply 1 -o out");
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_TRUE(outcome.says("wrote out/deep/down.glib (6 files)")) << outcome.output;
    EXPECT_TRUE(fs::exists(folder.path("out/ball.inc")));
    EXPECT_TRUE(fs::exists(folder.path("out/tex/wood.bmp")));
    EXPECT_NE(bytes_of(folder.path("out/ball.inc")), ball_scene) << "the change is in the included text";
    drawn(folder.path("out/deep/down.glib"));
    // A text that changes must be found in the copy, not at the author's.
    std::string absolute(ball_scene);
    folder.write("work/abs.glib", "Include " + folder.path("work/ball.inc") + "\n");
    const Outcome refused = accuracy("work/abs.glib --apply 1 -o out2");
    EXPECT_EQ(refused.status, 1);
    EXPECT_TRUE(refused.says("its absolute name leads to the old text")) << refused.output;
    EXPECT_FALSE(fs::exists(folder.path("out2")));
}

TEST_F(FoundRungs, AnErrorWhileWritingLeavesNothing) {
    folder.write("work/tex/wood.bmp", bmp(40, 40, std::vector<std::array<int, 3>>(1600, {9, 9, 9})));
    const auto before = everything("");
    const Outcome outcome = run("cd " + folder.path() +
                                " && ulimit -f 2 && " SNELL_BIN "/snell accuracy work/ball.glib --apply 1 -o some/new");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_TRUE(outcome.says("File too large")) << outcome.output;
    EXPECT_EQ(everything(""), before);
    EXPECT_FALSE(fs::exists(folder.path("some")));
}

// It needs no graphics, and is quick.
TEST_F(FoundRungs, ListsNeedNoGraphics) {
    const double before = processor_seconds();
    const Outcome outcome = run("cd " SNELL_ROOT " && env __EGL_VENDOR_LIBRARY_FILENAMES=/none " SNELL_BIN
                                "/snell accuracy scenes/refraction-room/refraction-room.glib --list-found");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_LT(processor_seconds() - before, 2.);
}

}  // namespace
}  // namespace snell::test
