// The corpora of the fuzzers of files, and what small changes make of them.
#include "tests/fuzz/file_input.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell {
namespace {

using Check = std::string (*)(std::string_view bytes, bool& made);

std::string changed(std::string bytes, int i, std::mt19937& random) {
    for (int k = 0; k <= i % 4; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
    if (i % 5 == 0) bytes.erase(random() % bytes.size(), 1 + random() % 8);
    return bytes;
}

// The reader gets to its end, and changes matter: nothing is refused at the door alone.
void replay(const std::string& folder, Check check) {
    std::size_t made = 0, broken = 0;
    std::mt19937 random(1);
    for (const auto& entry : std::filesystem::directory_iterator("tests/fuzz/" + folder)) {
        const std::string bytes = bytes_of(entry.path());
        ASSERT_FALSE(bytes.empty()) << entry.path();
        bool whole = false;
        ASSERT_EQ(check(bytes, whole), "") << entry.path();
        made += whole;
        for (int i = 0; i < 300; ++i) {
            bool still = false;
            ASSERT_EQ(check(changed(bytes, i, random), still), "") << entry.path() << " changed " << i;
            broken += whole && !still;
        }
    }
    EXPECT_GE(made, 2U);
    EXPECT_GE(broken, 10U);
}

TEST(FileCorpus, RawTexturesHold) { replay("texture_corpus", fuzz::check_texture); }
TEST(FileCorpus, ObjFilesHold) { replay("obj_corpus", fuzz::check_obj); }
TEST(FileCorpus, ShapeFilesHold) { replay("shape_corpus", fuzz::check_shape); }
TEST(FileCorpus, CubeLayoutsHold) { replay("cube_corpus", fuzz::check_cube); }

}  // namespace
}  // namespace snell
