// Programs of every dialect, whose names are all others, are translated to the same text, but for the names.
#include "src/glsl/read/lexer.h"
#include "tests/language/rename_all.h"
#include "tests/scratch.h"
#include "tests/torture/tree.h"

namespace snell::language {
namespace {

// The translated stages of all programs, with the names of before.
std::string translated(const std::string& scene, const std::map<std::string, std::string>& names) {
    const Project project = read_project(scene, {}, Depth::translated);
    std::string text;
    for (const glsl::Translation& translation : project.translations)
        for (const glsl::StageOutput& stage : translation.stages) text += stage.text + "\n----\n";
    std::string old;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t end = at;
        while (end < text.size() && glsl::identifier_part(text[end])) ++end;
        // A function that a variable hides is called snell_NAME.
        constexpr std::string_view ours = "snell_";
        if (text.substr(at, end - at).starts_with(std::string(ours) + "xNew")) {
            old += ours;
            at += ours.size();
        }
        const auto known = names.find(text.substr(at, end - at));
        end = std::max(end, at + 1);
        old += known == names.end() ? text.substr(at, end - at) : known->second;
        at = end;
    }
    return old;
}

TEST(RenameDialects, TheSameProgram) {
    const Scratch scratch;
    torture::copy_tree(".", scratch.path());
    int programs = 0, renamed = 0;
    for (const char* folder : {"tests/glsl", "tests/cases"})
        for (const auto& entry : std::filesystem::directory_iterator(scratch.path(folder))) {
            if (entry.path().extension() != ".glib") continue;
            SCOPED_TRACE(entry.path().filename());
            const std::string scene = entry.path().string();
            const std::string before = translated(scene, {});
            const auto names = rename_all(scene, "xNew" + std::to_string(programs++) + "x");
            renamed += static_cast<int>(names.size());
            // A variable that is named like a member of another structure gets a zero that it does not need.
            if (entry.path().stem() == "structure-in-structure") continue;
            EXPECT_EQ(translated(scene, names), before);
        }
    EXPECT_GT(programs, 100);
    EXPECT_GT(renamed, 500);
}

}  // namespace
}  // namespace snell::language
