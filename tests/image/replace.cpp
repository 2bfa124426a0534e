#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
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

TEST(Replace, AnEditedFileKeepsItsOtherNames) {
    const Scratch scratch;
    const std::string path = scratch.write("a.glib", "Sphere 1\n"), other = scratch.path("b.glib");
    std::filesystem::create_hard_link(path, other);
    std::filesystem::create_symlink("b.glib", scratch.path("link.glib"));
    const std::string long_text(100'000, '#');
    for (const std::string& text : {long_text, std::string("Box\n"), std::string()})
        for (const std::string& name : {path, other, scratch.path("link.glib")}) {
            EXPECT_EQ(content::rewrite_file(name, text + name), "");
            EXPECT_EQ(bytes_of(path), text + name);
            EXPECT_EQ(bytes_of(other), text + name);
        }
    EXPECT_EQ(std::filesystem::hard_link_count(path), 2u);
    EXPECT_EQ(scratch.entries(), 3u);
    // What is made anew, such as a picture, gets a file of its own.
    EXPECT_EQ(content::replace_file(path, "new"), "");
    EXPECT_NE(bytes_of(other), "new");
}

TEST(Replace, AnEditedFileIsUnchangedWhereItsTextHasNoRoom) {
    const Scratch scratch;
    const std::string path = scratch.write("a.glib", "Sphere 1\n");
    std::filesystem::create_hard_link(path, scratch.path("b.glib"));
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{50'000, before.rlim_max};
    const auto handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string error = content::rewrite_file(path, std::string(100'000, '#'));
    content::Replacement through(path);
    const std::string late = through.write_through(std::string(100'000, '#'));
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_NE(error.find("File too large"), error.npos) << error;
    EXPECT_NE(late.find("File too large"), late.npos) << late;
    EXPECT_EQ(bytes_of(path), "Sphere 1\n");
    EXPECT_EQ(scratch.entries(), 2u);
}

}  // namespace

}  // namespace snell
