// Processes next to this one: copies of it, and other programs; and bytes through pipes.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace snell::content {

// Returns "" or the error, such as that of a pipe whose reader is gone.
std::string write_all(int descriptor, std::string_view bytes);

struct Ended {
    int status = -1;        // the exit status; -1: it was ended by a signal, or could not be made
    int signal = 0;         // that ended it
    bool too_long = false;  // it was ended because its time was up
    std::string output;     // the result of a copy, or what was captured
};

struct ProcessLimits {
    double seconds = 0;       // it is ended then; 0: it takes as long as it takes
    std::uint64_t bytes = 0;  // that a copy may ask for beyond the memory of this process
    std::size_t most_output = static_cast<std::size_t>(-1);  // the last bytes that are kept of the output
    bool captured = false;    // what it prints is its output, too, instead of going where this process prints
    bool background = false;  // a copy at lower priority, which is ended with all that it starts
    bool stays = false;       // a program that goes on when the object ends, and that Ctrl-C does not reach
};

class Process {
public:
    using Clock = std::chrono::steady_clock;

    Process() = default;
    ~Process() { end(); }
    Process(Process&& other) noexcept { swap(other); }
    Process& operator=(Process&& other) noexcept {
        swap(other);
        return *this;
    }

    // Each ends what runs, and returns "" or why the process cannot be made.

    // Calls `work` in a copy of this process, with its return value as exit status; an exception is the status 1. The
    // copy has no other threads and no context.
    std::string start(const std::function<int(std::string& result)>& work, const ProcessLimits& limits);
    // Starts a program, found as a shell finds it, with nothing to read. The words are the program and its arguments.
    std::string start(const std::vector<std::string>& words, const ProcessLimits& limits);

    bool running() const { return child_ > 0; }
    // To wait on; -1 if nothing runs.
    int descriptor() const { return pipe_; }
    Clock::time_point deadline() const { return deadline_; }
    // Takes what has arrived. Returns how the process ended, once it has.
    std::optional<Ended> poll();
    // The same, when it has ended.
    Ended wait();
    // Ends the process if it does not stay.
    void end();

private:
    void swap(Process& other) noexcept;
    std::string began(pid_t child, int pipe, int error);
    void stop() const;
    void take();

    pid_t child_ = 0;
    int pipe_ = -1;
    bool copy_ = false, closed_ = false;  // closed_: the output has ended
    ProcessLimits limits_;
    Clock::time_point deadline_ = Clock::time_point::max();
    Ended ended_;
};

}  // namespace snell::content
