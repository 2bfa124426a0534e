// Work in a copy of this process: it has all texts as they are, can't delay an answer, and may crash or be ended.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

namespace snell::server {

class Background {
public:
    using Clock = std::chrono::steady_clock;

    Background() = default;
    ~Background() { end(); }
    Background(const Background&) = delete;
    Background& operator=(const Background&) = delete;

    // Ends what runs. Returns false if the system has no process left.
    bool start(const std::function<std::string()>& work, Clock::duration most);
    void end();
    bool busy() const { return child_ > 0; }
    // To wait on; -1 if nothing runs.
    int descriptor() const { return pipe_; }
    Clock::time_point deadline() const { return deadline_; }
    // Takes what has arrived. Returns the result when it is complete, "" if there is none, nullopt before.
    std::optional<std::string> poll();

private:
    pid_t child_ = 0;
    int pipe_ = -1;
    std::string result_;
    Clock::time_point deadline_;
};

}  // namespace snell::server
