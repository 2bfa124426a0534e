// Full disks, folders that may not be written to, and processes that are killed: the old file or the new one.
#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>
#include <nlohmann/json.hpp>

#include "src/app/desktop/settings.h"
#include "src/app/open/states.h"
#include "src/app/open/write_copy.h"
#include "src/app/window/survive/recovery.h"
#include "src/content/image/image.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "tests/cli/run.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

class Disk : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("p.frag", "uniform float uA;\nvoid main() { gl_FragColor = vec4(uA, 0., 0., 1.); }\n");
        folder.write("s.glib", scene);
    }
    std::string at(const std::string& name) const { return folder.path(name); }

    // Each kind of output: the command, and the file that it writes.
    struct Output {
        std::string command, file;
    };
    std::vector<Output> outputs() const {
        const std::string s = at("s.glib");
        const std::string small = " --size 64x48 ";
        std::vector<Output> all;
        for (const char* extension : {"png", "bmp", "exr", "jpg"}) {
            const std::string file = at(std::string("out/o.") + extension);
            all.push_back({"render " + s + small + "-o " + file, file});
        }
        const std::string picture = "render " + s + small + "-o " + at("o.png");
        const std::string noise = "render " + at("noise.glib") + " --size 300x300 --tile 64 -o ";
        all.push_back({noise + at("out/tiled.png"), at("out/tiled.png")});
        all.push_back({picture + " --json " + at("out/o.json"), at("out/o.json")});
        all.push_back({picture + " --stats " + at("out/stats.json"), at("out/stats.json")});
        all.push_back({picture + " --sheet " + at("out/sheet.png"), at("out/sheet.png")});
        all.push_back({"save " + s + " --set uA=.75 -o " + at("out/copy.glib"), at("out/copy.glib")});
        return all;
    }

    // The same of `snell accuracy`: each report, and the presets, which stand beside the scene.
    std::vector<Output> reports() const {
        folder.write("ladder.frag",
                     "void main() {\n#if WAY == WAY_dark\n  gl_FragColor = vec4(.2);\n#else\n"
                     "  gl_FragColor = vec4(.4);\n#endif\n}\n");
        const std::string text =
            "Ladder WAY dark <light>\nOrtho -1 1 -1 1\nFragment ../ladder.frag\nProgram P\nQuadXY 0 .5\n";
        const std::string l = folder.write("out/l.glib", text);
        const std::string measure = "accuracy " + l + " --ladders WAY --size 16x16 ";
        std::vector<Output> all{
            {measure + "--reps 3 --budget 1 --save-quality", at("out/l.quality.json")},
            {measure + "--no-time --markdown " + at("out/r.md") + " --svg " + at("plot.svg"), at("out/r.md")}};
        const std::array<std::array<const char*, 2>, 5> formats{{{"-o", "out/r.html"},
                                                                 {"--slide", "out/r.png"},
                                                                 {"--svg", "out/r.svg"},
                                                                 {"--json", "out/r.json"},
                                                                 {"--csv", "out/r.csv"}}};
        for (const auto& [option, name] : formats)
            all.push_back({measure + "--no-time " + option + " " + at(name), at(name)});
        return all;
    }

    void expect_no_parts() const {
        for (const auto& entry : fs::directory_iterator(at("out")))
            EXPECT_FALSE(entry.path().filename().string().ends_with(".part")) << entry.path();
    }

    // What goes before its commands; none where root may write everywhere, and there is nobody else to be.
    std::optional<std::string> as_one_who_may_not_write() const {
        using fs::perms;
        fs::permissions(at("out"), perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec);
        fs::permissions(folder.path(), perms::all);
        const std::string as = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
        if (!as.empty() && run(as + "test -r " + at("s.glib") + " && ! " + as + "touch " + at("out/x")).status != 0)
            return std::nullopt;
        return as;
    }
    void expect_refused(const std::string& as, const Output& output) const {
        const Outcome refused = run(as + SNELL_BIN "/snell " + output.command);
        EXPECT_EQ(refused.status, 1) << output.command << '\n' << refused.output;
        EXPECT_TRUE(refused.says("Permission denied")) << output.command << '\n' << refused.output;
        EXPECT_EQ(bytes_of(output.file), "old") << output.command;
    }

    const std::string scene = "Ortho -1 1 -1 1\nFragment p.frag\nProgram P uA <0. .5 1.>\nQuadXY 0 .5\n" + comments();
    static std::string comments() {
        std::string text;
        for (int i = 0; i < 200; ++i)
            text += "# so that it is longer than what the disk takes " + std::to_string(i) + "\n";
        return text;
    }
};

