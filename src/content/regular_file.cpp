#include "src/content/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <string_view>
#include <system_error>

namespace snell::content {

namespace {

class Descriptor {
public:
    Descriptor(const std::string& path, int flags) : fd_(open(path.c_str(), flags | O_CLOEXEC)) {}
    ~Descriptor() {
        if (fd_ >= 0) close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }

private:
    int fd_;
};

std::string_view kind_of(const struct stat& status) {
    if (S_ISDIR(status.st_mode)) return "it is a folder";
    if (S_ISFIFO(status.st_mode)) return "it is a pipe, not a file";
    if (S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) return "it is a device, not a file";
    if (S_ISSOCK(status.st_mode)) return "it is a socket, not a file";
    return "it is not a regular file";
}

std::string reason(int error) { return std::generic_category().message(error); }

bool acceptable(const struct stat& status, std::uint64_t limit, std::string& error) {
    if (!S_ISREG(status.st_mode)) {
        error = kind_of(status);
        return false;
    }
    if (status.st_size > 0 && static_cast<std::uint64_t>(status.st_size) > limit) {
        error = larger_than(limit);
        return false;
    }
    return true;
}

std::string link_target(const std::string& link) {
    std::array<char, 4096> target{};
    const ssize_t size = readlink(link.c_str(), target.data(), target.size());
    return size < 0 ? "" : std::string(target.data(), static_cast<std::size_t>(size));
}

bool read_all(int fd, std::size_t expected, std::uint64_t limit, std::string& bytes, std::string& error) {
    // One byte more than expected, so that the end of the file is detected without growing the buffer.
    bytes.resize(expected + 1);
    std::size_t size = 0;
    for (;;) {
        if (size == bytes.size()) bytes.resize(bytes.size() * 2);
        const ssize_t got = ::read(fd, bytes.data() + size, bytes.size() - size);
        if (got == 0) break;
        if (got < 0) {
            if (errno == EINTR) continue;
            error = reason(errno);
            return false;
        }
        size += static_cast<std::size_t>(got);
        if (size > limit) {
            error = larger_than(limit);
            return false;
        }
    }
    bytes.resize(size);
    return true;
}

}  // namespace

// The file is first opened with O_PATH, which has no effect on a device or a pipe. The descriptor is checked and then
// opened itself, so that replacing the file under that name in the meantime has no effect.
std::optional<std::string> read_regular_file(const std::string& path, std::uint64_t limit,
                                             const std::function<bool(const std::string& real_path)>& allowed,
                                             std::string& error) {
    struct stat status {};
    const Descriptor held(path, O_PATH);
    if (held.get() < 0 || fstat(held.get(), &status) != 0) {
        error = reason(errno);
        return std::nullopt;
    }
    const std::string itself = "/proc/self/fd/" + std::to_string(held.get());
    if (allowed && !allowed(link_target(itself))) return std::nullopt;
    if (!acceptable(status, limit, error)) return std::nullopt;
    const Descriptor file(itself, O_RDONLY | O_NONBLOCK | O_NOCTTY);
    if (file.get() < 0) {
        error = reason(errno);
        return std::nullopt;
    }
    std::string bytes;
    if (!read_all(file.get(), static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)), limit, bytes, error))
        return std::nullopt;
    return bytes;
}

}  // namespace snell::content
