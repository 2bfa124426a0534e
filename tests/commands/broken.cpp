// A scene with an error ends every subcommand that reads what scenes mean with status 1.
#include <map>
#include <regex>

#include "src/app/help/program.h"
#include "tests/commands/web.h"

namespace snell::test {
namespace {

// What each subcommand is asked of a scene; in the others, scenes are texts or belong to somebody else.
const std::map<std::string_view, std::vector<std::string>> asked{
    {"render", {"-o o.png --size 16x16"}},
    {"sweep", {"--over uA=0:1:2 -o 'o{uA}.png' --size 16x16"}},
    {"check", {"", "--no-lint", "--json"}},
    {"compare", {"fine.glib --size 16x16"}},
    {"explain", {"--no-time --size 16x16"}},
    {"accuracy", {"--list-found", "--apply 1 -o rung", "--no-time --no-found --knobs samples --size 16x16"}},
    {"save", {"--set uA=.6 -o saved.glib"}},
    {"web", {"-o page.html"}},
};
const std::map<std::string_view, std::string_view> reasons{
    {"new", "reads no scene"},       {"grade", "reports errors of submissions"},
    {"format", "lays out any text"}, {"commands", "reads no scene"},
    {"info", "reads no scene"},      {"lsp", "reports errors to editors"},
    {"help", "reads no scene"},      {"complete", "says what is there"},
};

using BrokenScenes = WebTest;

TEST_F(BrokenScenes, EndEverySubcommandWithOne) {
    const std::string scene = "Vertex a.vert\nFragment FRAGMENT\nProgram P uA <0. .5 1.>\nSphere 1\n";
    const auto with = [&](const std::string& fragment, const std::string& more) {
        return std::string(scene).replace(scene.find("FRAGMENT"), 8, fragment) + more;
    };
    folder.write("a.vert", "void main() { gl_Position = ftransform(); }\n");
    folder.write("a.frag", "uniform float uA;\nvoid main() { gl_FragColor = vec4(exp2(uA * 3.)); }\n");
    folder.write("b.frag", "uniform float uA;\nvoid main() { gl_FragColor = vec4(exp2(uA * 3.) + uB); }\n");
    folder.write("fine.glib", with("a.frag", ""));
    folder.write("statement.glib", with("a.frag", "Sphree 1\n"));
    folder.write("file.glib", with("missing.frag", ""));
    folder.write("shader.glib", with("b.frag", ""));
    for (const app::Subcommand& row : app::subcommands()) {
        const auto found = asked.find(row.name);
        ASSERT_NE(found != asked.end(), reasons.contains(row.name)) << row.name << " is in neither list, or in both";
        if (found == asked.end()) continue;
        for (const std::string& options : found->second)
            for (const char* name : {"fine.glib", "statement.glib", "file.glib", "shader.glib"}) {
                const Outcome outcome =
                    snell(std::string(row.name) + " " + name + " " + options, "SNELL_WEB=web", folder.path());
                EXPECT_EQ(outcome.status, name == std::string_view("fine.glib") ? 0 : 1)
                    << row.name << ' ' << name << ' ' << options << '\n'
                    << outcome.output;
                if (found->first == "save" && outcome.status == 1) {
                    EXPECT_FALSE(std::filesystem::exists(folder.path("saved.glib"))) << name;
                }
                std::filesystem::remove(folder.path("saved.glib"));
            }
    }
}

TEST_F(BrokenScenes, LimitsOfTheDriverAreToldWithTheirNumbers) {
    folder.write("a.frag", "void main() { gl_FragColor = vec4(1.); }\n");
    folder.write("a.geom",
                 "#version 330 compatibility\nlayout(points) in; layout(points, max_vertices = 100000) out;\n"
                 "void main() {}\n");
    const std::string text =
        snell("check " + folder.write("a.glib", "Geometry a.geom\nFragment a.frag\nProgram P\nQuadXY\n")).output;
    EXPECT_TRUE(std::regex_search(
        text, std::regex("output vertices \\(100000\\) exceeds GL_MAX_GEOMETRY_OUTPUT_VERTICES \\([0-9]+\\)")))
        << text;
}

}  // namespace
}  // namespace snell::test
