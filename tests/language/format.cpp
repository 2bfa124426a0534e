#include "parser/read/parse.h"
#include "src/language/services.h"
#include "tests/scratch.h"
#include "tests/std.h"
#include "tests/torture/mutate.h"

namespace snell::language {
namespace {

namespace fs = std::filesystem;

// Every scene of the repository, also the broken ones.
std::vector<std::string> all_scenes() {
    std::vector<std::string> texts;
    for (const char* folder : {"scenes", "tests", "examples"})
        for (const auto& entry : fs::recursive_directory_iterator(SNELL_ROOT "/" + std::string(folder)))
            if (const auto type = entry.path().extension(); type == ".glib" || type == ".inc")
                texts.push_back(bytes_of(entry.path()));
    return texts;
}

std::string without_blanks(std::string text) {
    std::erase_if(text, [](char c) { return c == ' ' || c == '\t'; });
    return text;
}

// What the parser makes of a text: the scene, and what it says.
std::string meaning(const std::string& text) {
    Sources sources;
    const Parsed parsed = parse(sources.add("scene.glib", text), sources);
    std::string out = dump_scene(parsed.scene);
    for (const Diagnostic& d : parsed.diagnostics.items())
        out += std::to_string(sources.position(d.span.file, d.span.begin).line) + d.code + d.message + d.help + "\n";
    return out;
}

// "" or what formatting did that it must not.
std::string wrong_with(const std::string& text) {
    const std::string once = formatted(text);
    if (formatted(once) != once) return "a second time changes more";
    if (without_blanks(once) != without_blanks(text)) return "more than blanks changed";
    if (meaning(once) != meaning(text)) return "the scene is another one";
    return {};
}

TEST(Format, BlocksAreIndented) {
    EXPECT_EQ(
        formatted(
            "CubeMap 5 256\nRenderToCube 5\n Sphere\nPushMatrix\n\tTeapot\nPopMatrix\nRenderToTexture 7\n"
            "Cube\nRenderToTexture\nTransformBegin\nglBegin gl_lines\nglVertex 0 0 0\nglEnd\ntransformend\n  Box\n"),
        "CubeMap 5 256\nRenderToCube 5\n    Sphere\n    PushMatrix\n        Teapot\n    PopMatrix\nRenderToTexture "
        "7\n    Cube\nRenderToTexture\nTransformBegin\n    glBegin gl_lines\n        glVertex 0 0 0\n    glEnd\n"
        "transformend\nBox\n");
}

TEST(Format, BlocksWithoutAnEndIndentNothing) {
    EXPECT_EQ(formatted("PushMatrix\n Sphere\n"), "PushMatrix\nSphere\n");
    EXPECT_EQ(formatted("PopMatrix\n Sphere\nglEnd\nRenderToTexture\nBox\n"),
              "PopMatrix\nSphere\nglEnd\nRenderToTexture\nBox\n");
    EXPECT_EQ(formatted("RenderToTexture 5\n Sphere\n"), "RenderToTexture 5\nSphere\n");
    // One PushMatrix too many: the inner one has the end.
    EXPECT_EQ(formatted("PushMatrix\nPushMatrix\nSphere\nPopMatrix\n"),
              "PushMatrix\nPushMatrix\n    Sphere\nPopMatrix\n");
}

TEST(Format, APassIsABlockWhateverIsPushedInIt) {
    // Scenes push in one pass, and pop in another.
    EXPECT_EQ(formatted("RenderToTexture 5\nPushMatrix\nSphere\nRenderToTexture\nBox\nPopMatrix\nBox\n"),
              "RenderToTexture 5\n    PushMatrix\n    Sphere\nRenderToTexture\nBox\nPopMatrix\nBox\n");
    EXPECT_EQ(formatted("PushMatrix\nRenderToTexture 5\nPopMatrix\nRenderToTexture\nBox\nPopMatrix\n"),
              "PushMatrix\n    RenderToTexture 5\n        PopMatrix\n    RenderToTexture\n    Box\nPopMatrix\n");
    // A pass that was not begun here does not end blocks.
    EXPECT_EQ(formatted("PushMatrix\nRenderToTexture\nBox\nPopMatrix\n"),
              "PushMatrix\n    RenderToTexture\n    Box\nPopMatrix\n");
}

TEST(Format, CommentsAreIndentedLikeWhatTheyAreIn) {
    EXPECT_EQ(formatted("  # a\nPushMatrix\n# b\nBox # c\n// d\nPopMatrix\n    # e"),
              "# a\nPushMatrix\n    # b\n    Box # c\n    // d\nPopMatrix\n# e");
    // Those right above the statement of a pass are about the pass.
    EXPECT_EQ(
        formatted("RenderToTexture 5\nBox\n# in the first\n\n # the second\n # pass\nRenderToTexture 6\nBox\n# the "
                  "window\nRenderToTexture\n"),
        "RenderToTexture 5\n    Box\n    # in the first\n\n# the second\n# pass\nRenderToTexture 6\n    Box\n# the "
        "window\nRenderToTexture\n");
    EXPECT_EQ(
        formatted(
            "PushMatrix\r\nBox\r\n  # a\r\n# b\r\nRenderToTexture 5\r\nBox\r\n# c\r\nRenderToTexture\r\nPopMatrix\r\n"),
        "PushMatrix\r\n    Box\r\n    # a\r\n    # b\r\n    RenderToTexture 5\r\n        Box\r\n    # c\r\n    "
        "RenderToTexture\r\nPopMatrix\r\n");
}

TEST(Format, ContinuedLinesBeginBelowTheFirstArgument) {
    EXPECT_EQ(formatted("Program Glass uRoom 6 \\\n  uIndex <1. 1.5 2.> \\\n\tuMix 1 # mixed\n"),
              "Program Glass uRoom 6 \\\n        uIndex <1. 1.5 2.> \\\n        uMix 1 # mixed\n");
    EXPECT_EQ(formatted("PushMatrix\nProgram\tGlass \\\nuA 1\nPopMatrix\n"),
              "PushMatrix\n    Program\tGlass \\\n                uA 1\nPopMatrix\n");
    EXPECT_EQ(formatted("Program A \\\r\nuB 1"), "Program A \\\r\n        uB 1");
    // Below nothing: four more than the statement.
    EXPECT_EQ(formatted("Sphere \\\n1 \\\n# half\n20\n"), "Sphere \\\n    1 \\\n    # half\n    20\n");
    EXPECT_EQ(formatted("Program A uC {1 \\\n0 \\\n0} \\\nuD 2\n"),
              "Program A uC {1 \\\n              0 \\\n              0} \\\n        uD 2\n");
    // Far to the right there is no place.
    EXPECT_EQ(formatted("Sphere" + std::string(70, ' ') + "1 \\\n20\n"),
              "Sphere" + std::string(70, ' ') + "1 \\\n    20\n");
}

TEST(Format, BackslashesBelowEachOtherStaySo) {
    EXPECT_EQ(formatted("Program A      \\\n uA 1          \\\n uLonger 2     \\\n uB 3\n"),
              "Program A         \\\n        uA 1      \\\n        uLonger 2 \\\n        uB 3\n");
    EXPECT_EQ(formatted("Program A      \\\n uLonger 2     \\\n uA 1          \\\n uB 3\n"),
              "Program A         \\\n        uLonger 2 \\\n        uA 1      \\\n        uB 3\n");
    // Here they do not.
    EXPECT_EQ(formatted("Program A uA 1   \\\n uLong 2        \\\n uB 3\n"),
              "Program A uA 1   \\\n        uLong 2        \\\n        uB 3\n");
    // Here by chance.
    EXPECT_EQ(formatted("Program A uA 1 \\\n uLonger 23456 \\\n uB 3\n"),
              "Program A uA 1 \\\n        uLonger 23456 \\\n        uB 3\n");
    // One that is alone in its line.
    EXPECT_EQ(formatted("Program A \\\n          \\\n uA 1 \\\n uB 2\n"),
              "Program A \\\n          \\\n        uA 1 \\\n        uB 2\n");
}

TEST(Format, EverythingElseStays) {
    const std::string_view kept[] = {
        "",
        "\n\n  \n\t\n",
        "sphere   1,20 20   \nBOX  01. 2  3\t\t# c \n\n\n\nCone",
        "\xEF\xBB\xBF# mark\r\nSphere 1\r\n\r\nBox 1\rCone 2\n",
        "# \xE9t\xE9\nMessageBox \xE9t\xE9\n",
        "\xFF\xFES\0p\0",
        "Program A uA 1\n    uLost <0. 1. 2.>\n      uAlso <0. 1. 2.> \\\n  uToo 3\n",
        "  misspelt 1\n",
        "  \"text\"\n",
        "\xC2\xA0 Sphere 1\n",
        "\t\xEF\xBB\xBFSphere\n",
        "  \xFF\xFE# Sphere\n",
    };
    for (const std::string_view text : kept) EXPECT_EQ(formatted(text), text);
    EXPECT_EQ(formatted("\xEF\xBB\xBF  Sphere\r\n\tBox\r\r\n  Cone"), "\xEF\xBB\xBFSphere\r\nBox\r\r\nCone");
}

TEST(Format, ScenesStayTheSame) {
    std::size_t count = 0, changed = 0;
    for (const std::string& text : all_scenes()) {
        EXPECT_EQ(wrong_with(text), "") << text;
        ++count;
        changed += formatted(text) != text ? 1 : 0;
    }
    EXPECT_GT(count, 200u);
    EXPECT_GT(changed, 20u);
}

TEST(Format, TheShippedScenesAreFormatted) {
    for (const char* folder : {"scenes", "examples", "templates", "docs/teaching"})
        for (const auto& entry : fs::recursive_directory_iterator(SNELL_ROOT "/" + std::string(folder)))
            if (const auto type = entry.path().extension(); type == ".glib" || type == ".inc") {
                EXPECT_EQ(bytes_of(entry.path()), formatted(bytes_of(entry.path()))) << entry.path();
            }
}

TEST(Format, DamagedScenesStayTheSame) {
    // ./dev torture wants more.
    const char* wanted = std::getenv("SNELL_TORTURE_MUTANTS");
    const unsigned long count = wanted != nullptr ? std::strtoul(wanted, nullptr, 10) : 600;
    torture::Random random(7);
    torture::Dictionary dictionary;
    const std::vector<std::string> texts = all_scenes();
    for (const std::string& text : texts) torture::learn(dictionary, torture::Language::scene, text);
    for (const char* word :
         {"\n", "\\\n", "\r", "\t", " \\\n  ", "RenderToTexture 5\n", "PushMatrix\n", "PopMatrix\n", "<", "#"})
        dictionary.scene_words.emplace_back(word);
    for (unsigned long i = 0; i < count; ++i) {
        std::string text = torture::choose(random, texts);
        if (text.size() > 20'000) continue;
        for (std::size_t n = 1 + torture::below(random, 6); n > 0; --n)
            torture::damage(text, torture::Language::scene, dictionary, random);
        if (text.size() > 100'000) continue;
        ASSERT_EQ(wrong_with(text), "") << i << "\n" << text;
    }
}

TEST(Format, RangesChangeWholeStatementsAndNothingElse) {
    const std::string text = "  Sphere\n  Program A \\\n uA 1\n  Box\nPushMatrix\nCone\nPopMatrix\n";
    const std::vector<Edit> all = layout_edits(text);
    ASSERT_EQ(all.size(), 5u);
    const auto at = [&](const char* word) { return static_cast<std::uint32_t>(text.find(word)); };
    EXPECT_EQ(layout_edits(text, 0, at("uA"), at("uA")), (std::vector<Edit>{all[1], all[2]}));
    // Blocks are those of the whole text.
    EXPECT_EQ(layout_edits(text, 0, at("Cone"), at("Cone") + 4), std::vector<Edit>{all[4]});
    EXPECT_EQ(layout_edits(text, 0, at("PushMatrix"), at("PushMatrix")), std::vector<Edit>{});
}

TEST(Format, EditsAreInOrderAndInsideOfLines) {
    for (const std::string& text : all_scenes()) {
        std::uint32_t last = 0;
        for (const Edit& edit : layout_edits(text)) {
            EXPECT_LE(last, edit.span.begin);
            EXPECT_LE(edit.span.begin, edit.span.end);
            last = edit.span.end;
            EXPECT_EQ(std::string_view(text)
                          .substr(edit.span.begin, edit.span.end - edit.span.begin)
                          .find_first_not_of(" \t"),
                      std::string_view::npos);
            EXPECT_EQ(edit.text.find_first_not_of(' '), std::string::npos);
        }
    }
}

TEST(Format, DeepBlocksStaySmall) {
    std::string text, brackets = "Program A ";
    for (int i = 0; i < 20'000; ++i) text += "PushMatrix\n";
    for (int i = 0; i < 20'000; ++i) text += "PopMatrix\n";
    const std::string now = formatted(text);
    EXPECT_LE(now.size(), text.size() + std::size_t{40'000} * 64);
    EXPECT_EQ(formatted(now), now);
    for (int i = 0; i < 20'000; ++i) brackets += "< \\\n";
    EXPECT_LE(formatted(brackets).size(), brackets.size() + std::size_t{20'000} * 64);
}

}  // namespace
}  // namespace snell::language
