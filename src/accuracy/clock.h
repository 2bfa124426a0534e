// Clocks in milliseconds, with an arbitrary origin.
#pragma once

#include <chrono>
#include <ctime>

namespace snell::accuracy {

// CPU time of this process, summed over all cores.
inline double cpu_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) / 1e6;
}

inline double wall_milliseconds() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace snell::accuracy
