// Scenes of strangers: what they name must not be read, must not hang, must not reach the terminal.
#include <fcntl.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include "src/platform/headless.h"
#include "tests/cli/run.h"
#include "tests/sanitized.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

class Hostile : public ::testing::Test {
protected:
    Hostile() { fs::create_directory(at("scene")); }
    std::string at(const std::string& name) const { return folder_.path(name); }
    std::string scene(const std::string& text) const { return folder_.write("scene/s.glib", text); }
    // As a grader calls it.
    test::Outcome check(const std::string& text, const std::string& more = "--grade") const {
        return test::snell("check --no-lint " + more + " " + scene(text));
    }
    Scratch folder_;
};

TEST_F(Hostile, NothingOutsideOfTheFolderIsRead) {
    folder_.write("secret.glib", "swordfish\n");
    folder_.write("secret.frag", "swordfish\n");
    fs::create_symlink("../secret.glib", at("scene/link.glib"));
    fs::create_symlink("..", at("scene/up"));
    fs::create_hard_link(at("secret.frag"), at("scene/own.frag"));
    const std::string names[] = {"../secret.glib",          "link.glib",      "up/secret.glib", at("secret.glib"),
                                 "../scene/../secret.glib", "../SECRET.glib", "up/secret"};
    for (const std::string& name : names) {
        const test::Outcome graded = check("Include " + name + "\nSphere\n");
        EXPECT_EQ(graded.status, 1) << name;
        EXPECT_FALSE(graded.says("swordfish")) << name << '\n' << graded.output;
        const test::Outcome shader = check("Fragment " + name + "\nProgram P\nSphere\n");
        EXPECT_FALSE(shader.says("swordfish")) << name << '\n' << shader.output;
        EXPECT_TRUE(shader.says("confined") || shader.says("no file")) << name << '\n' << shader.output;
        // What is tried is not what stands there.
        EXPECT_FALSE(shader.says("did you mean")) << shader.output;
    }
    // Without bounds the same is read: the test can fail.
    EXPECT_TRUE(check("Include ../secret.glib\n", "").says("swordfish"));
    // What lies inside is read, by a name that leaves the folder and comes back too.
    folder_.write("scene/inside.glib", "swordfish\n");
    EXPECT_TRUE(check("Include ../scene/inside.glib\n").says("swordfish"));
    // What is outside is not taken for the file that includes it.
    folder_.write("s.glib", "swordfish\n");
    folder_.write("same.frag", "swordfish\n");
    folder_.write("scene/same.frag", "#include \"../same.frag\"\nvoid main() { gl_FragColor = vec4(1.); }\n");
    for (const std::string text : {"Include ../s.glib\nSphere\n", "Fragment same.frag\nProgram P\nSphere\n"}) {
        const test::Outcome same = check(text);
        EXPECT_TRUE(same.says(": it is outside of the folder that reading is confined to")) << same.output;
        EXPECT_FALSE(same.says("includes itself")) << same.output;
        EXPECT_FALSE(check(text, "").says("includes itself"));
    }
    // A wider folder may be named.
    EXPECT_TRUE(check("Include ../secret.glib\n", "--confine " + folder_.path()).says("swordfish"));
    // Or one more, and only that one.
    folder_.write("shared/more.glib", "swordfish\n");
    EXPECT_TRUE(check("Include ../shared/more.glib\n", "--grade --allow " + at("shared")).says("swordfish"));
    EXPECT_FALSE(check("Include ../secret.glib\n", "--grade --allow " + at("shared")).says("swordfish"));
    EXPECT_EQ(check("Sphere\n", "--grade --allow " + at("missing")).status, 2);
    // The scene itself may be a link out.
    fs::create_symlink("../secret.glib", at("scene/exam.glib"));
    const test::Outcome exam = test::snell("check --grade " + at("scene/exam.glib"));
    EXPECT_FALSE(exam.says("swordfish")) << exam.output;
    EXPECT_TRUE(exam.says("outside")) << exam.output;
}

// Every file below the folder, with its time.
std::map<std::string, fs::file_time_type> files_in(const std::string& folder) {
    std::map<std::string, fs::file_time_type> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) files[entry.path()] = entry.last_write_time();
    return files;
}

