// The corpus of the fuzzer of files, and what small changes make of it.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/content_input.h"

namespace snell {
namespace {

TEST(FileCorpus, HoldsAndSoDoItsMutations) {
    std::size_t count = 0;
    std::mt19937 random(1);
    for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/content_corpus")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        ASSERT_EQ(fuzz::check_content(bytes), "") << entry.path();
        for (int i = 0; i < 300; ++i) {
            std::string changed = bytes;
            for (int k = 0; k <= i % 4; ++k)
                changed[random() % (changed.size() - 1)] = static_cast<char>(random() % 256);
            if (i % 5 == 0) changed.erase(random() % (changed.size() - 1), 1 + random() % 8);
            ASSERT_EQ(fuzz::check_content(changed), "") << entry.path() << " changed " << i;
        }
        ++count;
    }
    EXPECT_GE(count, 9U);
}

}  // namespace
}  // namespace snell
