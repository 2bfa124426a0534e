// Progress of loading and measuring, if it takes longer than half a second.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "src/runtime/runtime.h"

namespace snell {

// Formats as "compiling programs: 2 of 5 (Glass)".
std::string words(const LoadProgress& progress);
// The completed part of the current stage, 0 to 1.
double share(const LoadProgress& progress);

// Decides when progress is shown.
class Patience {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds before{500}, between{50};

    // Starts the time of work other than loading.
    void begin(Clock::time_point now = Clock::now()) { next_ = now + before; }
    // True if the work began at least half a second ago, and progress was not shown within the last 50 ms.
    bool due(Clock::time_point now = Clock::now());
    bool due(const LoadProgress& progress, Clock::time_point now = Clock::now());
    static bool begins(const LoadProgress& progress) {
        return progress.stage == LoadProgress::Stage::programs && progress.done == 0;
    }
    static bool ends(const LoadProgress& progress) {
        return progress.stage == LoadProgress::Stage::draws && progress.done == progress.of;
    }

private:
    Clock::time_point next_{};
};

// Shows progress in one line of a terminal, which is cleared when the work ends. Shows nothing if standard error is not
// a terminal.
class ProgressLine {
public:
    // Returns a function for RuntimeOptions::progress, which is valid as long as this object is neither moved nor
    // destroyed. Null if standard error is not a terminal.
    Watcher watcher();
    // Of what takes long and is no loading.
    void begin() { patience_.begin(); }
    void show(std::string_view words, double share);
    void clear();
    static bool on_terminal();

private:
    void show(const LoadProgress& progress);
    void print(std::string line);

    bool terminal_ = on_terminal();
    Patience patience_;
    std::string shown_;  // "" while nothing is shown
};

// `share` is 0 to 1; `columns` is the maximum width of the line.
std::string progress_line(std::string_view words, double share, std::size_t columns);
std::string progress_line(const LoadProgress& progress, std::size_t columns);

}  // namespace snell
