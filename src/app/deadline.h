// The end of a process whose driver doesn't return.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace snell::app {

// While one is there, a thread of its own watches the clock: past the time it says what took too long and ends the
// process with exit_timeout, whatever the other threads are doing. Files are written whole or not at all, so none is
// left half. 0 seconds: no end.
class Deadline {
public:
    // With `late` that is called instead, once, on the thread that watches; when it returns, life goes on.
    using Late = std::function<void(const std::string& what)>;
    // `last` is what is still to be done, on that thread, before the process is ended.
    explicit Deadline(double seconds, Late late = nullptr, std::function<void()> last = nullptr);
    ~Deadline();
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    // What is done from now on has the whole time again.
    void begin(std::string what);
    // What is done from now on has what is left of the time.
    void now(std::string what);
    // Nothing is being done that could take too long.
    void rest();

private:
    void watch();

    using Clock = std::chrono::steady_clock;
    double seconds_;
    Late late_;
    std::function<void()> last_;
    std::mutex mutex_;
    std::condition_variable change_;
    Clock::time_point end_ = Clock::time_point::max();
    std::string what_;
    bool idle_ = false;  // the thread waits for a beginning
    bool done_ = false;
    std::thread thread_;
};

}  // namespace snell::app
