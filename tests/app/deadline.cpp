// The clock that watches what may not return.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "tests/sanitized.h"

namespace snell::app {
namespace {

using namespace std::chrono_literals;

bool becomes(const std::atomic<int>& value, int wanted) {
    for (int i = 0; i < 500 && value != wanted; ++i) std::this_thread::sleep_for(10ms);
    return value == wanted;
}

TEST(Deadline, CallsOnceForEachBeginning) {
    std::atomic<int> calls = 0;
    std::string what;
    Deadline deadline(.05, [&](const std::string& late) { what = late, ++calls; });
    std::this_thread::sleep_for(100ms);
    EXPECT_EQ(calls, 0) << "nothing began";
    deadline.begin("the first");
    ASSERT_TRUE(becomes(calls, 1));
    EXPECT_EQ(what, "the first");
    std::this_thread::sleep_for(150ms);
    EXPECT_EQ(calls, 1);
    deadline.begin("the second");
    ASSERT_TRUE(becomes(calls, 2));
    EXPECT_EQ(what, "the second");
}

TEST(Deadline, RestsAndBeginsAgain) {
    std::atomic<int> calls = 0;
    Deadline deadline(.5, [&](const std::string&) { ++calls; });
    for (int i = 0; i < 20; ++i) {
        deadline.begin("quick");
        deadline.rest();
    }
    std::this_thread::sleep_for(700ms);
    EXPECT_EQ(calls, 0);
    // The thread, which woke at an earlier end, knows of the new one.
    deadline.begin("slow");
    EXPECT_TRUE(becomes(calls, 1));
}

// As the strips of one picture do.
TEST(Deadline, WhatGoesOnHasAQuarterAtLeast) {
    std::atomic<int> calls = 0;
    Deadline deadline(8, [&](const std::string&) { ++calls; });
    deadline.begin("the first part");
    std::this_thread::sleep_for(50ms);  // the thread waits for its end
    deadline.rest();
    deadline.begin("the next", 30);
    std::this_thread::sleep_for(1s);
    EXPECT_EQ(calls, 0) << "a quarter is left";
    EXPECT_TRUE(becomes(calls, 1));
}

TEST(Deadline, NoneIsNoThread) {
    std::atomic<int> calls = 0;
    Deadline deadline(0, [&](const std::string&) { ++calls; });
    deadline.begin("anything");
    std::this_thread::sleep_for(50ms);
    EXPECT_EQ(calls, 0);
}

// What waits for a thread that got no stack has no memory: time is not the cause.
TEST(Deadline, WithoutAddressSpaceItIsTheMemory) {
    if (sanitized) GTEST_SKIP() << "sanitizers reserve address space of their own";
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    const auto wait = [](bool without) {
        Deadline deadline(.3);
        if (without) {
            const rlimit least{1 << 20, 1 << 20};  // less than the process has
            setrlimit(RLIMIT_AS, &least);
        }
        deadline.begin("a frame");
        while (true) std::this_thread::sleep_for(1s);
    };
    EXPECT_EXIT(wait(true), testing::ExitedWithCode(exit_input), "out of memory");
    EXPECT_EXIT(wait(false), testing::ExitedWithCode(exit_timeout), "a frame takes longer than 0.3 seconds");
}

}  // namespace
}  // namespace snell::app
