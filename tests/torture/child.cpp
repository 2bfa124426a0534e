#include "tests/torture/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>

#include "parser/text/words.h"
#include "tests/scratch.h"
#include "tests/torture/tree.h"

namespace snell::torture {
namespace {

using Clock = std::chrono::steady_clock;

// Between fork and exec only what is safe there.
[[noreturn]] void become(char** arguments, char** environment, const char* folder, int errors) {
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, STDIN_FILENO);
    dup2(nowhere, STDOUT_FILENO);
    dup2(errors, STDERR_FILENO);
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    if (chdir(folder) == 0) execve(arguments[0], arguments, environment);
    _exit(127);
}

std::vector<char*> pointers(std::vector<std::string>& words) {
    std::vector<char*> list;
    for (std::string& word : words) list.push_back(word.data());
    list.push_back(nullptr);
    return list;
}

std::vector<std::string> without_display() {
    std::vector<std::string> kept;
    for (char** at = environ; *at; ++at) {
        const std::string variable = *at;
        if (!variable.starts_with("DISPLAY=") && !variable.starts_with("WAYLAND_DISPLAY=")) kept.push_back(variable);
    }
    return kept;
}

double gigabytes_now(pid_t child) {
    std::ifstream file("/proc/" + std::to_string(child) + "/statm");
    double whole = 0, resident = 0, shared = 0;
    file >> whole >> resident >> shared;
    return (resident - shared) * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1 << 30);
}

// Until it ends, or is ended.
void watch(pid_t child, const Bounds& bounds, End& end) {
    const auto start = Clock::now();
    const int handle = static_cast<int>(syscall(SYS_pidfd_open, child, 0));
    while (true) {
        pollfd ended{handle, POLLIN, 0};
        const bool done = poll(&ended, 1, 20) > 0;
        end.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        if (done) break;
        end.gigabytes = std::max(end.gigabytes, gigabytes_now(child));
        end.too_long = end.too_long || end.seconds > bounds.seconds;
        end.too_large = end.too_large || end.gigabytes > bounds.gigabytes;
        if (end.too_long || end.too_large) kill(child, SIGKILL);
    }
    close(handle);
}

}  // namespace

End run_child(const std::vector<std::string>& words, const std::string& folder, const std::string& errors,
              const Bounds& bounds) {
    std::vector<std::string> own = words, variables = without_display();
    const std::vector<char*> arguments = pointers(own), environment = pointers(variables);
    const int file = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    End end;
    const pid_t child = fork();
    if (child == 0)
        become(const_cast<char**>(arguments.data()), const_cast<char**>(environment.data()), folder.c_str(), file);
    watch(child, bounds, end);
    int status = 0;
    rusage used{};
    wait4(child, &status, 0, &used);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    end.processor = seconds(used.ru_utime) + seconds(used.ru_stime);
    close(file);
    if (WIFEXITED(status)) end.status = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) end.signal = WTERMSIG(status);
    end.errors = bytes_of(errors);
    return end;
}

std::string unfit_for_terminals(const std::string& text) {
    for (std::size_t at = 0; at < text.size();) {
        const utf8::Char c = utf8::decode(text, at);
        if (c.code != '\n' && (!c.valid || utf8::hidden(c.code)))
            return (c.valid ? utf8::code_point(c.code) : "byte " + std::to_string(c.code)) + " at " +
                   std::to_string(at) + ": " + utf8::printable(text.substr(at > 60 ? at - 60 : 0, 120));
        at += c.length;
    }
    return {};
}

}  // namespace snell::torture
