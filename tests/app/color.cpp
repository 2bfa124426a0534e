// Colours of messages: lines that belong to messages get some, and no line changes otherwise.
#include "src/app/open/complain.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace snell::test {
namespace {

std::string without_escapes(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\x1b')
            i = text.find('m', i);
        else
            out += text[i];
    return out;
}

TEST(Color, AMessageIsPaintedByItsParts) {
    Painter painter;
    EXPECT_EQ(painter.painted("a b.glib:1:12: error: no [code]"),
              "\x1b[1ma b.glib:1:12: \x1b[0m\x1b[1;31merror:\x1b[0m\x1b[1m no [code]\x1b[0m");
    EXPECT_EQ(painter.painted("    1 | error: | ^ text"), "    1 | error: | ^ text") << "the scene's own line";
    EXPECT_EQ(painter.painted("      |    ^~~"), "      |    \x1b[1;31m^~~\x1b[0m");
    EXPECT_EQ(painter.painted("   help: do"), "\x1b[36m   help:\x1b[0m do");
    EXPECT_EQ(painter.painted("   help: do"), "\x1b[36m   help:\x1b[0m do") << "after a headline without a source";
    EXPECT_NE(painter.painted("snell: warning: slow").find("\x1b[1;35mwarning:"), std::string::npos);
    EXPECT_NE(painter.painted("note: without a place").find("\x1b[1;36mnote:"), std::string::npos);
}

TEST(Color, OtherLinesStayAsTheyAre) {
    Painter painter;
    for (const char* line : {"", "the error: no", "  \"message\": \"error: no\",", "a.glib:1: error: no column",
                             "\"a:1:2: error: json\"", "      | ^", "   help: without a message", "error in a table"})
        EXPECT_EQ(painter.painted(line), line);
}

TEST(Color, NothingButEscapesIsAdded) {
    Painter painter;
    for (const std::string line : {"x:1:1: error: a:2:2: warning: b", "    1 | ^~", "      | ^~", "   also on line 3",
                                   "   help: ^", "x:1:1: note: ", "snell: error: ", "    9 | \t|", "plain"})
        EXPECT_EQ(without_escapes(painter.painted(line)), line);
}

TEST(Color, TheOptionDecidesThenTheEnvironmentThenTheTerminal) {
    const auto clean = [] {
        unsetenv("NO_COLOR");
        unsetenv("CLICOLOR_FORCE");
        setenv("TERM", "xterm", 1);
    };
    clean();
    EXPECT_TRUE(wants_color("auto", true));
    EXPECT_FALSE(wants_color("auto", false));
    EXPECT_TRUE(wants_color("always", false));
    EXPECT_FALSE(wants_color("never", true));
    setenv("TERM", "dumb", 1);
    EXPECT_FALSE(wants_color("auto", true));
    setenv("CLICOLOR_FORCE", "1", 1);
    EXPECT_TRUE(wants_color("auto", false));
    EXPECT_FALSE(wants_color("never", false));
    setenv("NO_COLOR", "1", 1);
    EXPECT_FALSE(wants_color("auto", true)) << "NO_COLOR is the stronger one";
    EXPECT_TRUE(wants_color("always", false));
    setenv("NO_COLOR", "", 1);
    setenv("CLICOLOR_FORCE", "0", 1);
    EXPECT_FALSE(wants_color("auto", false)) << "empty and 0 mean that they are not set";
    clean();
}

}  // namespace
}  // namespace snell::test