TEST_F(Disk, EveryOutputSaysThatTheDiskIsFullAndLeavesTheOldFile) {
    folder.write(
        "noise.frag",
        "void main() { gl_FragColor = vec4(fract(sin(gl_FragCoord.xyx * vec3(12.9, 78.2, 3.7)) * 43758.5), 1.); }\n");
    folder.write("noise.glib", "Ortho -1 1 -1 1\nFragment noise.frag\nProgram N\nQuadXY 0 1\n");
    folder.write("out/p.frag", bytes_of(at("p.frag")));  // a scene is saved only where it finds its files
    for (const Output& output : outputs()) {
        std::ofstream(output.file) << "old";
        // In blocks of 1024 bytes; nothing at all for what is shorter.
        const bool large = output.file.find("tiled") != std::string::npos || output.file.ends_with(".glib");
        const Outcome full =
            run("ulimit -f " + std::string(large ? "4" : "0") + "; exec " SNELL_BIN "/snell " + output.command);
        EXPECT_EQ(full.status, 1) << output.command << '\n' << full.output;
        EXPECT_TRUE(full.says("File too large")) << output.command << '\n' << full.output;
        EXPECT_EQ(bytes_of(output.file), "old") << output.command;
    }
    expect_no_parts();
    for (const Output& output : outputs()) {
        EXPECT_EQ(snell(output.command).status, 0) << output.command;
        EXPECT_GT(bytes_of(output.file).size(), 100U) << output.command << ": the test can fail";
    }
}

TEST_F(Disk, ReportsAndPresetsOfAFullDiskAreTheOldOnes) {
    const std::vector<Output> all = reports();
    for (const Output& output : all) {
        std::ofstream(output.file) << "old";
        const Outcome full = run("ulimit -f 0; exec " SNELL_BIN "/snell " + output.command);
        EXPECT_EQ(full.status, 1) << output.command << '\n' << full.output;
        EXPECT_TRUE(full.says("File too large")) << output.command << '\n' << full.output;
        EXPECT_EQ(bytes_of(output.file), "old") << output.command;
    }
    expect_no_parts();
    for (const Output& output : all) {
        EXPECT_EQ(snell(output.command).status, 0) << output.command;
        EXPECT_GT(bytes_of(output.file).size(), 100U) << output.command << ": the test can fail";
    }
}

// What is printed is lost, and the status tells.
TEST_F(Disk, StandardOutputThatIsFull) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    for (const std::string& command : {"check --json " + at("s.glib"), std::string("info"), std::string("commands"),
                                       "explain --no-time --size 8x8 " + at("s.glib")}) {
        const Outcome full = snell(command + " >/dev/full");
        EXPECT_EQ(full.status, 1) << command << '\n' << full.output;
        EXPECT_TRUE(full.says("No space left on device")) << command << '\n' << full.output;
        EXPECT_EQ(snell(command).status, 0) << command;
    }
}

TEST_F(Disk, ValuesOfASceneStayOnAFullDisk) {
    const Outcome full = run("ulimit -f 4; exec " SNELL_BIN "/snell save " + at("s.glib") + " --set uA=.75");
    EXPECT_EQ(full.status, 1) << full.output;
    EXPECT_TRUE(full.says("File too large")) << full.output;
    EXPECT_EQ(bytes_of(at("s.glib")), scene);
}

