// Clocks, and processes as a whole.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace snell::bench {

// Milliseconds. cpu: of all threads of the process, the driver's included.
struct Times {
    double cpu = 0, wall = 0;
};

Times measure(const std::function<void()>& work);

// From the start of the process to its end; its output is thrown away. `arguments[0]` is the file. Throws when it
// can't be started or fails.
Times measure_process(const std::vector<std::string>& arguments);

}  // namespace snell::bench
