// What is said of processes that ended: of submissions, and of the windows of an editor.
#include <gtest/gtest.h>

#include <signal.h>

#include "src/app/grade/why_ended.h"
#include "src/app/lsp/errands.h"
#include "src/app/open/exit_status.h"

namespace snell::app {
namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

TEST(WhyEnded, AMarkThatASubmissionPrintsIsNotItsEnd) {
    EXPECT_EQ(why_ended({.status = exit_fine, .output = "a.frag: error: [out-of-memory]\n"}, 10, 4), "");
    const std::string lost =
        why_ended({.status = exit_lost, .output = "[out-of-memory]\nsnell: error: the context was lost\n"}, 10, 4);
    EXPECT_EQ(lost, "it ends the program that draws it: the context was lost");
}

TEST(WhyEnded, MemoryIsComparedWithTheLimitIfThereIsOne) {
    const EndedProcess ended{.status = exit_input, .output = "snell: error: out of memory [out-of-memory]\n"};
    EXPECT_EQ(why_ended(ended, 10, 4), "it takes more than 4 GB of memory");
    EXPECT_EQ(why_ended(ended, 10, 0), "it takes more memory than there is");
}

TEST(WhyEnded, ADriverAbortsWhereItGetsNoMemory) {
    EXPECT_TRUE(has(why_ended({.signal = SIGABRT}, 10, 4), "limit of 4 GB"));
    EXPECT_FALSE(has(why_ended({.signal = SIGABRT}, 10, 0), "limit"));
    EXPECT_FALSE(has(why_ended({.signal = SIGSEGV}, 10, 4), "limit"));
}

TEST(WhyEnded, TimeComesFirst) {
    EXPECT_EQ(why_ended({.signal = SIGKILL, .too_long = true, .output = ""}, 10, 4), "it takes longer than 10 seconds");
}

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