TEST_F(Disk, SnapshotsStayOnAFullDisk) {
    auto document = open_file(at("s.glib"));
    ASSERT_EQ(store_snapshot(1, *document), "");
    const std::string before = bytes_of(at("s.snapshots.json"));
    const auto usual_signal = std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    getrlimit(RLIMIT_FSIZE, &usual);
    const rlimit small{20, usual.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = store_snapshot(2, *document);
    setrlimit(RLIMIT_FSIZE, &usual);
    std::signal(SIGXFSZ, usual_signal);
    EXPECT_NE(error.find("File too large"), std::string::npos) << error;
    EXPECT_EQ(bytes_of(at("s.snapshots.json")), before);
}

// As the window does it: two snapshots that a full disk refused, of values that are no longer those of now.
TEST_F(Disk, SnapshotsThatAreTriedAgainHoldTheValuesOfThen) {
    auto document = open_file(at("s.glib"));
    Keeper keeper(document->path);
    ui::Memory memory;
    const auto serve = [&](const ui::Requests& requests) { return keeper.serve(requests, *document, {}, memory); };
    std::vector<double>& value = document->controls.items.front().value;
    fs::create_directory(at("s.snapshots.json"));
    for (const auto& [number, a] : {std::pair{8, .62}, {9, .94}}) {
        value = {a};
        serve({.store_snapshot = number});
    }
    ASSERT_EQ(memory.failures.open.size(), 2U);
    fs::remove(at("s.snapshots.json"));
    for (const ui::Failure& failure : std::vector(memory.failures.open))
        serve({.store_snapshot = failure.snapshot, .values = failure.values});
    EXPECT_TRUE(memory.failures.open.empty());
    for (const auto& [number, a] : {std::pair{8, .62}, {9, .94}}) {
        ASSERT_EQ(restore_snapshot(number, *document).error, "");
        EXPECT_EQ(value, std::vector{a}) << number;
    }
}

TEST_F(Disk, TheRealErrorOfAFullDevice) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
    const Outcome full = snell("render " + at("s.glib") + " --size 8x8 -o " + at("o.png") + " --json /dev/full");
    EXPECT_EQ(full.status, 1);
    EXPECT_TRUE(full.says("No space left on device")) << full.output;
    EXPECT_TRUE(fs::exists(at("o.png"))) << "the rest is done";
}

// As another user: root may write everywhere.
TEST_F(Disk, FoldersThatMayNotBeWrittenTo) {
    fs::create_directory(at("out"));
    std::vector<std::string> old;
    folder.write("noise.glib", "QuadXY\n");
    for (const Output& output : outputs()) std::ofstream(output.file) << "old";
    const auto as = as_one_who_may_not_write();
    if (!as) GTEST_SKIP() << "this user may write everywhere";
    for (const Output& output : outputs()) {
        fs::remove(at("o.png"));
        expect_refused(*as, output);
    }
    fs::permissions(at("out"), fs::perms::owner_all);
}

TEST_F(Disk, FoldersThatReportsMayNotBeWrittenTo) {
    const std::vector<Output> all = reports();
    for (const Output& output : all) std::ofstream(output.file) << "old";
    const auto as = as_one_who_may_not_write();
    if (!as) GTEST_SKIP() << "this user may write everywhere";
    for (const Output& output : all) expect_refused(*as, output);
    fs::permissions(at("out"), fs::perms::owner_all);
}

// ---- kills ---------------------------------------------------------------------------------------------------------

// A child does `work` again and again until it is killed; then `whole` says whether what there is is whole.
void kill_at_moments(int count, const std::function<void(int)>& work, const std::function<bool()>& whole) {
    std::mt19937 random(11);
    int during = 0;
    for (int moment = 0; moment < count; ++moment) {
        int begun[2];
        ASSERT_EQ(pipe(begun), 0);
        const pid_t child = fork();
        if (child == 0) {
            for (int round = 0;; ++round) {
                work(round);
                if (round == 0 && write(begun[1], "x", 1) != 1) _exit(1);
            }
        }
        close(begun[1]);
        char byte = 0;
        EXPECT_EQ(read(begun[0], &byte, 1), 1);
        close(begun[0]);
        std::this_thread::sleep_for(std::chrono::microseconds(random() % 6000));
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        during += WIFSIGNALED(status) ? 1 : 0;
        ASSERT_TRUE(whole()) << "moment " << moment;
    }
    EXPECT_EQ(during, count);
}

TEST_F(Disk, KilledWhileSavingValuesTheSceneIsOldOrNew) {
    auto document = open_file(at("s.glib"));
    document->controls.items.front().value = {.75};
    const Saved saved = saved_values(*document);
    ASSERT_EQ(saved.files.size(), 1U);
    const std::string after = saved.files.front().after;
    kill_at_moments(
        25, [&](int round) { round % 2 == 0 ? write_saved(saved.files) : revert_saved(saved.files); },
        [&] {
            const std::string now = bytes_of(at("s.glib"));
            std::ofstream(at("s.glib")) << scene;  // for the next one
            return now == scene || now == after;
        });
}

