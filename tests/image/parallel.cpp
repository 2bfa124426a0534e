// Work on all cores, and on a machine that gives no more threads.
#include "src/content/workers.h"
#include "tests/no_more_threads.h"
#include "tests/std.h"

namespace snell::content {
namespace {

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
    const auto nothing = [] {};
    work_beside(3, nothing, [](std::size_t started) { EXPECT_EQ(started, 3U); });
    const NoMoreThreads here;
    work_beside(3, nothing, [](std::size_t started) { EXPECT_EQ(started, 0U); });
    EXPECT_EQ(visits(1000), std::vector<int>(1000, 1));
}

}  // namespace
}  // namespace snell::content
