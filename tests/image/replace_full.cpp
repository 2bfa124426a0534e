// Files that are written in place, on a disk that cannot reserve room and fills up.
#include <gtest/gtest.h>

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <optional>

#include "src/content/replace.h"
#include "tests/scratch.h"

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
