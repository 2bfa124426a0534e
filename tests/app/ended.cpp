// What is said of processes of submissions that ended.
#include <gtest/gtest.h>

#include <signal.h>

#include "src/app/grade/grade.h"
#include "src/app/open/complain.h"

namespace snell::app {
namespace {

bool has(const std::string& text, std::string_view part) { return text.find(part) != text.npos; }

TEST(WhyEnded, AMarkThatASubmissionPrintsIsNotItsEnd) {
    EXPECT_EQ(why_ended({{.status = exit_fine, .output = "a.frag: error: [out-of-memory]\n"}}, 10, 4), "");
    const std::string lost =
        why_ended({{.status = exit_lost, .output = "[out-of-memory]\nsnell: error: the context was lost\n"}}, 10, 4);
    EXPECT_EQ(lost, "it ends the program that draws it: the context was lost");
}

TEST(WhyEnded, MemoryIsComparedWithTheLimitIfThereIsOne) {
    const EndedProcess ended{{.status = exit_input, .output = "snell: error: out of memory [out-of-memory]\n"}};
    EXPECT_EQ(why_ended(ended, 10, 4), "it takes more than 4 GB of memory");
    EXPECT_EQ(why_ended(ended, 10, 0), "it takes more memory than there is");
}

TEST(WhyEnded, ADriverAbortsWhereItGetsNoMemory) {
    EXPECT_TRUE(has(why_ended({{.signal = SIGABRT}}, 10, 4), "limit of 4 GB"));
    EXPECT_FALSE(has(why_ended({{.signal = SIGABRT}}, 10, 0), "limit"));
    EXPECT_FALSE(has(why_ended({{.signal = SIGSEGV}}, 10, 4), "limit"));
}

TEST(WhyEnded, TimeComesFirst) {
    EXPECT_EQ(why_ended({{.signal = SIGKILL, .too_long = true, .output = ""}}, 10, 4),
              "it takes longer than 10 seconds");
}

}  // namespace
}  // namespace snell::app
