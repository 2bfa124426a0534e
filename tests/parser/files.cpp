// Scenes as they are found, each with what must be said about it.
#include "tests/oracle/scene/print.h"
#include "tests/parser/support.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> scenes(const std::string& folder) {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(std::string(SNELL_ROOT) + "/tests/" + folder))
        if (entry.path().extension() == ".glib") found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
}

std::string expectation(fs::path scene) { return bytes_of(scene.replace_extension(".txt")); }

Read read_file(const fs::path& path) {
    Read r;
    const FileId file = r.sources.add(path.filename().string(), bytes_of(path));
    r.parsed = parse(file, r.sources);
    return r;
}

// How many draws the scene has, then line:column-line:column severity code of each diagnostic. Many odd scenes have one
// draw and none: those have no file that says so.
std::string summary(const Read& r) {
    std::string out = "draws " + std::to_string(r.scene().draws.size()) + "\n";
    const auto place = [&](FileId file, std::uint32_t offset) {
        const Position at = r.sources.position(file, offset);
        return std::to_string(at.line) + ":" + std::to_string(at.column);
    };
    for (const Diagnostic& d : r.diagnostics())
        out += place(d.span.file, d.span.begin) + "-" + place(d.span.file, d.span.end) +
               (d.severity == Severity::error ? " error " : " warning ") + d.code + "\n";
    return out;
}

TEST(Files, OddScenesAreReadAsExpected) {
    const auto files = scenes("odd");
    EXPECT_GE(files.size(), 60u);
    for (const fs::path& path : files) {
        const std::string expected = expectation(path);
        EXPECT_EQ(summary(read_file(path)), expected.empty() ? "draws 1\n" : expected) << path;
    }
}

TEST(Files, BadScenesAreExplainedWordForWord) {
    const auto files = scenes("bad");
    EXPECT_GE(files.size(), 18u);
    for (const fs::path& path : files) {
        const Read r = read_file(path);
        EXPECT_EQ(render(r.parsed.diagnostics, r.sources), expectation(path)) << path;
    }
}

TEST(Files, PrintedScenesReadBackEqual) {
    for (const char* folder : {"odd", "bad", "cases"}) {
        for (const fs::path& path : scenes(folder)) {
            const Read first = read_file(path);
            const std::string printed = print_scene(first.scene());
            EXPECT_EQ(difference(first.scene(), read(printed).scene()), "") << path << "\n" << printed;
        }
    }
}

TEST(Files, EverySpanLiesInItsText) {
    for (const char* folder : {"odd", "bad"}) {
        for (const fs::path& path : scenes(folder)) {
            const Read r = read_file(path);
            for (const Diagnostic& d : r.diagnostics()) {
                EXPECT_LE(d.span.begin, d.span.end) << path << d.code;
                EXPECT_LE(d.span.end, r.sources.text(d.span.file).size()) << path << d.code;
            }
        }
    }
}

TEST(Files, NeverPrintsControlCharacters) {
    for (const fs::path& path : scenes("bad")) {
        const Read r = read_file(path);
        for (const char c : render(r.parsed.diagnostics, r.sources))
            EXPECT_FALSE(static_cast<unsigned char>(c) < 0x20 && c != '\n') << path;
    }
}

}  // namespace
}  // namespace snell::test
