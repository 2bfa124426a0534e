// Work on all cores, and on a machine that gives no more threads.
#include <gtest/gtest.h>
#include <pthread.h>

#include <algorithm>
#include <vector>

#include "src/content/parallel.h"

namespace snell::content {
namespace {

// While it lives no thread can be started: none has room for its stack.
class NoMoreThreads {
public:
    NoMoreThreads() {
        pthread_attr_t wide;
        pthread_attr_init(&wide);
        pthread_getattr_default_np(&before_);
        pthread_attr_setstacksize(&wide, std::size_t{1} << 47);
        pthread_setattr_default_np(&wide);
        pthread_attr_destroy(&wide);
    }
    ~NoMoreThreads() {
        pthread_setattr_default_np(&before_);
        pthread_attr_destroy(&before_);
    }
    NoMoreThreads(const NoMoreThreads&) = delete;
    NoMoreThreads& operator=(const NoMoreThreads&) = delete;

private:
    pthread_attr_t before_{};
};

std::vector<int> visits(std::size_t count) {
    std::vector<int> result(count);
    parallel_blocks(count, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) ++result[i];
    });
    return result;
}

TEST(Parallel, EverythingIsDoneOnce) {
    for (const std::size_t count : {0, 1, 2, 3, 17, 1000}) EXPECT_EQ(visits(count), std::vector<int>(count, 1));
}

TEST(Parallel, AndSoItIsWithoutThreads) {
    EXPECT_EQ(start_threads(3, [] {}).size(), 3U);
    const NoMoreThreads here;
    EXPECT_TRUE(start_threads(3, [] {}).empty());
    EXPECT_EQ(visits(1000), std::vector<int>(1000, 1));
}

}  // namespace
}  // namespace snell::content
