// The program itself, as a shell calls it.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <string_view>

#include "tests/scratch.h"

namespace snell::test {

struct Outcome {
    int status = -1;
    std::string output;  // both streams
    bool says(std::string_view text) const { return output.find(text) != std::string::npos; }
};

// Seconds that processors spent on the processes that were run and have ended: unlike the wall's time, it does not
// depend on what else the machine does.
inline double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_CHILDREN, &usage);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

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

// The least of three runs, in processor time, whatever the driver's cache holds.
inline double cost_of(const std::string& arguments) {
    double best = 1e9;
    for (int i = 0; i < 3; ++i) {
        const double before = processor_seconds();
        snell(arguments, "MESA_SHADER_CACHE_DISABLE=true");
        best = std::min(best, processor_seconds() - before);
    }
    return best;
}

}  // namespace snell::test
