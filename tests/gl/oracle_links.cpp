// The small programs are accepted, once translated, by every kind of context and by the reference compiler.
#include <gtest/gtest.h>

#include <epoxy/gl.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>

#include "src/platform/headless.h"
#include "tests/gl/oracle_draw.h"

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
    if (!context) GTEST_SKIP() << "no " << where << " here: " << error;
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

const Impossible impossible_es = {};

TEST(Links, OnCore45) { link_all({.version = 45}, {.version = 450, .es = false, .fp64 = true}, {}, "core 4.5"); }

TEST(Links, OnCore33) {
    link_all({.version = 33}, {.version = 330, .es = false, .fp64 = false}, impossible_33, "core 3.3");
}

TEST(Links, OnEs32) {
    link_all({.version = 32, .es = true}, {.version = 320, .es = true, .fp64 = false}, impossible_es, "ES 3.2");
}

// Only counted: the untouched shaders, as a core profile would take them.
TEST(Links, UntouchedRateIsKnown) {
    std::string error;
    const auto context = HeadlessContext::make({.version = 45}, error);
    if (!context) GTEST_SKIP() << error;
    int linked = 0;
    const std::vector<Case> cases = cases_of_folder("tests/glsl");
    for (const Case& c : cases) linked += build(texts(c.files)).id != 0 ? 1 : 0;
    std::printf("untouched on core 4.5: %d of %zu programs link\n", linked, cases.size());
    EXPECT_LT(linked, static_cast<int>(cases.size()) / 2) << "these programs would hardly need a translation";
}

// What the reference compiler says about the translation of one program; empty: nothing.
std::string complaints(const Case& c, const Translated& t) {
    const std::string stem = write_texts("reference-" + c.name, t.texts).string();
    std::string command = "glslangValidator";
    constexpr std::array<std::string_view, 5> extensions = {".vert", ".tcs", ".tes", ".geom", ".frag"};
    constexpr std::array<std::string_view, 5> names = {"vert", "tesc", "tese", "geom", "frag"};
    std::string result;
    for (const auto& [stage, text] : t.texts) {
        const auto i = static_cast<std::size_t>(stage);
        const std::string line =
            command + " -S " + std::string(names[i]) + " " + stem + std::string(extensions[i]) + " 2>&1";
        std::FILE* pipe = popen(line.c_str(), "r");
        if (!pipe) return "popen failed";
        std::string output;
        for (char buffer[512]; std::fgets(buffer, sizeof buffer, pipe);) output += buffer;
        if (pclose(pipe) != 0) result += output;
    }
    return result;
}

void reference_accepts(const glsl::Target& target, const Impossible& impossible, const char* where) {
    if (std::system("glslangValidator --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "no glslangValidator";
    Count count;
    for (const Case& c : cases_of_folder("tests/glsl")) {
        if (impossible.contains(c.name) || (tessellates(c) && target.version == 300)) continue;
        if (target.version == 300 && c.files.contains(Stage::geometry)) continue;
        const Translated t = translated(c, target);
        const std::string complaint = t.ok ? complaints(c, t) : t.messages;
        count.add(c, complaint.empty(), complaint);
    }
    count.expect_all(where);
}

TEST(Reference, AcceptsEs32) {
    reference_accepts({.version = 320, .es = true, .fp64 = false}, impossible_es, "glslang, ES 3.2");
}

TEST(Reference, AcceptsEs30) {
    reference_accepts({.version = 300, .es = true, .fp64 = false}, impossible_es, "glslang, ES 3.0");
}

TEST(Reference, AcceptsCore45) {
    reference_accepts({.version = 450, .es = false, .fp64 = true}, {}, "glslang, core 4.5");
}

}  // namespace
}  // namespace snell::oracle
