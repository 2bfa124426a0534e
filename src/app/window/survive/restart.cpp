#include "src/app/window/survive/restart.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string_view>
#include <utility>

#include "parser/text/words.h"
#include "src/content/files.h"

namespace snell {

namespace {

constexpr std::string_view after_flag = "--after=", of_hang = "hang:", of_memory = "memory:";

// The handler of operator new has no parameter, so it finds the object here.
std::atomic<const Restart*> of_this_process = nullptr;

std::vector<std::string> own_arguments() {
    const std::string text = content::whole_file("/proc/self/cmdline");
    std::vector<std::string> arguments;
    for (std::size_t at = 0; at < text.size(); at = text.find('\0', at) + 1) arguments.emplace_back(text.c_str() + at);
    std::erase_if(arguments, [](const std::string& argument) { return argument.starts_with(after_flag); });
    return arguments;
}

int new_memory() { return memfd_create("snell", MFD_CLOEXEC); }

// True if the file was saved after that moment, by the clock of files. A time in the future does not count as an edit.
bool saved_since(const std::string& path, const timespec& moment) {
    const auto later = [](const timespec& a, const timespec& b) {
        return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
    };
    struct stat now {};
    timespec present{};
    clock_gettime(CLOCK_REALTIME, &present);
    return stat(path.c_str(), &now) == 0 && later(now.st_mtim, moment) && !later(now.st_mtim, present);
}

// Returns the memory file whose number the previous window passed, or a new one.
int memory_of(std::string_view after) {
    const std::size_t colon = after.find(':');
    int file = -1;
    if (colon != after.npos) std::sscanf(std::string(after.substr(colon + 1)).c_str(), "%9d", &file);
    return file > STDERR_FILENO && fcntl(file, F_SETFD, FD_CLOEXEC) == 0 ? file : new_memory();
}

}  // namespace

Restart::Restart(std::string after)
    : after_(std::move(after)), arguments_(own_arguments()), memory_(memory_of(after_)) {
    std::error_code error;
    program_ = std::filesystem::read_symlink("/proc/self/exe", error).string();
    for (const std::string_view cause : {of_hang, of_memory})
        arguments_.push_back(fmt::format("{}{}{}", after_flag, cause, memory_));
    for (std::size_t i = 0; i < arguments_.size(); ++i) {
        if (i + 1 != arguments_.size()) after_hang_.push_back(arguments_[i].data());
        if (i + 2 != arguments_.size()) after_memory_.push_back(arguments_[i].data());
    }
    after_hang_.push_back(nullptr);
    after_memory_.push_back(nullptr);
    of_this_process = this;
    before_ = std::set_new_handler(out_of_memory);
}

Restart::~Restart() {
    std::set_new_handler(before_);
    of_this_process = nullptr;
    if (memory_ >= 0) close(memory_);
}

std::optional<Carried> Restart::carried() const {
    if (after_.empty()) return std::nullopt;
    Carried carried = read_carried(content::whole_file(fmt::format("/proc/self/fd/{}", memory_)));
    struct stat memory {};
    fstat(memory_, &memory);
    for (const std::string& file : carried.recovery.files)
        carried.recovery.edited = carried.recovery.edited || saved_since(file, memory.st_mtim);
    const char* comes_back =
        carried.recovery.values.empty() ? "" : ", with the values that were set manually, as last drawn";
    Diagnostic& problem = carried.recovery.problem;
    problem.has_span = false;
    if (after_.starts_with(of_memory)) {
        problem.code = "out-of-memory";
        problem.message = "memory ran out, and the window was started again; nothing is drawn";
        problem.help = fmt::format("F5 or another edit tries again{}; --limit asks for less", comes_back);
    } else {
        problem.code = "frame-too-long";
        const std::string name = utf8::printable(std::filesystem::path(carried.scene).filename().string());
        problem.message = fmt::format("a frame{} did not end, and the window was started again; nothing is drawn",
                                      name.empty() ? "" : " of " + name);
        problem.help = fmt::format(
            "a loop in a shader may not end; F5 or another edit tries again{}; --timeout SECONDS waits longer",
            comes_back);
    }
    return carried;
}

// The modification time of the memory file is that of the last try.
void Restart::trying() {
    worth_it_ = true;
    futimens(memory_, nullptr);
}

// The new text replaces the old one at once, so that a restart never finds half of it.
void Restart::keep(const Carried& carried, bool worth_it) {
    const std::string text = carried_text(carried);
    const int fresh = new_memory();
    if (fresh < 0 || memory_ < 0) return;
    if (write(fresh, text.data(), text.size()) == static_cast<ssize_t>(text.size())) dup3(fresh, memory_, O_CLOEXEC);
    close(fresh);
    if (worth_it) worth_it_ = true;
}

app::Deadline Restart::hang_watch(double seconds) const {
    return app::Deadline(seconds, [this, seconds](const std::string& what) {
        fmt::print(stderr,
                   "snell: error: {} takes longer than {} seconds: the window is started again [frame-too-long]\n"
                   "   help: a loop in a shader may not end; --timeout SECONDS allows more\n",
                   what, seconds);
        start(Cause::hang);
    });
}

void Restart::start(Cause cause) const {
    fcntl(memory_, F_SETFD, 0);
    execv(program_.c_str(), (cause == Cause::hang ? after_hang_ : after_memory_).data());
    fcntl(memory_, F_SETFD, FD_CLOEXEC);
}

void Restart::out_of_memory() {
    const Restart* restart = of_this_process;
    if (restart && restart->worth_it_) {
        constexpr std::string_view text = "snell: error: out of memory: the window is started again [out-of-memory]\n";
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        restart->start(Cause::memory);
    }
    if (restart && restart->before_) restart->before_();
    throw std::bad_alloc();
}

}  // namespace snell
