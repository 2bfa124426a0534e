// How the process ends where it can't go on: after its deadline, without memory, by Ctrl-C, or when the driver was
// reset.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <utility>

namespace snell::app {

// Ends the process if the driver does not return.

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

    // Starts the time again for the work that begins now; `what` names it in the message. `used`: seconds of it that
    // are over already, of which a quarter at least is left.
    void begin(std::string what, double used = 0);
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

// The end of a process for want of memory.

// Makes the process end by out_of_memory() where an allocation fails, and where the driver or one of its libraries ends
// it by a signal while hardly any address space is left: they do not survive that.
void watch_memory();

// Returns true if the limit of address space (`ulimit -v`) leaves less than that. The default is what drivers take at
// once: stacks of threads, and code that LLVM compiles; to be loaded they need more.
bool short_of_memory(std::size_t bytes = std::size_t{64} << 20);
constexpr std::size_t whole_driver = std::size_t{400} << 20;

// The limit of address space of this process and those that it makes, in bytes; infinite if there is none.
double address_space();

// Says so, and ends the process on whatever thread this happens, because exceptions would have to pass through drivers
// and libraries. No file is left incomplete: files are written whole or not at all.
[[noreturn]] void out_of_memory();

// Returns the status of the work, or prints the exception that ends it.
int status_of(const std::function<int()>& work);

// Ctrl-C in long runs that keep what they have done.

// While it exists, the first Ctrl-C is noted, and a second one ends the process.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;

    // Whether it came since the last one of these objects was made.
    static bool came();
    // Ends this process as Ctrl-C would have.
    [[noreturn]] static void end();

private:
    void (*before_)(int);
};

// Detects that the driver has reset the context.

// Asked after each frame.
class LossWatch {
public:
    LossWatch() = default;
    // For tests, whose drivers never reset: `frame` is the number of frames after which the context counts as lost (0:
    // never). It also counts as lost if `file` exists, which is then removed.
    explicit LossWatch(int frame) : left_(frame) {}
    explicit LossWatch(std::string file) : file_(std::move(file)) {}
    // Call it once per frame.
    bool lost();

private:
    int left_ = 0;
    std::string file_;
};

// The message about a reset, and its help.
inline constexpr const char* loss_message = "the graphics driver was reset, and the OpenGL context is lost";
inline constexpr const char* loss_help = "check for a shader that does not end; it may also be a driver fault";

}  // namespace snell::app