// Neither beside the scene, nor in the home or temporary folder, nor where the command is called. The driver keeps a
// cache of its own, which the environment switches off.
TEST_F(Hostile, NothingIsWrittenButWhatIsNamed) {
    scene(
        "Noise2D 32\nVertex m.vert\nFragment m.frag\nProgram P uEta <.1 1.1 5.>\nSphere 1 20 20\nTranslate 1 0 0\nObj "
        "m.obj\n");
    folder_.write("scene/m.vert", "void main() { gl_Position = ftransform(); }\n");
    folder_.write("scene/m.frag", "uniform float uEta;\nvoid main() { gl_FragColor = vec4(uEta); }\n");
    folder_.write("scene/m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* name : {"home", "tmp", "out", "here"}) fs::create_directory(at(name));
    const std::string environment =
        "env -u XDG_CACHE_HOME -u XDG_CONFIG_HOME -u XDG_STATE_HOME -u XDG_DATA_HOME HOME=" + at("home") +
        " TMPDIR=" + at("tmp") + " MESA_SHADER_CACHE_DISABLE=true ";
    auto before = files_in(folder_.path());
    const std::pair<const char*, const char*> commands[] = {
        {"check SCENE", ""},
        {"render SCENE -o ../out/a.png --size 32x32", "out/a.png"},
        {"explain SCENE", ""},
        {"save SCENE -o ../scene/b.glib --set P.uEta=2", "scene/b.glib"},
        {"info", ""}};
    for (const auto& [command, written] : commands) {
        std::string line = command;
        if (const std::size_t i = line.find("SCENE"); i != line.npos) line.replace(i, 5, at("scene/s.glib"));
        const test::Outcome outcome = test::run("cd " + at("here") + " && " + environment + SNELL_BIN "/snell " + line);
        EXPECT_EQ(outcome.status, 0) << line << '\n' << outcome.output;
        if (*written) {
            const std::string path = at(written);
            ASSERT_TRUE(fs::exists(path)) << line;
            before[path] = fs::last_write_time(path);
        }
        EXPECT_EQ(files_in(folder_.path()), before) << line;
    }
}

TEST_F(Hostile, DevicesPipesAndHugeFilesAreRefusedAtOnce) {
    ASSERT_EQ(mkfifo(at("scene/pipe.glib").c_str(), 0600), 0);
    fs::create_symlink("/dev/zero", at("scene/zero.glib"));
    folder_.write("scene/sparse.glib", "");
    std::error_code error;
    fs::resize_file(at("scene/sparse.glib"), std::uintmax_t{1} << 40, error);  // 1 TB
    const auto start = std::chrono::steady_clock::now();
    for (const char* name : {"pipe.glib", "zero.glib", "sparse.glib"}) {
        const test::Outcome included = check(std::string("Include ") + name + "\nSphere\n", "");
        EXPECT_EQ(included.status, 1) << name;
        const test::Outcome opened = test::snell("check " + at(std::string("scene/") + name));
        EXPECT_EQ(opened.status, 1) << name << '\n' << opened.output;
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30) * patience);
}

TEST_F(Hostile, IncludesEnd) {
    folder_.write("scene/a.glib", "Include b.glib\n");
    folder_.write("scene/b.glib", "Include a.glib\n");
    EXPECT_TRUE(check("Include a.glib\nSphere\n").says("include-cycle"));
    // Twice each: 2^20 readings.
    for (int i = 0; i < 20; ++i)
        folder_.write("scene/d" + std::to_string(i) + ".glib",
                      "Include d" + std::to_string(i + 1) + ".glib\nInclude d" + std::to_string(i + 1) + ".glib\n");
    folder_.write("scene/d20.glib", "Sphere\n");
    const test::Outcome wide = check("Include d0.glib\n", "--limit include-depth=100 --limit includes=500");
    EXPECT_TRUE(wide.says("too-many-includes")) << wide.output.substr(0, 500);
    EXPECT_TRUE(check("Include d0.glib\n").says("include-too-deep"));
}

TEST_F(Hostile, ControlCharactersNeverReachTheTerminal) {
    const std::string evil = "\x1b]0;owned\x07\x1b[2J\r";
    folder_.write("scene/" + evil + ".glib", evil + " 1\n");
    folder_.write("scene/new\nline.glib", "Nonsense\n");
    const test::Outcome named = check("Include \"" + evil + ".glib\"\nObj " + evil + ".obj\nMessageBox " + evil + "\n" +
                                      "Fragment " + evil + ".frag\nProgram P" + evil + "\nSphere\n");
    const std::string text =
        named.output + test::snell("check '" + at("scene/" + evil + ".glib") + "'").output +
        test::snell("check '" + at("scene/new\nline.glib") + "'").output +
        test::snell("render '" + at("scene/" + evil + "none.glib") + "' -o '" + at("scene/" + evil + "/o.png") + "'")
            .output;
    for (const char c : text) ASSERT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20) << static_cast<int>(c);
    EXPECT_NE(text.find("new\\x0Aline.glib:1:1"), std::string::npos) << text;
}

