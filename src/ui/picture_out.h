// The window that saves what is seen: of any size, or many pictures of a time.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "src/ui/layout.h"

namespace snell::ui {

struct Facts;
struct Memory;
struct Requests;

struct PictureMemory {
    bool open = false;
    std::array<char, 2048> file{};  // as `snell render -o` takes it
    double width = 0, height = 0;   // whole numbers, as `samples` is
    double samples = 4;             // a pixel
    bool transparent = false;
    bool sequence = false;  // pictures of the time between these, the last one left out
    double from = 0, to = 10, rate = 25;
    std::string there;               // the file that would be replaced: asked before it is
    std::string error;               // why there is no picture
    std::optional<double> progress;  // 0 to 1, while it is drawn
};

// Of a sequence: picture k is at from + k / rate.
int picture_count(const PictureMemory& picture);

enum class PictureRequest : unsigned char { none, open, save, replace, command, stop };

void picture_button(Requests& requests, Layout& layout);
void picture_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

}  // namespace snell::ui
