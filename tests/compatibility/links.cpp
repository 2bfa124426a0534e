// The small programs are accepted, once translated, by every kind of context and by the reference compiler.
#include <epoxy/gl.h>
#include <cctype>

#include "src/platform/headless.h"
#include "tests/compatibility/draw.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::oracle {
namespace {

// Programs that a kind of context cannot have, and why.
using Impossible = std::map<std::string, std::string_view>;

bool tessellates(const Case& c) { return c.files.contains(Stage::tess_control); }

struct Count {
    int linked = 0, tried = 0;
    std::string failures;

    void add(const Case& c, bool ok, const std::string& reason) {
        ++tried;
        linked += ok ? 1 : 0;
        if (!ok) failures += c.name + ": " + reason + "\n";
    }
    void expect_all(const char* where) const {
        std::printf("%s: %d of %d programs link\n", where, linked, tried);
        EXPECT_EQ(linked, tried) << failures;
    }
};

void link_all(const ContextRequest& request, const glsl::Target& target, const Impossible& impossible,
              const char* where) {
    std::string error;
    const auto context = HeadlessContext::make(request, error);
    if (!context) GTEST_SKIP() << "no graphics: no " << where << " here: " << error;
    Count count;
    for (const Case& c : cases_of_folder("tests/glsl")) {
        if (impossible.contains(c.name) ||
            (tessellates(c) && target.version < 400 && !(target.es && target.version >= 320)))
            continue;
        const Translated t = translated(c, target);
        const Program program = t.ok ? build(t.texts) : Program();
        if (!program.id) write_texts(std::string(where) + "-" + c.name, t.texts);
        count.add(c, program.id != 0, t.ok ? program.log : t.messages);
    }
    count.expect_all(where);
}

const Impossible impossible_33 = {};
const Impossible impossible_es32 = {
    {"array-redeclared", "ES has no arrays without a size"},
    {"point-size-geometry", "ES has the size of points in geometry shaders only as an extension"},
};
const Impossible impossible_es30 = {{"array-redeclared", "ES has no arrays without a size"}};

TEST(Links, OnCore45) { link_all({.version = 45}, {.version = 450, .es = false, .fp64 = true}, {}, "core 4.5"); }

TEST(Links, OnCore33) {
    link_all({.version = 33}, {.version = 330, .es = false, .fp64 = false}, impossible_33, "core 3.3");
}

TEST(Links, OnEs32) {
    link_all({.version = 32, .es = true}, {.version = 320, .es = true, .fp64 = false}, impossible_es32, "ES 3.2");
}

// Only counted: the untouched shaders, as a core profile would take them.
TEST(Links, UntouchedRateIsKnown) {
    std::string error;
    const auto context = HeadlessContext::make({.version = 45}, error);
    if (!context) GTEST_SKIP() << "no graphics: " << error;
    int linked = 0;
    const std::vector<Case> cases = cases_of_folder("tests/glsl");
    for (const Case& c : cases) linked += build(texts(c.files)).id != 0 ? 1 : 0;
    std::printf("untouched on core 4.5: %d of %zu programs link\n", linked, cases.size());
    EXPECT_LT(linked, static_cast<int>(cases.size()) / 2) << "these programs would hardly need a translation";
}

// What the reference compiler says about each file: a line with its name, then complaints. One process for all of
// them, since its start takes longest.
std::map<std::string, std::string> complaints(const std::vector<std::string>& files) {
    std::string command = "glslangValidator";
    for (const std::string& file : files) command += " " + file;
    std::map<std::string, std::string> found;
    std::FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return found;
    std::string current;
    for (char buffer[512]; std::fgets(buffer, sizeof buffer, pipe);) {
        std::string line = buffer;
        while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
        if (std::find(files.begin(), files.end(), line) != files.end()) {
            current = line;
            found[current];
        } else if (!line.empty()) {
            found[current] += line + "\n";
        }
    }
    pclose(pipe);
    return found;
}

// The file under the extension that the reference compiler knows.
std::string reference_file(const std::string& stem, Stage stage, const std::string& text) {
    constexpr std::array<std::string_view, 5> extensions = {".vert", ".tesc", ".tese", ".geom", ".frag"};
    const std::string file = stem + std::string(extensions[static_cast<std::size_t>(stage)]);
    std::ofstream(file, std::ios::binary) << text;
    return file;
}

void reference_accepts(const glsl::Target& target, const Impossible& impossible, const char* where) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no glslangValidator";
    const Scratch folder;
    Count count;
    std::vector<Case> tried;
    std::vector<std::string> files;
    std::map<std::string, std::string> case_of;
    for (const Case& c : cases_of_folder("tests/glsl")) {
        if (impossible.contains(c.name) || (tessellates(c) && target.version == 300)) continue;
        if (target.version == 300 && c.files.contains(Stage::geometry)) continue;
        const Translated t = translated(c, target);
        EXPECT_TRUE(t.ok) << c.name << ": " << t.messages;
        const std::string stem = write_texts(c.name, t.texts, folder.path()).string();
        for (const auto& [stage, text] : t.texts) {
            files.push_back(reference_file(stem, stage, text));
            case_of[files.back()] = c.name;
        }
        tried.push_back(c);
    }
    const auto said = complaints(files);
    EXPECT_EQ(said.size(), files.size());
    std::map<std::string, std::string> of_case;
    for (const auto& [file, text] : said)
        if (case_of.contains(file)) of_case[case_of[file]] += text;
    for (const Case& c : tried) count.add(c, of_case[c.name].empty(), of_case[c.name]);
    count.expect_all(where);
}

TEST(Reference, AcceptsEs32) {
    reference_accepts({.version = 320, .es = true, .fp64 = false}, impossible_es32, "glslang, ES 3.2");
}

TEST(Reference, AcceptsEs30) {
    reference_accepts({.version = 300, .es = true, .fp64 = false}, impossible_es30, "glslang, ES 3.0");
}

TEST(Reference, AcceptsCore45) {
    reference_accepts({.version = 450, .es = false, .fp64 = true}, {}, "glslang, core 4.5");
}

}  // namespace
}  // namespace snell::oracle