TEST_F(Hostile, LimitsAreNamedAndChanged) {
    const test::Outcome huge = check("Sphere 1 1000000 1000000\nBox\n", "--limit vertices=100000");
    std::string none;
    const bool graphics = HeadlessContext::make({}, none) != nullptr;  // without, no mesh is made
    EXPECT_EQ(huge.status, graphics ? 1 : 0) << huge.output;
    EXPECT_EQ(huge.says("too-many-vertices") && huge.says("'vertices' is 100000"), graphics) << huge.output;
    const test::Outcome many = check("Sphere\nSphere\nSphere\n", "--limit draws=2");
    EXPECT_EQ(many.status, 1);
    EXPECT_TRUE(many.says("too-many-draws") && many.says("'draws' is 2")) << many.output;
    const test::Outcome volume = check("Texture3D 5 9999 9999 9999\nSphere\n", "");
    EXPECT_TRUE(volume.says("texture-bytes")) << volume.output;
    EXPECT_EQ(test::snell("check --limit draw=2 " + at("scene/s.glib")).status, 2);
    EXPECT_EQ(test::snell("check --limit draws=-2 " + at("scene/s.glib")).status, 2);
}

// Old or new, whenever the process is killed.
TEST_F(Hostile, AKilledProcessLeavesNoHalfPicture) {
    const std::string file = scene("Sphere\n"), picture = at("o.png");
    const std::string arguments = "--size 300x300 ";
    ASSERT_EQ(test::snell("render " + file + " -o " + picture + " " + arguments).status, 0);
    const std::string before = bytes_of(picture);
    scene("Color 1 0 0\nBox\n");
    const auto start = std::chrono::steady_clock::now();
    ASSERT_EQ(test::snell("render " + file + " -o " + at("after.png") + " " + arguments).status, 0);
    auto whole = std::chrono::steady_clock::now() - start;
    const std::string after = bytes_of(at("after.png"));
    int killed = 0;
    constexpr int moments = 24;  // most of them near the end, when the file is written
    for (int moment = 0; moment < moments; ++moment) {
        std::ofstream(picture, std::ios::binary) << before;
        const pid_t child = fork();
        if (child == 0) {
            const int nowhere = open("/dev/null", O_WRONLY);
            dup2(nowhere, STDERR_FILENO);
            execl(SNELL_BIN "/snell", "snell", "render", file.c_str(), "-o", picture.c_str(), "--size", "300x300",
                  static_cast<char*>(nullptr));
            _exit(127);
        }
        const auto waits = whole * (moments / 2 + moment) / (moments * 3 / 2 - 1);
        std::this_thread::sleep_for(waits);
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        if (WIFSIGNALED(status))
            ++killed;
        else
            whole = waits;  // the machine was busier when it was measured
        const std::string now = bytes_of(picture);
        ASSERT_TRUE(now == before || now == after) << moment << ": " << now.size() << " bytes";
    }
    EXPECT_GT(killed, 0) << "all were done before";
}

TEST_F(Hostile, AFrameThatDoesNotEndEndsTheProcess) {
    const std::string loop = "  for (int i = 0; i < 60000; ++i) x = fract(sin(x + uOne) * 43758.5);\n";
    folder_.write("scene/s.frag", "uniform float uOne;\nvoid main() {\n  float x = gl_FragCoord.x;\n" + loop + loop +
                                      "  gl_FragColor = vec4(x);\n}\n");
    const std::string file =
        scene("LookAt 0 0 4 0 0 0 0 1 0\nPerspective 90\nFragment s.frag\nProgram P uOne 1.\nQuadXY 0. 9.\n");
    const auto start = std::chrono::steady_clock::now();
    const test::Outcome ended = test::snell("render --size 1024x1024 --timeout 1 " + file + " -o " + at("o.png"));
    EXPECT_EQ(ended.status, 4) << ended.output;
    EXPECT_TRUE(ended.says("[timeout]")) << ended.output;
    EXPECT_FALSE(fs::exists(at("o.png")));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30) * patience);
}

}  // namespace
}  // namespace snell
