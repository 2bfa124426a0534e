#include "src/app/grade/processes.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <fstream>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "parser/text/words.h"
#include "src/app/open/complain.h"

namespace snell::app {

namespace {

using Clock = std::chrono::steady_clock;

struct Running {
    pid_t process = 0;
    std::size_t index = 0;
    Clock::time_point end;
    int output = -1;  // a file in memory
    bool again = false, killed = false;
};

std::string tail_of(int file) {
    constexpr off_t most = 4096;
    const off_t size = lseek(file, 0, SEEK_END), from = std::max<off_t>(0, size - most);
    std::string text(static_cast<std::size_t>(std::max<off_t>(0, size - from)), '\0');
    const ssize_t got = pread(file, text.data(), text.size(), from);
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, got)));
    return text;
}

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

// What a process of its own needs: it ends with its parent, its messages are kept, it writes no endless file, and draws
// on one core, because there is a process for each.
void settle_in(int output, const ProcessLimits& limits) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    const rlimit file{rlim_t{512} << 20, rlim_t{512} << 20}, core{0, 0};
    setrlimit(RLIMIT_FSIZE, &file);
    setrlimit(RLIMIT_CORE, &core);
    limit_memory(limits.bytes);
    setenv("LP_NUM_THREADS", "0", 0);
}

Running start(std::size_t index, bool again, const ProcessLimits& limits, const std::function<int(std::size_t)>& work) {
    Running running{0, index,
                    Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                       std::chrono::duration<double>(std::min(limits.seconds, 1e7))),
                    memfd_create("output", MFD_CLOEXEC), again};
    std::fflush(nullptr);  // otherwise both processes would write what is buffered
    running.process = fork();
    if (running.process != 0) return running;
    settle_in(running.output, limits);
    const int status = work(index);
    std::fflush(nullptr);
    _exit(status);
}

}  // namespace

void run_apart(std::size_t count, const ProcessLimits& limits, const std::function<int(std::size_t)>& work,
               const std::function<void(std::size_t, const EndedProcess&)>& done) {
    std::deque<std::pair<std::size_t, bool>> waiting;
    for (std::size_t i = 0; i < count; ++i) waiting.emplace_back(i, false);
    std::vector<Running> running;
    const auto finish = [&](Running& ended, int status) {
        EndedProcess told{WIFEXITED(status) ? WEXITSTATUS(status) : -1, WIFSIGNALED(status) ? WTERMSIG(status) : 0,
                          ended.killed, ended.again, tail_of(ended.output)};
        close(ended.output);
        const bool by_itself = told.signal != 0 && !told.too_long;
        if (by_itself && !told.again)
            waiting.emplace_back(ended.index, true);
        else
            done(ended.index, told);
    };
    while (!waiting.empty() || !running.empty()) {
        if (limits.stop && limits.stop()) {
            for (const Running& one : running) {
                kill(one.process, SIGKILL);
                waitpid(one.process, nullptr, 0);
                close(one.output);
            }
            return;
        }
        while (!waiting.empty() && running.size() < std::max<std::size_t>(limits.at_once, 1)) {
            const auto [index, again] = waiting.front();
            waiting.pop_front();
            running.push_back(start(index, again, limits, work));
            if (running.back().process > 0) continue;
            close(running.back().output);
            running.pop_back();
            done(index, {});  // no process could be made
        }
        for (std::size_t i = 0; i < running.size();) {
            int status = 0;
            if (waitpid(running[i].process, &status, WNOHANG) == running[i].process) {
                Running ended = running[i];
                running.erase(running.begin() + static_cast<std::ptrdiff_t>(i));
                finish(ended, status);
                continue;
            }
            if (!running[i].killed && Clock::now() > running[i].end) {
                running[i].killed = true;
                kill(running[i].process, SIGKILL);
            }
            ++i;
        }
        if (!running.empty()) usleep(2000);
    }
}

namespace {

// The first line of what it printed about itself.
std::string said(const EndedProcess& ended) {
    const std::size_t at = ended.output.find("snell: error: ");
    if (at == std::string::npos) return {};
    const std::string_view line = std::string_view(ended.output).substr(at + 14);
    return fmt::format(": {}", utf8::printable(line.substr(0, line.find('\n'))));
}

// What a submission prints may contain the mark, too: only a process that ends for want of memory has this status.
bool out_of_memory(const EndedProcess& ended) {
    return ended.status == exit_input && ended.output.find("[out-of-memory]") != std::string::npos;
}

}  // namespace

std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes) {
    if (ended.too_long || ended.status == exit_timeout)
        return fmt::format("it takes longer than {} seconds{}", timeout, said(ended));
    if (out_of_memory(ended))
        return gigabytes > 0 ? fmt::format("it takes more than {} GB of memory", gigabytes)
                             : "it takes more memory than there is";
    if (ended.signal != 0) {
        // Drivers abort where they get no memory.
        const std::string limit =
            ended.signal == SIGABRT && gigabytes > 0
                ? fmt::format("; the cause may be the limit of {} GB of memory, which --memory changes", gigabytes)
                : "";
        return fmt::format("it ends the program that draws it, twice, by signal {} ({}){}", ended.signal,
                           strsignal(ended.signal), limit);
    }
    return ended.status == exit_fine ? "" : fmt::format("it ends the program that draws it{}", said(ended));
}

}  // namespace snell::app
