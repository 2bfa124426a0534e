// `snell format`: files are replaced whole, or left alone.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/cli/run.h"

namespace snell::test {
namespace {

constexpr std::string_view crooked = "PushMatrix\r\n# c\r\n\tSphere 1\r\nPopMatrix",
                           straight = "PushMatrix\r\n    # c\r\n    Sphere 1\r\nPopMatrix";

Outcome format(const std::string& arguments) { return snell("format " + arguments); }

TEST(FormatCommand, FilesAreReplaced) {
    const Scratch folder;
    const std::string file = folder.write("a b.glib", crooked);
    chmod(file.c_str(), 0640);
    std::filesystem::create_symlink("a b.glib", folder.path("link.glib"));
    const Outcome outcome = format("'" + folder.path("link.glib") + "'");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "");
    EXPECT_EQ(bytes_of(file), straight);
    EXPECT_TRUE(std::filesystem::is_symlink(folder.path("link.glib")));
    EXPECT_EQ(std::filesystem::status(file).permissions(), std::filesystem::perms{0640});
    EXPECT_EQ(folder.entries(), 2u);
}

TEST(FormatCommand, AFileOfSeveralNamesKeepsThem) {
    const Scratch folder;
    const std::string file = folder.write("a.glib", crooked), other = folder.path("b.glib");
    std::filesystem::create_hard_link(file, other);
    EXPECT_EQ(format(file).status, 0);
    EXPECT_EQ(bytes_of(other), straight);
    EXPECT_EQ(std::filesystem::hard_link_count(file), 2u);
}

TEST(FormatCommand, WhatIsFormattedIsNotWritten) {
    const Scratch folder;
    const std::string file = folder.write("a.glib", straight);
    const auto before = std::filesystem::last_write_time(file);
    struct stat first {
    }, second{};
    stat(file.c_str(), &first);
    EXPECT_EQ(format(file).status, 0);
    stat(file.c_str(), &second);
    EXPECT_EQ(std::filesystem::last_write_time(file), before);
    EXPECT_EQ(first.st_ino, second.st_ino);
}

TEST(FormatCommand, CheckListsAndReplacesNothing) {
    const Scratch folder;
    const std::string a = folder.write("a.glib", crooked), b = folder.write("b.glib", straight);
    const Outcome outcome = format("--check " + a + " " + b);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.output, a + "\n");
    EXPECT_EQ(bytes_of(a), crooked);
    EXPECT_EQ(format("--check " + b).status, 0);
}

TEST(FormatCommand, StandardInputGoesToStandardOutput) {
    const Scratch folder;
    const std::string file = folder.write("a.glib", crooked);
    EXPECT_EQ(format("- <" + file).output, straight);
    EXPECT_EQ(format("--check - <" + file).status, 1);
    EXPECT_EQ(bytes_of(file), crooked);
    EXPECT_EQ(format("- </dev/null").output, "");
    EXPECT_EQ(format("- <" + folder.path()).status, 1);
}

TEST(FormatCommand, FilesThatCannotBeReadOrWrittenAreErrors) {
    const Scratch folder;
    const std::string file = folder.write("a.glib", crooked), shader = folder.write("a.frag", "  color = vec4(1.);\n"),
                      wide = folder.write("wide.glib", std::string_view("\xFF\xFES\0", 4));
    const Outcome outcome = format(folder.path("missing.glib") + " " + folder.path() + " " + file);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("error: " + folder.path("missing.glib") + ": No such file")) << outcome.output;
    EXPECT_TRUE(outcome.says("it is a folder")) << outcome.output;
    EXPECT_EQ(bytes_of(file), straight);  // the others are formatted all the same

    EXPECT_EQ(format(shader).status, 1);
    EXPECT_EQ(bytes_of(shader), "  color = vec4(1.);\n");
    EXPECT_TRUE(format(wide).says("UTF-16"));
    EXPECT_EQ(format("--check " + wide).status, 1);
    EXPECT_EQ(format("").status, 2);
}

}  // namespace
}  // namespace snell::test
