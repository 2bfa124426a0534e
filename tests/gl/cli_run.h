// The program itself, as a shell calls it.
#pragma once

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>

namespace snell::test {

struct Outcome {
    int status = -1;
    std::string output;  // both streams
};

inline Outcome run(const std::string& command) {
    Outcome outcome;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::array<char, 4096> buffer{};
    for (size_t n; (n = fread(buffer.data(), 1, buffer.size(), pipe)) > 0;) outcome.output.append(buffer.data(), n);
    outcome.status = WEXITSTATUS(pclose(pipe));
    return outcome;
}

inline Outcome snell(const std::string& arguments, const std::string& environment = "") {
    return run("env -u DISPLAY -u WAYLAND_DISPLAY " + environment + " " SNELL_BIN "/snell " + arguments);
}

inline std::string bytes_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace snell::test
