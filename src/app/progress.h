// How far loading and measuring are, for anyone who waits longer than half a second.
#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

#include "src/runtime/runtime.h"

namespace snell {

// "compiling programs: 2 of 5 (Glass)"
std::string words(const LoadProgress& progress);
// Of its stage, 0 to 1.
double share(const LoadProgress& progress);

// When it is worth showing.
class Patience {
public:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::milliseconds before{500}, between{50};

    // Something else than loading begins.
    void begin(Clock::time_point now = Clock::now()) { next_ = now + before; }
    // It began half a second ago, and what was shown last is a twentieth old.
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

// One line of a terminal, which is empty again when loading ends. Nothing where standard error is no terminal.
class ProgressLine {
public:
    // What RuntimeOptions::progress takes, as long as this stays where it is.
    Watcher watcher();
    // Of what takes long and is no loading.
    void begin() { patience_.begin(); }
    void show(std::string_view words, double share);
    void clear();

private:
    void show(const LoadProgress& progress);
    void print(std::string line);
    static bool on_terminal();

    bool terminal_ = on_terminal();
    Patience patience_;
    std::string shown_;  // "": nothing
};

// `share`: 0 to 1; `columns`: what the line may take.
std::string progress_line(std::string_view words, double share, std::size_t columns);
std::string progress_line(const LoadProgress& progress, std::size_t columns);

}  // namespace snell
