// tests/odd: what students really wrote. The parser's tests hold what is said of it; here it is drawn.
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

class Odd : public GlTest {};

// Errors after which a draw that was read can't be drawn.
bool lost_a_draw(const Document& document) {
    for (const Diagnostic& diagnostic : document.diagnostics.items())
        if (diagnostic.severity == Severity::error &&
            (diagnostic.code.starts_with("file-") || diagnostic.code.starts_with("patches-") ||
             diagnostic.code.starts_with("obj-") || diagnostic.code.starts_with("shp-")))
            return true;
    return false;
}

TEST_F(Odd, IsDrawnAllTheSame) {
    int drawn = 0;
    for (const auto& entry : std::filesystem::directory_iterator(SNELL_ROOT "/tests/odd")) {
        if (entry.path().extension() != ".glib") continue;
        SCOPED_TRACE(entry.path().filename());
        std::filesystem::path expectation = entry.path();
        std::ifstream file(expectation.replace_extension(".txt"));
        std::string word = "draws";
        unsigned expected = 1;  // as the parser's tests
        file >> word >> expected;
        ASSERT_EQ(word, "draws");
        auto document = open_file(entry.path());
        ASSERT_TRUE(document->runtime);
        draw(*document);
        if (expected == 0 || lost_a_draw(*document)) continue;
        const Counters& counters = document->runtime->counters();
        EXPECT_GE(counters.draws + counters.draws_culled, 1U);  // passes that nothing reads are not drawn
        ++drawn;
    }
    EXPECT_GE(drawn, 60);
}

}  // namespace
}  // namespace snell::test
