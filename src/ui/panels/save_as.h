// The dialogs that ask for a name: to save the scene with its current values under another name, or as
// a page, and to write a found rung.
#pragma once

#include <array>
#include <string>

#include "src/ui/kit/kit.h"

namespace snell::ui {

struct Memory;
struct Requests;

struct SaveAs {
    bool open = false;
    std::array<char, 2048> file{};  // relative to the scene's folder
    std::string there;              // the name that was given, if the user is asked to replace a file; empty if not
    std::string existing;           // that file
    std::string error;              // why nothing was saved; empty if there was no error
};

// Opens a dialog with a name to begin with.
void open_save_as(SaveAs& dialog, const std::string& name);
// Draws the dialogs while they are open.
void save_as_windows(Memory& memory, Requests& requests, Layout& layout);

}  // namespace snell::ui
