#include "src/server/wire/background.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

#include "src/content/pipes.h"

namespace snell::server {

bool Background::start(const std::function<std::string()>& work, Clock::duration most) {
    end();
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    child_ = fork();
    if (child_ == 0) {
        close(ends[0]);
        setpgid(0, 0);                                  // so that end() reaches what it starts itself
        [[maybe_unused]] const int priority = nice(5);  // answers come first
        std::string result;
        try {
            result = work();
        } catch (...) {
            _exit(1);
        }
        content::write_all(ends[1], result);
        _exit(0);
    }
    close(ends[1]);
    if (child_ < 0) {
        close(ends[0]);
        child_ = 0;
        return false;
    }
    setpgid(child_, child_);
    pipe_ = ends[0];
    fcntl(pipe_, F_SETFL, O_NONBLOCK);
    result_.clear();
    deadline_ = Clock::now() + most;
    return true;
}

void Background::end() {
    if (child_ <= 0) return;
    kill(-child_, SIGKILL);
    kill(child_, SIGKILL);
    while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
    }
    close(pipe_);
    child_ = 0;
    pipe_ = -1;
}

std::optional<std::string> Background::poll() {
    if (!busy()) return std::nullopt;
    if (Clock::now() > deadline_) {
        end();
        return "";
    }
    std::array<char, 1 << 16> some{};
    for (;;) {
        const ssize_t got = read(pipe_, some.data(), some.size());
        if (got > 0) {
            result_.append(some.data(), static_cast<std::size_t>(got));
        } else if (got < 0 && (errno == EINTR || errno == EAGAIN)) {
            if (errno == EAGAIN) return std::nullopt;
        } else {
            int status = 0;
            while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
            }
            close(pipe_);
            child_ = 0;
            pipe_ = -1;
            return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? std::move(result_) : "";
        }
    }
}

}  // namespace snell::server
