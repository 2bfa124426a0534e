#include "src/content/pipes.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace snell::content {

std::string write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return std::strerror(count < 0 ? errno : ENOSPC);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
}

std::string read_all(int descriptor) {
    std::string bytes;
    std::array<char, 1 << 16> some{};
    for (;;) {
        const ssize_t got = read(descriptor, some.data(), some.size());
        if (got == 0 || (got < 0 && errno != EINTR)) return bytes;
        if (got > 0) bytes.append(some.data(), static_cast<std::size_t>(got));
    }
}

}  // namespace snell::content
