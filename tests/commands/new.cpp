// `snell new`: folders that are complete, and what prevents one.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "src/app/open/templates.h"
#include "src/app/picture/non_finite.h"
#include "tests/cli/run.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

class New : public testing::Test {
protected:
    Outcome make(const std::string& arguments) const { return snell("new " + arguments, "", folder.path()); }
    std::set<std::string> files(const std::string& name) const {
        std::set<std::string> found;
        for (const auto& entry : fs::recursive_directory_iterator(folder.path(name)))
            if (entry.is_regular_file()) found.insert(fs::relative(entry.path(), folder.path(name)).string());
        return found;
    }
    Scratch folder;
};

TEST_F(New, EachKindIsCompleteAndWithoutWarnings) {
    for (const app::Kind& kind : app::kinds()) {
        const std::string name(kind.name);
        const Outcome made = make(name + "-1 --kind " + name);
        ASSERT_EQ(made.status, 0) << made.output;
        EXPECT_TRUE(made.says(name + "-1/" + name + "-1.glib")) << made.output;
        EXPECT_EQ(files(name + "-1").size(), app::files_of(kind, "x").size());
        // Moved away, so that nothing next to it can help.
        fs::create_directory(folder.path("elsewhere-" + name));
        fs::rename(folder.path(name + "-1"), folder.path("elsewhere-" + name + "/moved"));
        const Outcome checked =
            snell("check --grade " + folder.path("elsewhere-" + name + "/moved/" + name + "-1.glib"));
        EXPECT_EQ(checked.status, 0) << name << '\n' << checked.output;
        EXPECT_EQ(checked.output, "") << name;
    }
}

TEST_F(New, WordsOfTheNameChooseTheKind) {
    const auto kind = [](std::string_view name) {
        std::string found;
        for (const app::Choice& choice : app::kinds_for(name))
            found += (found.empty() ? "" : " ") + std::string(choice.kind->name);
        return found;
    };
    EXPECT_EQ(kind("glass"), "refract");
    EXPECT_EQ(kind("My Glass Ball"), "refract");
    EXPECT_EQ(kind("refract_glass"), "refract") << "two words of one kind";
    EXPECT_EQ(kind("homework3-mirror2"), "reflect");
    EXPECT_EQ(kind("glasses"), "") << "a whole word";
    EXPECT_EQ(kind("glass\xC3\xA9"), "") << "a letter beyond ASCII goes on with the word";
    EXPECT_EQ(kind("glass-mirror-glass"), "refract reflect") << "they disagree";
    EXPECT_EQ(kind("project"), "");
    EXPECT_EQ(kind(""), "");
    EXPECT_EQ(kind("lab-2-bump"), "bump");
    for (const app::Kind& one : app::kinds()) EXPECT_EQ(kind(one.name), one.name);
    EXPECT_TRUE(make("glass").says("kind refract because of 'glass' in the name"));
    EXPECT_TRUE(make("mirror --kind noise").says("kind noise\n"));
    EXPECT_EQ(make("--kind image").status, 0);
    EXPECT_TRUE(fs::exists(folder.path("image/image.glib"))) << "named after its kind";
    EXPECT_TRUE(make("").says("kind blank\n")) << "no name was given that could have chosen it";
    EXPECT_TRUE(fs::exists(folder.path("blank/blank.glib")));
}

TEST_F(New, NamesThatChooseNoKindAreAskedBack) {
    const struct {
        std::string name, error, help;
    } cases[] = {
        {"glass-noise", "words of the name 'glass-noise' disagree: 'glass' for refract, 'noise' for noise",
         "choose one: snell new glass-noise --kind refract|noise\n"},
        {"hologram", "no word of the name 'hologram' says which kind of scene it is",
         "help: choose one: snell new hologram --kind blank|noise|bump|displace|image|geometry|reflect|refract\n"},
        {"lab-bumb", "no word of the name",
         "help: did you mean 'bump'? Otherwise choose one: snell new lab-bumb --kind"},
    };
    for (const auto& one : cases) {
        const Outcome asked = make(one.name);
        EXPECT_EQ(asked.status, 2) << asked.output;
        EXPECT_TRUE(asked.says(one.error)) << asked.output;
        EXPECT_TRUE(asked.says(one.help)) << asked.output;
    }
    EXPECT_EQ(folder.entries(), 0u);
    EXPECT_TRUE(make("hologram --kind blank").says("kind blank\n"));
    EXPECT_TRUE(make("bump").says("kind bump because of 'bump' in the name"));
}

TEST_F(New, UnusualNamesWork) {
    for (const std::string name :
         {"My first scene", "H\xC3\xBCtte", "it's", "a\"b", "v1.2", "\xE5\x9B\xBE", "x#y", "$HOME"}) {
        std::string quoted;
        for (const char c : name) quoted += c == '\'' ? "'\\''" : std::string(1, c);
        const Outcome made = make("'" + quoted + "' --kind blank");
        ASSERT_EQ(made.status, 0) << made.output;
        const std::string line = made.output.substr(made.output.find("open it: snell ") + 15);
        const Outcome checked = snell("check " + line, "", folder.path());
        EXPECT_EQ(checked.status, 0) << line << checked.output;
        EXPECT_TRUE(fs::exists(folder.path(name + "/" + name + ".glib"))) << name;
    }
    fs::create_directory(folder.path("deep"));
    EXPECT_EQ(make("deep/glass/").status, 0);
    EXPECT_EQ(make("deep/../noise").status, 0);
    EXPECT_TRUE(fs::exists(folder.path("deep/glass/glass.glib")));
    EXPECT_TRUE(fs::exists(folder.path("noise/noise.glib")));
}

