// The dialog that saves the scene, with its current values, under another name.
#pragma once

#include <array>
#include <string>

#include "src/ui/kit/layout.h"

namespace snell::ui {

struct Memory;
struct Requests;

struct SaveAs {
    bool open = false;
    std::array<char, 2048> file{};  // relative to the scene's folder
    std::string there;              // the name that was given, if the user is asked to replace a file; empty if not
    std::string existing;           // that file
    std::string error;              // why the scene was not saved; empty if there was no error
};

// Opens the dialog with a name to begin with.
void open_save_as(SaveAs& dialog, const std::string& name);
// Draws the dialog while it is open.
void save_as_window(Memory& memory, Requests& requests, Layout& layout);

}  // namespace snell::ui
