// What an editor is told of a window that ended.
#include <gtest/gtest.h>

#include "src/app/lsp/errands.h"
#include "src/app/open/exit_status.h"

namespace snell::app {
namespace {

constexpr std::string_view printed = "a.frag:1:1: error: x\nsnell: error: no window: no display\n   help: none\n";

TEST(FailureOfWindow, IsTheLastErrorOfTheProgram) {
    for (const int status : {exit_usage, exit_graphics, exit_lost})
        EXPECT_EQ(failure_of_window(status, 600, printed), "no window: no display");
    EXPECT_EQ(failure_of_window(exit_input, 1, "snell: error: cannot read 'a.glib'\n"), "cannot read 'a.glib'");
}

TEST(FailureOfWindow, IsNoErrorThatTheWindowShowed) {
    EXPECT_EQ(failure_of_window(exit_input, 600, "snell: error: a frame takes longer than 60 seconds\n"), "");
    EXPECT_EQ(failure_of_window(exit_fine, 1, printed), "");
    EXPECT_EQ(failure_of_window(exit_lost, 600, "a.frag:1:1: error: x\n"), "");
}

}  // namespace
}  // namespace snell::app
