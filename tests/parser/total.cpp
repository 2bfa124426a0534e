// Any bytes are read without harm, and what was understood can be written down and read again.
#include "parser/commands/commands.h"
#include "tests/fuzz/oracle.h"
#include "tests/parser/support.h"
#include "tests/scratch.h"
#include "tests/std.h"
#include "tests/words.h"

namespace snell::test {
namespace {

namespace fs = std::filesystem;

void expect_well(const std::string& text) {
    const std::string wrong = fuzz::check(text);
    EXPECT_EQ(wrong, "") << "for the text:\n" << text;
}

TEST(Total, RandomBytes) {
    std::mt19937 random(1);
    for (int i = 0; i < 3000; ++i) {
        std::string text(random() % 300, ' ');
        for (char& c : text) c = static_cast<char>(random());
        expect_well(text);
    }
}

// Pieces of the language in any order go further into the parser than bytes do.
TEST(Total, RandomPieces) {
    std::vector<std::string> pieces = words(
        "\n|\n|\n| | |\\\n|\\|#|//|<|>|[|]|{|}|(|)|,|;|\"|=|?|true|uA|uB|uA <0. .5 1.>|1|-.5|1e39|0.1.|nan|"
        "1e-320|3e38|\r|\r\n|\xC2\xA0|\xE9|\xE2\x80\x9C|\xE2\x88\x92|a.vert|a\\b.obj|gl_patches|gl_points|"
        "on|off|Program Foo|RenderToTexture 6|Texture2D 6 64 64|Sphere\n|Rotate 30 1 2 3\n|Scale 1 2 3\n|"
        "Scale -1 1 1\n|Scale 0\n|glBegin gl_lines\n|glVertex 1 2 3\n|glColor 1 0 0\n|Translate 1 2 3\n",
        '|');
    for (const std::string_view name : command_names()) pieces.emplace_back(name);
    std::mt19937 random(2);
    for (int i = 0; i < 8'000; ++i) {
        std::string text;
        for (std::size_t n = random() % 40; n > 0; --n) {
            text += pieces[random() % pieces.size()];
            if (random() % 2 == 0) text += ' ';
        }
        expect_well(text);
    }
}

TEST(Total, EveryPrefixAndEveryLostByteOfAScene) {
    const std::string scene =
        "##OpenGL GLIB\nPerspective 70\nLookAt 0 0 5 0 0 0 0 1 0\nVertex a.vert\nFragment \"b c.frag\"\n"
        "Program Foo uA <0. .5 1.> \\\n  uB {1. 0. 0.} \\\n# c\n  uC [1 2 3] uD <true>\nTexture2D 6 64 64\n"
        "RenderToTexture 6\nRotate 30 1 2 3\nTranslate 1 2 3\nScale 1 2 3\nSphere 1. 20 20\nRenderToTexture\n"
        "glBegin gl_patches\nglColor 1 0 0\nglVertex 0 0 0\nglEnd\nTriangles [0 0 0] [1 0 0] [0 1 0]\n";
    for (std::size_t i = 0; i <= scene.size(); ++i) expect_well(scene.substr(0, i));
    for (std::size_t i = 0; i < scene.size(); ++i) {
        std::string lost = scene;
        lost.erase(i, 1);
        expect_well(lost);
    }
}

TEST(Total, TheCorpusOfTheFuzzer) {
    std::size_t count = 0;
    for (const char* folder : {"fuzz/parser_corpus", "odd", "bad"}) {
        for (const auto& entry : fs::directory_iterator(std::string(SNELL_ROOT) + "/tests/" + folder)) {
            expect_well(bytes_of(entry.path().string()));
            ++count;
        }
    }
    EXPECT_GE(count, 80u);
}

TEST(Total, HugeStatementsAndDeepNesting) {
    expect_well("Program Foo " + std::string(100'000, '<'));
    expect_well("Program Foo uA " + std::string(100'000, '['));
    expect_well(std::string(100'000, '\\'));
    std::string backslashes;
    for (int i = 0; i < 30'000; ++i) backslashes += "\\ ";
    expect_well(backslashes);
    std::string values = "Program Foo uA [";
    for (int i = 0; i < 50'000; ++i) values += "1 ";
    expect_well(values + "]");
    std::string words = "Program Foo";
    for (int i = 0; i < 20'000; ++i) words += " uA";
    expect_well(words);
}

}  // namespace
}  // namespace snell::test
