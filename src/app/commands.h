// What the command line can do. Each returns the exit status.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace snell::app {

enum Exit { exit_fine = 0, exit_input = 1, exit_usage = 2, exit_graphics = 3 };

struct RenderOptions {
    std::string scene, output, stats;
    std::optional<std::pair<int, int>> size;
    double time = 0;
    std::vector<std::string> sets, ladders;
    int samples = 1;
    bool axes = false;
    std::string context;  // "", "3.3", "4.1", "4.5", "es3.2" …
    bool quiet = false;
};
int render(const RenderOptions& options);

struct CheckOptions {
    std::vector<std::string> scenes;
    bool json = false;
    std::string dump;  // "", tokens, statements, scene, plan
    bool lint = true;  // also what is probably not meant
};
int check(const CheckOptions& options);

int print_commands(bool json);
int print_info(const std::string& context);

}  // namespace snell::app
