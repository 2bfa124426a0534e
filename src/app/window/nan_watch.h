// Looks for NaN and infinity without being asked: a picture of bytes shows them as colours like others. What is looked
// at is a small picture in floats, once after each change, when the window's picture is sharp and has not changed for a
// moment.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/app/window/display.h"
#include "src/document/document.h"
#include "src/runtime/inspect.h"

namespace snell {

class NanWatch {
public:
    // Call it after each picture, with what that is of, but for its size and, where time runs, its time. `now` is in
    // seconds.
    void follow(const Drawn& shown, double now);
    // True if look() has something to do.
    bool due(double now) const { return !looked_ && now > since_ + until_still; }
    // Draws what the window shows, one picture or two states, with a fraction of the pixels; null: there is no picture
    // of that state. `stand` is that of a sharp one, which took so many milliseconds. Call tell() after it.
    void look(std::span<Document* const> shown, const Stand& stand, double milliseconds);
    // Counts what is seen, of two states that with the divider at this column of the small picture; nothing if they are
    // `hidden`. Returns true if something else is said.
    bool tell(std::optional<int> divider, bool hidden);
    int width() const { return width_; }
    // How much is NaN or infinite; empty if nothing was seen.
    const std::string& text() const { return text_; }
    // How often the window was looked at so far.
    std::uint64_t looks() const { return looks_; }

private:
    static constexpr double until_still = .5;  // seconds
    Drawn shown_;
    double since_ = 0;
    bool looked_ = true;  // at what is shown
    int slow_ = 0;        // so many small pictures of this reading took about as long as large ones
    std::vector<std::vector<FlagCounts>> columns_;  // of each small picture; empty: there is none
    int width_ = 0;
    std::string text_;
    std::uint64_t looks_ = 0;
};

}  // namespace snell