TEST_F(Disk, KilledWhileStoringSnapshotsTheyAreOldOrNew) {
    auto document = open_file(at("s.glib"));
    ASSERT_EQ(store_snapshot(1, *document), "");
    kill_at_moments(
        25,
        [&](int round) {
            document->controls.items.front().value = {round % 2 == 0 ? .25 : .5};
            store_snapshot(1 + round % 9, *document);
        },
        [&] {
            const auto now = nlohmann::json::parse(bytes_of(at("s.snapshots.json")), nullptr, false);
            if (!now.is_object() || now.empty()) return false;
            for (const auto& [number, snapshot] : now.items()) {
                const std::string options = snapshot.value("options", "");
                const auto has = [&](const char* line) { return options.find(line) != options.npos; };
                if (!has("--set P.uA=0.25\n") && !has("--set P.uA=0.5\n")) return false;
            }
            return true;
        });
}

// Reports, presets and statistics are written so.
TEST_F(Disk, KilledWhileWritingTextItIsOldOrNew) {
    const std::array<std::string, 2> texts{std::string(300'000, 'a'), std::string(200'000, 'b')};
    ASSERT_EQ(content::replace_file(at("r.html"), texts[0]), "");
    kill_at_moments(
        25, [&](int round) { content::replace_file(at("r.html"), texts[static_cast<std::size_t>((round + 1) % 2)]); },
        [&] {
            const std::string now = bytes_of(at("r.html"));
            return now == texts[0] || now == texts[1];
        });
}

TEST_F(Disk, KilledWhileWritingTheWindowsSettingsTheyAreOldOrNew) {
    Settings settings;
    settings.recent = {"/a/one.glib", "/b/two.glib"};
    ASSERT_EQ(write_settings(at("window.json"), settings), "");
    kill_at_moments(
        25,
        [&](int round) {
            settings.zoom = round % 2 == 0 ? 1.5 : 2;
            write_settings(at("window.json"), settings);
        },
        [&] {
            const Settings now = read_settings(at("window.json"));
            return now.recent == settings.recent && (now.zoom == 1 || now.zoom == 1.5 || now.zoom == 2);
        });
}

TEST_F(Disk, KilledWhileWritingPicturesTheyAreOldOrNew) {
    for (const char* name : {"o.png", "o.bmp"}) {
        content::Image image;
        image.width = image.height = 200;
        image.channels = 3;
        image.pixels.assign(image.bytes(), std::byte{200});
        content::Image other = image;
        for (std::size_t i = 0; i < other.pixels.size(); ++i) other.pixels[i] = static_cast<std::byte>(i * 7 % 251);
        ASSERT_EQ(content::write_image(at(name), other), "");
        const std::string new_bytes = bytes_of(at(name));
        ASSERT_EQ(content::write_image(at(name), image), "");
        const std::string old_bytes = bytes_of(at(name));
        kill_at_moments(
            12, [&](int round) { content::write_image(at(name), round % 2 == 0 ? other : image); },
            [&] {
                const std::string now = bytes_of(at(name));
                return now == old_bytes || now == new_bytes;
            });
    }
}

// ---- saving values is confined and limited as everything else ------------------------------------------------------

TEST_F(Disk, SavingReadsNothingOutsideAndKeepsTheLimits) {
    fs::create_directory(at("in"));
    fs::create_symlink("../s.glib", at("in/link.glib"));
    const std::string command = "save " + at("in/link.glib") + " --set uA=.75 -o " + at("copy.glib");
    EXPECT_EQ(snell(command).status, 1) << "the link's folder lacks the scene's shader";
    EXPECT_FALSE(fs::exists(at("copy.glib")));
    fs::copy(at("p.frag"), at("in/p.frag"));
    EXPECT_EQ(snell(command).status, 0);
    EXPECT_TRUE(fs::remove(at("copy.glib")));
    const Outcome confined = snell(command + " --confine " + at("in"));
    EXPECT_EQ(confined.status, 1);
    EXPECT_TRUE(confined.says("outside")) << confined.output;
    const Outcome limited = snell(command + " --limit text-bytes=100");
    EXPECT_EQ(limited.status, 1);
    EXPECT_TRUE(limited.says("'text-bytes' is 100")) << limited.output;
    EXPECT_FALSE(fs::exists(at("copy.glib")));
    EXPECT_EQ(snell(command + " --limit text-byte=0").status, 2);
}

}  // namespace
}  // namespace snell::test
