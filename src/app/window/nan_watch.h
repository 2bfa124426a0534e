// Looks for NaN without being asked: a picture of bytes shows it as a colour like others. What is looked at is a small
// picture in floats, once after each change, when the window's picture is sharp and has not changed for a moment.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "src/app/window/display.h"
#include "src/document/document.h"

namespace snell {

class NanWatch {
public:
    // Call it after each picture, with what that is of, but for its size and, where time runs, its time. Returns true
    // if something else was said of the one before. `now` is in seconds.
    bool follow(const Drawn& shown, double now);
    // True if look() has something to do.
    bool due(double now) const { return !looked_ && now > since_ + until_still; }
    // Draws the pictures that the window shows with a fraction of the pixels. `stand` is that of a sharp one, which
    // took so many milliseconds. Returns true if there is something to say.
    bool look(std::span<Document* const> shown, const Stand& stand, double milliseconds);
    // How much is NaN; empty if nothing was seen.
    const std::string& text() const { return text_; }
    // How often the window was looked at so far.
    std::uint64_t looks() const { return looks_; }

private:
    static constexpr double until_still = .5;  // seconds
    Drawn shown_;
    double since_ = 0;
    bool looked_ = true;  // at what is shown
    int slow_ = 0;        // so many small pictures of this reading took about as long as large ones
    std::string text_;
    std::uint64_t looks_ = 0;
};

}  // namespace snell
