// The dialogs that ask for a name: to save the scene with its current values under another name, or as a page, to write
// a found rung, and to save the picture in any size, or a sequence of pictures over a span of time.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>

#include "src/ui/kit/kit.h"

namespace snell::ui {

struct Facts;
struct Memory;
struct Requests;

struct SaveAs {
    bool open = false;
    std::array<char, 2048> file{};  // relative to the scene's folder
    std::string there;              // the name that was given, if the user is asked; empty if not
    bool makes = false;             // whether to make a folder is asked then, otherwise whether to replace a file
    std::string existing;           // that file, or that folder
    std::string error;              // why nothing was saved; empty if there was no error
    std::string folder;             // that the name is relative to, as displayed; may be empty
    std::string place;              // where the file goes if that is not where it is typed, as displayed
    std::string placed;             // the name of which that is said

    // True while the user is asked, unless the name was changed.
    bool asks() const { return !there.empty() && there == file.data(); }
};

// True if the file of this path may be written, or the folder made: there is nothing to ask, or the user has confirmed.
// Otherwise the dialog asks.
bool confirmed(SaveAs& dialog, bool asks, const std::string& path, bool makes = false);
// Opens a dialog with a name to begin with.
void open_save_as(SaveAs& dialog, const std::string& name, std::string folder = {});
// Draws the dialogs while they are open.
void save_as_windows(Memory& memory, Requests& requests, Layout& layout);

// The name is as for `snell render -o`.
struct PictureMemory : SaveAs {
    double width = 0, height = 0;  // whole numbers, as is `samples`
    double samples = 4;            // per pixel
    bool transparent = false;
    // Saves pictures from time `from` to `to`, in seconds, without the one at `to`; `rate` is pictures per second.
    bool sequence = false;
    double from = 0, to = 10, rate = 25;
    std::string names;               // of the first pictures of a sequence; empty if they are not known
    std::optional<double> progress;  // 0 to 1 while pictures are being saved
    // What can be asked for: pixels along a side, pictures of a sequence.
    double largest = std::numeric_limits<double>::infinity(), most = 1;
};

// The number of pictures of a sequence; picture k is at time from + k / rate.
int picture_count(const PictureMemory& picture);
// Why there is no such sequence; "" if there is one.
std::string sequence_problem(const PictureMemory& picture);

enum class PictureRequest : unsigned char { none, open, save, command, stop };

// Draws the dialog while it is open.
void picture_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

}  // namespace snell::ui
