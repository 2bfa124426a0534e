// Copies of this process and other programs: what comes back of them, and what ends them.
#include "src/content/process.h"

#include <gtest/gtest.h>

#include <signal.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "tests/sanitized.h"
#include "tests/scratch.h"

namespace snell::content {
namespace {

using Work = std::function<int(std::string&)>;

Ended ended(const Work& work, const ProcessLimits& limits = {}) {
    Process process;
    EXPECT_EQ(process.start(work, limits), "");
    return process.wait();
}

TEST(Process, ACopyGivesItsStatusAndItsResult) {
    int here = 1;
    const Ended copy = ended([&](std::string& result) {
        here = 2;
        result = std::string(1 << 20, 'x') + "end";  // more than a pipe holds
        return 7;
    });
    EXPECT_EQ(here, 1);
    EXPECT_EQ(copy.status, 7);
    EXPECT_EQ(copy.output.size(), (1U << 20) + 3);
    EXPECT_EQ(ended([](std::string&) -> int { throw std::runtime_error("no"); }).status, 1);
}

TEST(Process, WhatIsCapturedIsKeptAtItsEnd) {
    const auto print = [](std::string&) {
        for (int i = 0; i < 100000; ++i) std::fprintf(i % 2 ? stderr : stdout, "%d\n", i);
        std::fflush(nullptr);
        std::fputs("last", stdout);
        return 0;
    };
    const Ended all = ended(print, {.captured = true}), last = ended(print, {.most_output = 10, .captured = true});
    EXPECT_GT(all.output.size(), 500000U);
    EXPECT_EQ(last.output, all.output.substr(all.output.size() - 10));
    EXPECT_TRUE(last.output.ends_with("last")) << last.output;
}

TEST(Process, ASignalAndALackOfTimeAreTold) {
    const Ended killed = ended([](std::string&) { return raise(SIGKILL); });
    EXPECT_EQ(killed.status, -1);
    EXPECT_EQ(killed.signal, SIGKILL);
    EXPECT_FALSE(killed.too_long);
    for (const bool background : {false, true}) {
        const Ended late = ended([](std::string&) { return pause(); }, {.seconds = .05, .background = background});
        EXPECT_TRUE(late.too_long);
        EXPECT_EQ(late.status, -1);
    }
}

TEST(Process, MemoryIsWhatIsAskedForBeyondThatOfThisProcess) {
    if (sanitized) GTEST_SKIP() << "sanitizers reserve address space of their own";
    const auto ask = [](std::string&) {
        void* volatile memory = std::malloc(std::size_t{64} << 20);
        return memory ? 5 : 6;
    };
    EXPECT_EQ(ended(ask, {.bytes = std::size_t{256} << 20}).status, 5);
    EXPECT_EQ(ended(ask, {.bytes = std::size_t{16} << 20}).status, 6);
}

TEST(Process, AProgramIsFoundAsAShellFindsItAndItsWordsAreWords) {
    Process process;
    EXPECT_NE(process.start({"no-such-program-anywhere"}, {}), "");
    EXPECT_FALSE(process.running());
    ASSERT_EQ(process.start({"printf", "%s", "a b;$(c)"}, {.captured = true}), "");
    const Ended printed = process.wait();
    EXPECT_EQ(printed.output, "a b;$(c)");
    EXPECT_EQ(printed.status, 0);
    EXPECT_FALSE(process.poll()) << "once";
}

TEST(Process, EndsWithTheObjectUnlessItStays) {
    for (const bool stays : {false, true}) {
        const Scratch folder;
        const std::string file = folder.path("pid");
        pid_t program = 0;
        {
            Process begun;
            ASSERT_EQ(begun.start({"sh", "-c", "echo $$ >'" + file + "'; exec sleep 1000"}, {.stays = stays}), "");
            Process moved = std::move(begun);
            EXPECT_FALSE(begun.running());
            for (int i = 0; i < 5000 && program == 0; ++i) {
                std::ifstream(file) >> program;
                usleep(1000);
            }
            ASSERT_GT(program, 1);
            EXPECT_EQ(kill(program, 0), 0);
        }
        EXPECT_EQ(kill(program, 0) == 0, stays);
        if (stays) kill(program, SIGKILL);
    }
}

}  // namespace
}  // namespace snell::content
