// The program on a terminal.
#pragma once

#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <string>
#include <utility>

namespace snell::test {

// What the program writes to a terminal, and how long it took.
inline std::pair<std::string, double> on_terminal(const std::string& arguments, const char* kind = "xterm") {
    int terminal = -1;
    winsize size{24, 80, 0, 0};
    const auto start = std::chrono::steady_clock::now();
    const pid_t child = forkpty(&terminal, nullptr, nullptr, &size);
    if (child == 0) {
        setenv("TERM", kind, 1);
        unsetenv("DISPLAY");
        execl("/bin/sh", "sh", "-c", (SNELL_BIN "/snell " + arguments).c_str(), nullptr);
        _exit(127);
    }
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t n; (n = read(terminal, buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(n));
    close(terminal);
    int status = 0;
    waitpid(child, &status, 0);
    return {text, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()};
}

}  // namespace snell::test
