// Ends the process if the driver does not return.
#pragma once

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace snell::app {

// While the object exists, a thread of its own watches the clock. After the time has passed, it prints what took too
// long and ends the process with exit_timeout, whatever the other threads are doing. Files are written whole or not at
// all, so none is left incomplete. With 0 seconds there is no deadline.
class Deadline {
public:
    // If given, it is called once on the watching thread instead of ending the process; when it returns, the process
    // continues.
    using Late = std::function<void(const std::string& what)>;
    // `last` is called on that thread before the process is ended.
    explicit Deadline(double seconds, Late late = nullptr, std::function<void()> last = nullptr);
    ~Deadline();
    Deadline(const Deadline&) = delete;
    Deadline& operator=(const Deadline&) = delete;

    // Starts the time again for the work that begins now; `what` names it in the message.
    void begin(std::string what);
    // The work that begins now has what is left of the time; `what` names it in the message.
    void now(std::string what);
    // Stops the time until the next begin().
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
    bool idle_ = false;  // the thread waits for begin()
    bool done_ = false;
    std::thread thread_;
};

}  // namespace snell::app
