#include "src/app/recovery.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "src/app/loss.h"

namespace snell {

namespace {

constexpr std::string_view flag = "--after-hang";

std::vector<std::string> own_arguments() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::string> arguments;
    for (std::size_t at = 0; at < text.size(); at = text.find('\0', at) + 1) arguments.emplace_back(text.c_str() + at);
    return arguments;
}

// Returns where this system can't.
void start_again() {
    std::vector<std::string> arguments = own_arguments();
    if (arguments.empty()) return;
    if (std::ranges::find(arguments, flag) == arguments.end()) arguments.emplace_back(flag);
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    std::error_code error;
    execv(std::filesystem::read_symlink("/proc/self/exe", error).c_str(), pointers.data());
}

}  // namespace

Recovery after_loss(std::shared_ptr<const Kept> kept, std::vector<std::string> files) {
    const char* shown = kept ? "what is shown is as it was last drawn" : "nothing is drawn";
    return {std::move(kept), std::move(files),
            fmt::format("error: {}; {} [context-lost]\n   help: {}; F5 or another edit tries again\n",
                        app::loss_message, shown, app::loss_help)};
}

Recovery after_hang(const std::string& scene) {
    return {nullptr,
            {scene},
            "error: a frame did not end, and the window was started again; nothing is drawn [frame-too-long]\n"
            "   help: a loop in a shader may not end; F5 or another edit tries again, --timeout SECONDS "
            "waits longer\n"};
}

app::Deadline hang_watch(double seconds) {
    return app::Deadline(seconds, [seconds](const std::string& what) {
        fmt::print(stderr,
                   "snell: error: {} takes longer than {} seconds: the window is started again [frame-too-long]\n"
                   "   help: a loop in a shader may not end; --timeout SECONDS allows more\n",
                   what, seconds);
        start_again();
    });
}

}  // namespace snell
