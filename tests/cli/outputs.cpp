// Outputs are looked at before any work, and one that can't be written costs no other.
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/command.h"

namespace snell::test {

namespace {

namespace fs = std::filesystem;

class Outputs : public CommandTest {
protected:
    void SetUp() override {
        CommandTest::SetUp();
        if (IsSkipped()) return;
        folder.write("way.frag",
                     "uniform float uA;\nvoid main() {\n#if WAY == WAY_dark\n  gl_FragColor = vec4(uA);\n#else\n"
                     "  gl_FragColor = vec4(.4);\n#endif\n}\n");
        folder.write("s.glib", scene);
        for (const char* name : {"out", "d.ext"}) fs::create_directory(folder.path(name));
        fs::create_directory_symlink("out", folder.path("link"));
        folder.write("out/old.json", "old");
        fs::create_symlink("out/old.json", folder.path("alias.json"));
    }
    // In the folder, as somebody who stands there.
    Outcome in_folder(const std::string& command) const { return snell(command, "", folder.path()); }
    Outcome measure(const std::string& outputs) const {
        return in_folder("accuracy s.glib --ladders WAY --knobs samples --no-time --size 8x8 " + outputs);
    }
    bool there(const std::string& name) const { return fs::exists(folder.path(name)); }

    const std::string scene =
        "Ladder WAY dark <light>\nOrtho -1 1 -1 1\nFragment way.frag\nProgram P uA <0. .5 1.>\nQuadXY 0 .5\n";
};

TEST_F(Outputs, OfAccuracyAreLookedAtBeforeItMeasures) {
    for (const std::string option : {"-o", "--svg", "--json", "--csv", "--markdown"}) {
        const std::string other = option == "--csv" ? "--json out/other" : "--csv out/other";
        for (const std::string place : {"none/r", "out"}) {
            const Outcome refused = measure(other + " " + option + " " + place);
            EXPECT_EQ(refused.status, 1) << option << ' ' << refused.output;
            EXPECT_TRUE(refused.says(place == "out" ? "not a regular file" : "there is no folder none"))
                << refused.output;
            EXPECT_FALSE(refused.says("RMSE")) << option << " was measured: " << refused.output;
        }
        EXPECT_FALSE(there("out/other")) << option;
    }
}

TEST_F(Outputs, SlideIsLookedAtBeforeItMeasures) {
    for (const char* place : {"none/r.png", "out/none/r.pdf"}) {
        const Outcome refused = measure(std::string("--slide ") + place);
        EXPECT_EQ(refused.status, 1) << refused.output;
        EXPECT_TRUE(refused.says("there is no folder")) << refused.output;
        EXPECT_FALSE(refused.says("RMSE")) << refused.output;
    }
    for (const char* wrong :
         {"--slide r.gif", "--slide png", "--slide ''", "--slide r.svg -o r.svg", "--slide a.png --csv ./a.png"}) {
        const Outcome refused = measure(wrong);
        EXPECT_EQ(refused.status, 2) << wrong << ' ' << refused.output;
        EXPECT_FALSE(refused.says("RMSE")) << refused.output;
    }
    EXPECT_TRUE(measure("--slide r.gif").says("'r.gif' does not end in .png, .svg or .pdf"));
    for (const std::string name : {"r.PNG", "r.svg", "r.pdf"}) {
        const Outcome outcome = measure("--slide " + name);
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        EXPECT_GT(bytes_of(folder.path(name)).size(), 1000U) << name;
    }
}

// Whatever a scene reads, by whatever statement, include or rung.
TEST_F(Outputs, NoFileThatASceneReadsIsOverwritten) {
    const std::string png = content::encode_png(content::checkerboard(8));
    const std::map<std::string, std::string> files{
        {"w.glib", "Ladder WAY dark <light>\nInclude part.glib\n"},
        {"part.glib",
         "Ortho -1 1 -1 1\nTexture2D 5 t.png\nCubeMap 6 x+.png x-.png y+.png missing.png z+.png z-.png\nVertex w.vert\n"
         "Fragment w.frag\nProgram P\nQuadXY 0 .5\nObj m.obj\n"},
        {"w.vert", "void main() { gl_Position = ftransform(); }\n"},
        {"w.frag",
         "#if WAY == WAY_dark\n#  include \"out/inc.inc\"\n#endif\nvoid main() { gl_FragColor = vec4(.4); }\n"},
        {"out/inc.inc", "#include \"deep\"\n"},
        {"out/deep.glsl", "#include \"inc.inc\"\n"},
        {"m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
        {"noise3d.064.tex", "not a picture"},
        {"t.png", png},
        {"x-.png", png}};
    for (const auto& [name, text] : files) folder.write(name, text);
    for (const auto& [name, text] : files) {
        if (name.ends_with(".tex")) continue;
        const bool picture = name.ends_with(".png");
        std::vector<std::string> commands{"accuracy s.glib w.glib --no-time --size 8x8 --csv out/c -o link/../" + name,
                                          "render w.glib --size 8x8 -o o.png --json " + name,
                                          "render s.glib w.glib --size 8x8 -o '{stem}.png' --sheet " + name,
                                          "render w.glib --size 8x8 -o o.png --stats ./" + name,
                                          "explain w.glib --no-time --size 8x8 --json=" + name,
                                          "check w.glib --json=" + name,
                                          "check s.glib w.glib --sarif=./" + name,
                                          "compare w.glib s.glib --size 8x8 --json=" + name};
        if (picture) commands.push_back("render w.glib --size 8x8 --skip-existing -o " + name);
        if (name != "w.glib") commands.push_back("save w.glib -o " + name);
        for (const std::string& command : commands) {
            const Outcome refused = in_folder(command);
            EXPECT_EQ(refused.status, 2) << command << ": " << refused.output;
            EXPECT_TRUE(refused.says("is read, and would be overwritten")) << command << ": " << refused.output;
        }
        EXPECT_EQ(bytes_of(folder.path(name)), text) << name;
    }
    for (const char* name : {"o.png", "s.png", "out/c"}) EXPECT_FALSE(there(name)) << name << " was written";
}

TEST_F(Outputs, ACopyOfASceneThatWouldNotFindItsFilesIsNotWritten) {
    folder.write("w.glib", "Ortho -1 1 -1 1\nFragment w.frag\nProgram P uA <0. .5 1.>\nQuadXY 0 .5\n");
    folder.write("w.frag", "uniform float uA;\nvoid main() { gl_FragColor = vec4(uA, 0., 0., 1.); }\n");
    const Outcome refused = in_folder("save w.glib --set uA=.9 -o out/copy.glib");
    EXPECT_EQ(refused.status, 1) << refused.output;
    EXPECT_TRUE(refused.says("would not find")) << refused.output;
    EXPECT_FALSE(there("out/copy.glib"));
    EXPECT_EQ(in_folder("save w.glib -o ./copy.glib").status, 0);
    EXPECT_EQ(bytes_of(folder.path("copy.glib")), bytes_of(folder.path("w.glib")));
    EXPECT_EQ(in_folder("save w.glib -o link/../w.glib").status, 0) << "the scene's own file";
}

// A link to a file that does not exist yet names that file.
TEST_F(Outputs, OneFileThroughADanglingLinkIsRefused) {
    fs::create_symlink("notyet.csv", folder.path("l1"));
    fs::create_symlink("../l1", folder.path("out/l2"));
    for (const std::string same :
         {"--json l1 --csv notyet.csv", "--csv notyet.csv --json link/l2", "-o l1 --svg out/l2"}) {
        const Outcome refused = measure(same);
        EXPECT_EQ(refused.status, 2) << same << ": " << refused.output;
        EXPECT_FALSE(refused.says("RMSE")) << same << " was measured";
    }
    EXPECT_FALSE(there("notyet.csv"));
    EXPECT_EQ(measure("--csv out/l2").status, 0);
    EXPECT_TRUE(fs::is_symlink(folder.path("l1")) && fs::is_symlink(folder.path("out/l2")));
    EXPECT_GT(bytes_of(folder.path("notyet.csv")).size(), 50U);
}

// Permissions alone don't tell, least of all for root.
TEST_F(Outputs, WhereNoFileCanBeMadeIsRefusedBeforeItMeasures) {
    fs::create_symlink("b", folder.path("a"));
    fs::create_symlink("a", folder.path("b"));
    for (const std::string option : {"-o", "--json", "--csv", "--markdown", "--svg"})
        for (const std::string place : {"/proc/x.html", "a"}) {
            const Outcome refused = measure(option + " " + place);
            EXPECT_EQ(refused.status, 1) << option << ' ' << refused.output;
            EXPECT_TRUE(refused.says("cannot write '" + place + "': ")) << refused.output;
            EXPECT_FALSE(refused.says("': " + place + ": ")) << "twice: " << refused.output;
            EXPECT_FALSE(refused.says("RMSE")) << option << " was measured: " << refused.output;
        }
    EXPECT_TRUE(fs::is_symlink(folder.path("a")));
    for (const std::string option : {"-o", "--json", "--csv", "--markdown", "--svg"})
        EXPECT_EQ(measure(option + " ''").status, 2) << option;
    for (const std::string option : {"--json", "--sheet", "--stats"})
        EXPECT_EQ(in_folder("render s.glib -o o.png " + option + " ''").status, 2) << option;
    EXPECT_FALSE(there("o.png"));
}

TEST_F(Outputs, OneFileForTwoReportsIsRefused) {
    for (const std::string& same : std::vector<std::string>{
             "-o same --json same", "-o same --csv ./same", "-o out/same --csv link/same", "--svg same --markdown same",
             "--json out/old.json --csv alias.json", "-o out/../same --csv same", "--svg p.svg --json p-2.svg",
             "--json s.glib", "--csv ../" + fs::path(folder.path()).filename().string() + "/s.glib"}) {
        const Outcome refused = measure(same);
        EXPECT_EQ(refused.status, 2) << same << ": " << refused.output;
        EXPECT_FALSE(refused.says("RMSE")) << same << " was measured";
    }
    for (const char* name : {"same", "out/same", "p.svg", "p-2.svg"}) EXPECT_FALSE(there(name)) << name;
    EXPECT_EQ(bytes_of(folder.path("s.glib")), scene);
    EXPECT_EQ(bytes_of(folder.path("out/old.json")), "old");
    EXPECT_EQ(measure("--json /dev/null --csv /dev/null").status, 0) << "nothing is lost there";
}

// In blocks of 512 bytes, the page is larger than what the disk takes, the others are smaller.
TEST_F(Outputs, AReportThatFailsCostsNoOther) {
    const Outcome full = run("cd '" + folder.path() +
                             "' && ulimit -f 11 && exec " SNELL_BIN
                             "/snell accuracy s.glib --ladders WAY --no-time --size 64x64 -o r.html "
                             "--json r.json --csv r.csv --svg r.svg --markdown r.md");
    EXPECT_EQ(full.status, 1) << full.output;
    EXPECT_TRUE(full.says("cannot write 'r.html': ")) << full.output;
    EXPECT_FALSE(there("r.html"));
    EXPECT_TRUE(nlohmann::json::accept(bytes_of(folder.path("r.json"))));
    for (const char* name : {"r.csv", "r.svg", "r.md"}) EXPECT_GT(bytes_of(folder.path(name)).size(), 50U) << name;
}

TEST_F(Outputs, PlotsAreNumberedBeforeTheirExtension) {
    const std::array<std::array<const char*, 3>, 4> plots{{{"./p", "p", "p-2"},
                                                           {"d.ext/p", "d.ext/p", "d.ext/p-2"},
                                                           {"d.ext/q.svg", "d.ext/q.svg", "d.ext/q-2.svg"},
                                                           {"a.b.svg", "a.b.svg", "a.b-2.svg"}}};
    for (const auto& [option, first, second] : plots) {
        const Outcome outcome = measure("--svg " + std::string(option));
        EXPECT_EQ(outcome.status, 0) << option << ": " << outcome.output;
        for (const char* name : {first, second}) EXPECT_TRUE(bytes_of(folder.path(name)).starts_with("<svg")) << name;
    }
}

TEST_F(Outputs, PagesNameTheirPlots) {
    for (const std::string& page : {std::string("out/page.md"), folder.path("out/page.md")}) {
        const Outcome outcome = in_folder(
            "accuracy s.glib --ladders WAY --reps 7 --budget 60 --size 8x8 --svg ./p.svg "
            "--markdown " +
            page);
        EXPECT_EQ(outcome.status, 0) << outcome.output;
        EXPECT_NE(bytes_of(folder.path("out/page.md")).find("(../p.svg)"), std::string::npos) << page;
    }
}

TEST_F(Outputs, OfPicturesAreLookedAtBeforeAnythingIsDrawn) {
    const std::string sweep = "sweep s.glib --over uA=0,1 --size 8x8 -o 'out/{uA}.png' ";
    for (const char* same : {"--json r --sheet r", "--json r --stats ./r", "--sheet out/1.png", "--sheet link/1.png",
                             "--json s.glib", "--json out/old.json --stats alias.json"})
        EXPECT_EQ(in_folder(sweep + same).status, 2) << same;
    for (const std::string option : {"--json", "--sheet", "--stats"})
        for (const char* place : {" none/r", " out"})
            EXPECT_EQ(in_folder(sweep + option + place).status, 1) << option << place;
    EXPECT_EQ(in_folder("render s.glib -o out/0.png --size 8x8 --json out/../out/0.png").status, 2);
    EXPECT_FALSE(there("out/0.png")) << "something was drawn";
    EXPECT_EQ(bytes_of(folder.path("s.glib")), scene);
    const Outcome fine = in_folder(sweep + "--json r.json --sheet r.png --stats r.txt");
    EXPECT_EQ(fine.status, 0) << fine.output;
    EXPECT_TRUE(there("out/0.png") && there("r.json") && there("r.png") && there("r.txt"));
}

class StandardOutput : public CommandTest {
protected:
    std::string out(const std::string& arguments) const {
        return snell(arguments + " 2> said", "", folder.path()).output;
    }
};

TEST_F(StandardOutput, IsADashWhereOneFileIsWritten) {
    folder.write("s.glib", "Sphere 1\n");
    EXPECT_EQ(out("render s.glib -o - --size 8x8").substr(1, 3), "PNG");
    EXPECT_EQ(out("render s.glib --output=- --size 8x8").substr(1, 3), "PNG");
    EXPECT_EQ(out("render s.glib -o p.png --size 8x8 --sheet -").substr(1, 3), "PNG");
    EXPECT_EQ(out("render s.glib -o p.png --size 8x8 --stats -").front(), '{');
    EXPECT_FALSE(std::filesystem::exists(at("-")));
}

TEST_F(StandardOutput, JsonTakesAFileOrNothing) {
    folder.write("s.glib", "Sphere 1\n");
    for (const std::string command : {"check s.glib", "render s.glib -o p.png --size 8x8", "explain s.glib --no-time",
                                      "commands", "compare s.glib s.glib --size 8x8"}) {
        const std::string printed = out(command + " --json");
        EXPECT_TRUE(printed.starts_with("{") || printed.starts_with("[")) << command << ": " << printed;
        EXPECT_TRUE(out(command + " --json -").starts_with(printed.substr(0, 1))) << command;
        for (const std::string file : {" --json f.json", " --json=f.json"}) {
            std::filesystem::remove(at("f.json"));
            out(command + file);
            EXPECT_EQ(bytes_of(at("f.json")).substr(0, 1), printed.substr(0, 1)) << command << file;
        }
    }
    const std::string scene = bytes_of(at("s.glib"));
    EXPECT_EQ(out("check --json s.glib").front(), '[') << "a scene is no file to write";
    EXPECT_EQ(snell("check " + at("s.glib") + " --json=" + at("s.glib")).status, 2);
    EXPECT_EQ(bytes_of(at("s.glib")), scene);
}

// A shell that writes into one file before and after.
TEST_F(StandardOutput, OfAFileIsWrittenWhereItStands) {
    folder.write("s.glib", "Sphere 1\n");
    for (const std::string command : {"check s.glib --json", "render s.glib --size 8x8 -o -"}) {
        const std::string alone = out(command);
        run("cd '" + folder.path() + "' && (echo before; " SNELL_BIN "/snell " + command +
            "; echo after) > log 2> said");
        EXPECT_TRUE(bytes_of(at("log")) == "before\n" + alone + "after\n") << command;
    }
}

TEST_F(StandardOutput, ChecksForServices) {
    folder.write("good.glib", "Sphere 1\n");
    folder.write("warns.glib", "Sphere 1 9 9 9\n");
    folder.write("bad.glib", "Sphre 1\n");
    EXPECT_EQ(snell("check --werror " + at("good.glib")).status, 0);
    EXPECT_EQ(snell("check " + at("warns.glib")).status, 0);
    EXPECT_EQ(snell("check --werror " + at("warns.glib")).status, 1);
    const std::string lines = out("check --lines warns.glib bad.glib");
    EXPECT_EQ(std::count(lines.begin(), lines.end(), '\n'), 2) << lines;
    EXPECT_NE(lines.find("bad.glib:1:1: error: "), std::string::npos) << lines;
    EXPECT_TRUE(lines.ends_with("[unknown-command]\n")) << lines;
    const auto log = nlohmann::json::parse(out("check --sarif warns.glib bad.glib"), nullptr, false);
    ASSERT_TRUE(log.is_object());
    EXPECT_EQ(log["version"], "2.1.0");
    const auto found = log["runs"][0]["results"];
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0]["level"], "warning");
    EXPECT_EQ(found[1]["ruleId"], "unknown-command");
    const auto place = found[1]["locations"][0]["physicalLocation"];
    EXPECT_EQ(place["artifactLocation"]["uri"], "bad.glib");
    EXPECT_EQ(place["region"]["startColumn"], 1);
    EXPECT_EQ(place["region"]["endColumn"], 6);
}

TEST_F(StandardOutput, ScenesOfOneNameAreToldApart) {
    for (const std::string who : {"ann", "bob"}) folder.write("class/" + who + "/work/project.glib", "Sphere 1\n");
    const std::string scenes = "render class/*/work/project.glib --size 8x8 --json=r.json ";
    out(scenes + "-o 'p-{path}.png'");
    for (const char* file : {"p-ann.png", "p-bob.png"}) EXPECT_TRUE(std::filesystem::exists(at(file))) << file;
    out(scenes + "-o 'q-{parent}-{dir}.png'");
    EXPECT_TRUE(std::filesystem::exists(at("q-bob-work.png")));
    EXPECT_TRUE(snell(scenes + "-o '{stem}.png'", "", folder.path()).says("{path}"));
    folder.write("class/eve/work/project.glib", "Sphre 1\n");
    const Outcome outcome = snell(scenes + "-o 'r-{path}.png' --set uNone=1", "", folder.path());
    EXPECT_TRUE(outcome.says("class/ann/work/project.glib: error: ")) << outcome.output;
    const auto json = nlohmann::json::parse(bytes_of(at("r.json")), nullptr, false);
    ASSERT_EQ(json["results"].size(), 3u);
    EXPECT_EQ(json["results"][0]["status"], "not drawn");
    EXPECT_EQ(json["results"][2]["errors"], 2);
}

}  // namespace

}  // namespace snell::test
