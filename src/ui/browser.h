// The file browser: folders and scenes, as the desktop's own would show them.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/ui/layout.h"

namespace snell::ui {

struct Facts;
struct Memory;
struct Requests;

struct Entry {
    std::string name;  // fit to be shown
    std::string path;
    bool folder = false;
    std::string size, date;  // as they are shown; a folder has no size
};

struct Listing {
    std::string folder;  // absolute, without a link in it
    std::string home;
    std::vector<Entry> entries;  // folders first
    std::string error;           // why there are none
};

struct Browser {
    bool open = false;
    std::string folder;  // to be listed at the next request; empty: the scene's
    bool all = false;    // files that are no .glib too
    std::array<char, 1024> typed{};
    std::size_t chosen = 0;  // of what is shown
    bool focus = false;      // the field for the name takes the keys
};

// Asks for the listing of a folder; the window is open until something is chosen or Escape is pressed.
void open_browser(std::string folder, Memory& memory, Requests& requests);

void browser_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

// The entries that a name begun in the browser leaves, by index: those that contain it, in any case.
std::vector<std::size_t> matching(const Listing& listing, std::string_view typed);

// "/home/ann/scenes" as what can be clicked: {"/", "/"}, {"home", "/home"} ...
struct Crumb {
    std::string name, path;
};
std::vector<Crumb> crumbs(std::string_view folder);

}  // namespace snell::ui
