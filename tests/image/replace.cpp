#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "src/content/replace.h"
#include "tests/scratch.h"

namespace snell {

namespace {

TEST(Replace, TheNewTextOrTheOld) {
    const Scratch scratch;
    const std::string path = scratch.path("values.json");
    EXPECT_EQ(content::replace_file(path, "one"), "");
    EXPECT_EQ(content::replace_file(path, "two"), "");
    EXPECT_EQ(bytes_of(path), "two");
    EXPECT_NE(content::replace_file(scratch.path("nowhere/values.json"), "three"), "");
    EXPECT_EQ(scratch.entries(), 1u);
}

TEST(Replace, PipesAreWrittenToAndStayPipes) {
    const Scratch scratch;
    const std::string path = scratch.path("pipe");
    ASSERT_EQ(mkfifo(path.c_str(), 0600), 0);
    const int reader = open(path.c_str(), O_RDONLY | O_NONBLOCK);
    ASSERT_GE(reader, 0);
    EXPECT_EQ(content::replace_file(path, "to whom it concerns"), "");
    char bytes[64] = {};
    EXPECT_EQ(read(reader, bytes, sizeof bytes), 19);
    EXPECT_STREQ(bytes, "to whom it concerns");
    close(reader);
    EXPECT_TRUE(std::filesystem::is_fifo(path));
    EXPECT_EQ(content::replace_file("/dev/null", "nothing"), "");
}

}  // namespace

}  // namespace snell
