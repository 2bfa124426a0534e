// The corpus of the fuzzer of files, and what small changes make of it.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include "tests/fuzz/content_input.h"

namespace snell {
namespace {

TEST(FileCorpus, HoldsAndSoDoItsMutations) {
    std::array<std::size_t, 4> made{}, broken{};
    std::mt19937 random(1);
    for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/content_corpus")) {
        std::ifstream file(entry.path(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(file), {}};
        ASSERT_FALSE(bytes.empty()) << entry.path();
        const fuzz::Kind kind = fuzz::kind_of(bytes);
        bool whole = false;
        ASSERT_EQ(fuzz::check_content(bytes, whole), "") << entry.path();
        made[kind] += whole;
        for (int i = 0; i < 300; ++i) {
            std::string changed = bytes;
            for (int k = 0; k <= i % 4; ++k)
                changed[random() % (changed.size() - 1)] = static_cast<char>(random() % 256);
            if (i % 5 == 0) changed.erase(random() % (changed.size() - 1), 1 + random() % 8);
            bool still = false;
            ASSERT_EQ(fuzz::check_content(changed, still), "") << entry.path() << " changed " << i;
            broken[kind] += whole && !still;
        }
    }
    // The readers get to their ends, and changes matter: nothing is refused at the door alone.
    for (const fuzz::Kind kind : {fuzz::texture, fuzz::layout, fuzz::shape_file, fuzz::obj}) {
        EXPECT_GE(made[kind], 2U) << kind;
        EXPECT_GE(broken[kind], 10U) << kind;
    }
}

}  // namespace
}  // namespace snell
