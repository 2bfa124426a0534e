#include <fcntl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>

#include "src/content/replace.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace {

// How many bytes files can still grow by on a disk that cannot reserve room; nullopt: the real disk.
std::optional<off_t> room;

}  // namespace

// As the C library does it on such a disk: it reads what is there to write it again.
extern "C" int posix_fallocate(int file, off_t from, off_t size) {
    if (!room) return static_cast<int>(syscall(SYS_fallocate, file, 0, from, size)) == 0 ? 0 : errno;
    return (fcntl(file, F_GETFL) & O_ACCMODE) == O_RDWR ? EOPNOTSUPP : EBADF;
}

extern "C" ssize_t write(int file, const void* bytes, size_t count) {
    if (room) {
        struct stat status {};
        fstat(file, &status);
        const off_t inside = std::max<off_t>(0, status.st_size - lseek(file, 0, SEEK_CUR));
        if (count > 0 && inside + *room == 0) {
            errno = ENOSPC;
            return -1;
        }
        count = std::min(count, static_cast<size_t>(inside + *room));
        *room -= std::max<off_t>(0, static_cast<off_t>(count) - inside);
    }
    return syscall(SYS_write, file, bytes, count);
}

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

// As another user, because root may write everywhere.
TEST(Replace, ARefusalNamesTheFileOnce) {
    namespace fs = std::filesystem;
    const Scratch folder;
    fs::create_directory(folder.path("out"));
    folder.write("out/a.glib", "old");
    using fs::perms;
    fs::permissions(folder.path(), perms::all);
    fs::permissions(folder.path("out/a.glib"), perms::all);
    fs::permissions(folder.path("out"), perms::owner_write | perms::group_write | perms::others_write,
                    fs::perm_options::remove);
    const pid_t child = fork();
    if (child == 0) {
        if (geteuid() == 0 && setuid(65534) != 0) _exit(2);
        const std::string file = folder.path("out/a.glib"), refused = content::rewrite_file(file, "new");
        if (refused != file + ": Permission denied") _exit(1);
        fs::current_path(folder.path("out"));  // a folder without a name
        _exit(content::replace_file("b.json", "new") == "b.json: Permission denied" ? 0 : 3);
    }
    int status = 0;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
    fs::permissions(folder.path("out"), perms::owner_all);
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

std::string rewritten(const std::string& path, const std::string& text, off_t most) {
    room = most;
    std::string wrong = content::rewrite_file(path, text);
    room.reset();
    return wrong;
}

TEST(ReplaceOnAFullDisk, WhereNoRoomCanBeReservedAFileStillGrows) {
    const Scratch scratch;
    const std::string path = scratch.write("a.glib", "Sphere 1\n"), text(10'000, '#');
    std::filesystem::create_hard_link(path, scratch.path("b.glib"));
    EXPECT_EQ(rewritten(path, text, 100'000), "");
    EXPECT_EQ(bytes_of(path), text);
    EXPECT_EQ(std::filesystem::hard_link_count(path), 2u);
}

TEST(ReplaceOnAFullDisk, WhatWasWrittenHalfGetsItsOldBytes) {
    const Scratch scratch;
    const std::string path = scratch.write("a.glib", "Sphere 1\n"), text(10'000, '#');
    std::filesystem::create_hard_link(path, scratch.path("b.glib"));
    const std::string wrong = rewritten(path, text, 15'000);  // the temporary file, and half of the target
    EXPECT_NE(wrong.find("No space left"), wrong.npos) << wrong;
    EXPECT_EQ(bytes_of(path), "Sphere 1\n");
    EXPECT_EQ(scratch.entries(), 2u) << "nothing is left of the new text, so none is promised: " << wrong;
    EXPECT_EQ(wrong.find("the new text"), wrong.npos) << wrong;
}

}  // namespace
}  // namespace snell