TEST_F(New, NothingIsOverwritten) {
    folder.write("glass/own.txt", "mine");
    fs::create_directory(folder.path("empty"));
    folder.write("file", "mine");
    fs::create_symlink("nowhere", folder.path("link"));
    const std::size_t before = folder.entries();
    for (const char* name : {"glass", "glass/", "./glass", "empty", "file", "link"}) {
        const Outcome outcome = make(std::string(name) + " --kind noise");
        EXPECT_EQ(outcome.status, 1) << name;
        EXPECT_TRUE(outcome.says("exists already")) << outcome.output;
        EXPECT_TRUE(outcome.says("-2'")) << outcome.output;
    }
    EXPECT_EQ(folder.entries(), before);
    EXPECT_EQ(bytes_of(folder.path("glass/own.txt")), "mine");
    make("glass-2");
    EXPECT_TRUE(make("glass").says("'glass-3'"));
}

TEST_F(New, ImpossibleNamesAreErrorsAndLeaveNothing) {
    folder.write("file", "");
    const std::string long_name(300, 'x');
    const struct {
        std::string name, says;
        int status;
    } cases[] = {
        {"''", "name", 2},
        {"..", "'..' is not a name for a new folder", 2},
        {".", "'.' is not a name", 2},
        {"a/..", "is not a name", 2},
        {"/", "'/' is not a name", 2},
        {"$'a\\nb'", "control characters", 2},
        {"$'a\\eb'", "control characters", 2},
        {"glass.glib", "did you mean 'snell new glass'?", 2},
        {"file/glass", "cannot make 'file/glass': Not a directory", 1},
        {"missing/file/" + long_name + "-glass", "File name too long", 1},
        {"/proc/glass", "cannot make '/proc/glass'", 1},
        {long_name + "-glass", "File name too long", 1},
        {"a --kind glas", "glas", 2},
        {"a b", "b", 2},
    };
    const std::size_t before = folder.entries();
    for (const auto& one : cases) {
        const Outcome outcome = run("cd " + folder.path() + " && bash -c \"" SNELL_BIN "/snell new " + one.name + "\"");
        EXPECT_EQ(outcome.status, one.status) << one.name << '\n' << outcome.output;
        EXPECT_TRUE(outcome.says(one.says)) << one.name << '\n' << outcome.output;
        EXPECT_TRUE(outcome.output.find('\x1B') == std::string::npos) << outcome.output;
        EXPECT_EQ(folder.entries(), before) << one.name;
    }
}

TEST_F(New, FoldersAboveItAreMadeToo) {
    EXPECT_EQ(make("out/week-1/glass").status, 0);
    EXPECT_TRUE(files("out/week-1/glass").contains("glass.glib"));
    EXPECT_EQ(make("out/mirror").status, 0);
    const Outcome outcome = run("cd " + folder.path() + " && (ulimit -f 20; exec " SNELL_BIN "/snell new a/b/glass)");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_FALSE(fs::exists(folder.path("a"))) << "a failure leaves nothing";
}

// A disk that is full in the middle: files may have 20,000 bytes at most here.
TEST_F(New, AFailureInTheMiddleLeavesNothing) {
    const Outcome outcome = run("cd " + folder.path() + " && (ulimit -f 20; exec " SNELL_BIN "/snell new glass)");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_TRUE(outcome.says("cannot make 'glass'")) << outcome.output;
    EXPECT_EQ(folder.entries(), 0u);
}

class NewScenes : public GlTest {};

// What the picture of a kind shows, and that no end of a slider makes a number that is none.
TEST_F(NewScenes, SlidersHaveSensibleEnds) {
    for (const app::Kind& kind : app::kinds()) {
        std::string scene;
        for (const app::NewFile& file : app::files_of(kind, "scene")) {
            const std::string path = folder.write(std::string(kind.name) + "/" + file.path, file.bytes);
            if (scene.empty()) scene = path;
        }
        const auto document = open_file(scene);
        expect_clean(*document);
        const Picture first = draw(*document, {.time = .25});
        int sliders = 0;
        const auto finite = [&](const Controls& controls, const std::string& where) {
            const auto found = app::count_non_finite(*document->runtime, {.25, {}, controls}, 64, 64);
            ASSERT_TRUE(found);
            EXPECT_EQ(found->nan + found->infinite, 0u) << kind.name << ' ' << where;
        };
        finite(document->controls, "as it is");
        for (std::size_t i = 0; i < document->controls.items.size(); ++i) {
            const snell::Control& control = document->controls.items[i];
            if (control.widget != Widget::slider && control.widget != Widget::check_box) continue;
            ++sliders;
            bool changes = false;
            for (const double end : {control.min, control.max}) {
                Controls moved = document->controls;
                moved.items[i].value[0] = end;
                finite(moved, control.name + " at an end");
                std::swap(moved, document->controls);
                changes = changes || draw(*document, {.time = .25}) != first;
                std::swap(moved, document->controls);
            }
            EXPECT_TRUE(changes) << kind.name << ": " << control.name << " changes nothing";
        }
        EXPECT_GE(sliders, 1) << kind.name;
    }
}

}  // namespace
}  // namespace snell::test
