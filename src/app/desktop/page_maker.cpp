#include "src/app/desktop/page_maker.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "parser/text/words.h"
#include "src/plan/locate.h"

extern char** environ;

namespace snell {

namespace {

constexpr std::size_t most_output = 1 << 20;  // bytes; the rest is read and forgotten

// The first line of the output with this text; "" if there is none.
std::string line_with(const std::string& output, std::string_view text) {
    const std::size_t found = output.find(text);
    if (found == output.npos) return {};
    const std::size_t at = found == 0 ? 0 : output.rfind('\n', found) + 1;  // npos + 1 is 0
    return utf8::printable(output.substr(at, output.find('\n', at) - at));
}

}  // namespace

std::string page_file(const std::string& name) {
    return has_extension(name, "html") || has_extension(name, "htm") ? name : name + ".html";
}

PageMaker::~PageMaker() {
    if (process_ > 0) {
        kill(process_, SIGKILL);
        waitpid(process_, nullptr, 0);
    }
    if (output_ >= 0) close(output_);
}

std::string PageMaker::start(const std::string& page, const std::vector<std::string>& arguments) {
    page_ = page_file(page);
    std::error_code none;
    if (page_ != page && std::filesystem::exists(page_, none))
        return fmt::format("{} exists: give its whole name to replace it",
                           utf8::printable(std::filesystem::path(page_).filename().string()));
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::strerror(errno);
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
    std::string program = "/proc/self/exe", command = "web", option = "-o";
    std::vector<char*> words{program.data(), command.data(), option.data(), page_.data()};
    for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, ends[1], STDERR_FILENO);
    const int error = posix_spawn(&process_, program.c_str(), &files, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    if (error != 0) {
        close(ends[0]);
        process_ = 0;
        return std::strerror(error);
    }
    output_ = ends[0];
    said_.clear();
    return {};
}

void PageMaker::read() {
    std::array<char, 4096> bytes{};
    for (ssize_t got; (got = ::read(output_, bytes.data(), bytes.size())) > 0;)
        if (said_.size() < most_output) said_.append(bytes.data(), static_cast<std::size_t>(got));
}

std::string PageMaker::look() {
    if (!busy()) return {};
    read();
    int status = 0;
    if (waitpid(process_, &status, WNOHANG) == 0) return {};
    read();
    close(output_);
    output_ = -1;
    process_ = 0;
    const std::string name = utf8::printable(std::filesystem::path(page_).filename().string());
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
        return fmt::format("{} is not saved: {}", name, line_with(said_, "error: "));
    const std::string line = line_with(said_, " redistributes ");
    const std::size_t told = line.find(name);
    return "saved " +
           (told == line.npos ? name : line.substr(told, line.size() - told - (line.ends_with(':') ? 1 : 0)));
}

}  // namespace snell
