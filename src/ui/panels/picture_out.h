// The dialog that saves the picture in any size, or a sequence of pictures over a span of time.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "src/ui/kit/kit.h"

namespace snell::ui {

struct Facts;
struct Memory;
struct Requests;

struct PictureMemory {
    bool open = false;
    std::array<char, 2048> file{};  // as for `snell render -o`
    double width = 0, height = 0;   // whole numbers, as is `samples`
    double samples = 4;             // per pixel
    bool transparent = false;
    // Saves pictures from time `from` to `to`, in seconds, without the one at `to`; `rate` is pictures per second.
    bool sequence = false;
    double from = 0, to = 10, rate = 25;
    std::string there;               // the name that was given, if the user is asked to replace a file; empty if not
    std::string existing;            // the first of its files that is there
    std::string error;               // why the picture was not saved; empty if there was no error
    std::optional<double> progress;  // 0 to 1 while pictures are being saved
};

// The number of pictures of a sequence; picture k is at time from + k / rate.
int picture_count(const PictureMemory& picture);

enum class PictureRequest : unsigned char { none, open, save, replace, command, stop };

// Draws the dialog while it is open.
void picture_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

}  // namespace snell::ui
