// The file browser: lists folders and scenes as the desktop's own browsers do.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/ui/kit/kit.h"

namespace snell::ui {

struct Facts;
struct Memory;
struct Requests;

// A small picture of a scene.
struct SmallPicture {
    std::uintptr_t texture = 0;  // of GL, whose top row is first; 0: there is none
    float shape = 1;             // width over height
    std::string_view why = {};   // there is none; empty: it may still come
    bool operator==(const SmallPicture&) const = default;
};

// What stands in the place of a picture that there is not, in a place of that width.
std::string_view picture_words(const SmallPicture& picture, float room);

struct Entry {
    std::string name;  // with unprintable characters replaced
    std::string path;
    bool folder = false;
    std::string size, date;  // as displayed; empty size for a folder
    SmallPicture picture = {};
};

struct Listing {
    std::string folder;  // absolute, with links resolved
    std::string home;
    std::vector<Entry> entries;  // folders first
    std::string error;           // why the folder could not be listed; empty if it could
};

// A scene that is offered by its picture.
struct SceneCard {
    std::string name, folder;  // as displayed; "~" is the home folder
    std::string path;
    SmallPicture picture = {};
    bool operator==(const SceneCard&) const = default;
};

// What a new scene can begin as.
struct NewKind {
    std::string_view name, summary;
};

struct Browser {
    bool open = false;
    bool start = false;  // shows scenes to begin with instead of the folder
    std::string kind;    // of the new scene whose name is asked for
    std::string folder;  // the folder of the next listing; empty: the scene's
    bool all = false;    // also list files other than .glib
    std::string listed;  // the folder that was listed last
    std::array<char, 1024> typed{};
    std::size_t chosen = 0;  // index into the entries that are shown
    bool focus = false;      // moves the keyboard focus to the name field
    bool to_new = false;     // scrolls to the kinds of new scenes
    bool asked = false;      // a path was typed and is to be opened
    std::string error;       // why it could not be opened; empty if nothing is wrong
};

// Opens the browser and requests the listing of a folder; without one, it begins with pictures of scenes. It stays open
// until the user chooses a file or presses Escape.
void open_browser(std::string folder, Memory& memory, Requests& requests);

// Draws the browser while it is open.
void browser_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout);

// Indices of the entries whose name contains the typed text, in any case.
std::vector<std::size_t> matching(const Listing& listing, std::string_view typed);

// Splits a path into clickable parts: "/home/ann/scenes" gives {"/", "/"}, {"home", "/home"} ...
struct Crumb {
    std::string name, path;
};
std::vector<Crumb> crumbs(std::string_view folder);

}  // namespace snell::ui
