#include "src/content/process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <utility>

extern char** environ;

namespace snell::content {

namespace {

// Counts what a driver asks for, too. Pages that were asked for are counted, not only those that are used, because a
// process that uses more than there is ends others as well.
void limit_memory(std::uint64_t bytes) {
    if (bytes == 0) return;
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + bytes;
    const rlimit memory{most, most};
    setrlimit(RLIMIT_AS, &memory);
}

[[noreturn]] void be_copy(int output, const std::function<int(std::string& result)>& work,
                          const ProcessLimits& limits) {
    if (limits.background) {
        setpgid(0, 0);
        [[maybe_unused]] const int priority = nice(5);
    }
    if (limits.captured) {
        prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody would hear it
        dup2(output, STDOUT_FILENO);
        dup2(output, STDERR_FILENO);
    }
    limit_memory(limits.bytes);
    std::string result;
    int status = 1;
    // An exception must not reach the objects of the process that this is a copy of: their ends are not its own.
    try {
        status = work(result);
    } catch (...) {
    }
    std::fflush(nullptr);
    write_all(output, result);
    _exit(status);
}

// A handler or a mask of this process is not meant for another program.
void set_signals(posix_spawnattr_t& how, bool stays) {
    sigset_t none, pipes;
    sigemptyset(&none);
    sigemptyset(&pipes);
    sigaddset(&pipes, SIGPIPE);
    posix_spawnattr_setsigmask(&how, &none);
    posix_spawnattr_setsigdefault(&how, &pipes);
    posix_spawnattr_setflags(
        &how, static_cast<short>(POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | (stays ? POSIX_SPAWN_SETSID : 0)));
}

}  // namespace

std::string write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t count = write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return std::strerror(count < 0 ? errno : ENOSPC);
        bytes.remove_prefix(static_cast<std::size_t>(count));
    }
    return {};
}

void Process::swap(Process& other) noexcept {
    std::swap(child_, other.child_);
    std::swap(pipe_, other.pipe_);
    std::swap(copy_, other.copy_);
    std::swap(closed_, other.closed_);
    std::swap(limits_, other.limits_);
    std::swap(deadline_, other.deadline_);
    std::swap(ended_, other.ended_);
}

std::string Process::start(const std::function<int(std::string& result)>& work, const ProcessLimits& limits) {
    end();
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::strerror(errno);
    std::fflush(nullptr);  // otherwise both processes would write what is buffered
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        be_copy(ends[1], work, limits);
    }
    const int error = errno;
    close(ends[1]);
    if (child > 0 && limits.background) setpgid(child, child);
    copy_ = true;
    limits_ = limits;
    return began(child, ends[0], child < 0 ? error : 0);
}

std::string Process::start(const std::vector<std::string>& words, const ProcessLimits& limits) {
    end();
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return std::strerror(errno);
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawnattr_t how;
    posix_spawn_file_actions_init(&files);
    posix_spawnattr_init(&how);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    for (const int to : {STDOUT_FILENO, STDERR_FILENO})
        if (limits.captured) posix_spawn_file_actions_adddup2(&files, ends[1], to);
    set_signals(how, limits.stays);
    pid_t child = 0;
    const int error = posix_spawnp(&child, arguments[0], &files, &how, arguments.data(), environ);
    posix_spawnattr_destroy(&how);
    posix_spawn_file_actions_destroy(&files);
    close(ends[1]);
    copy_ = false;
    limits_ = limits;
    return began(child, ends[0], error);
}

std::string Process::began(pid_t child, int pipe, int error) {
    if (error != 0) {
        close(pipe);
        return std::strerror(error);
    }
    child_ = child;
    pipe_ = pipe;
    closed_ = false;
    ended_ = {};
    fcntl(pipe_, F_SETFL, O_NONBLOCK);
    const std::chrono::duration<double> most(std::min(limits_.seconds, 1e7));
    deadline_ = limits_.seconds > 0 ? Clock::now() + std::chrono::duration_cast<Clock::duration>(most)
                                    : Clock::time_point::max();
    return {};
}

void Process::stop() const {
    if (limits_.background) kill(-child_, SIGKILL);
    kill(child_, SIGKILL);
}

void Process::end() {
    if (child_ <= 0) return;
    if (!limits_.stays) {
        stop();
        while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    close(pipe_);
    child_ = 0;
    pipe_ = -1;
}

void Process::take() {
    std::array<char, 1 << 16> some{};
    std::string& output = ended_.output;
    while (!closed_) {
        const ssize_t got = read(pipe_, some.data(), some.size());
        if (got < 0 && errno == EINTR) continue;
        if (got < 0 && errno == EAGAIN) break;
        closed_ = got <= 0;
        if (got > 0) output.append(some.data(), static_cast<std::size_t>(got));
        if (output.size() / 2 > limits_.most_output) output.erase(0, output.size() - limits_.most_output);
    }
}

std::optional<Ended> Process::poll() {
    if (!running()) return std::nullopt;
    take();
    int status = 0;
    // The output of a copy ends with the copy.
    const pid_t ended = waitpid(child_, &status, copy_ && closed_ ? 0 : WNOHANG);
    if (ended == 0 && !ended_.too_long && Clock::now() > deadline_) {
        ended_.too_long = true;
        stop();
    }
    if (ended == 0 || (ended < 0 && errno == EINTR)) return std::nullopt;
    take();
    close(pipe_);
    child_ = 0;
    pipe_ = -1;
    if (ended > 0 && WIFEXITED(status)) ended_.status = WEXITSTATUS(status);
    if (ended > 0 && WIFSIGNALED(status)) ended_.signal = WTERMSIG(status);
    if (ended_.output.size() > limits_.most_output) ended_.output.erase(0, ended_.output.size() - limits_.most_output);
    return std::move(ended_);
}

Ended Process::wait() {
    while (running()) {
        if (auto ended = poll()) return std::move(*ended);
        pollfd output{pipe_, POLLIN, 0};
        ::poll(&output, 1, 100);
    }
    return {};
}

}  // namespace snell::content
