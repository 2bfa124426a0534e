// Found rungs by their numbers, and the texts of a scene that has them. No GL; nothing is written.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/found/change.h"

namespace snell::accuracy {

// Changes that are made together, named by their numbers: "3" or "3+7".
struct Chosen {
    std::vector<std::size_t> numbers;  // from 1, ascending
    // In this order. Each text has one FileId, however often it was included, and edits have its line ends.
    std::vector<Change> changes;
};

// Reads a name such as "3+7", as parse_rung() does. Returns nullopt and sets `error` if there is no such change, or two
// change the same text.
std::optional<Chosen> choose_changes(std::string_view name, std::span<const Change> changes, const Sources& sources,
                                     std::string& error);

// Such as "glass.frag:12:5".
std::string change_place(const Change& change, const Sources& sources);

// Edits at other places than the first, such as "glass.frag:14:12: 8. → 4.".
std::vector<std::string> other_edits(const Change& change, const Sources& sources);

// Such as "glass.frag:12:5: i < 8 → i < 4". Other edits follow on lines of their own.
std::string change_line(const Change& change, const Sources& sources);

// The first of several readings of a text: a shader that several others include is read once for each.
FileId first_reading(FileId file, const Sources& sources);

// The line end of a text: that of its first line, "\n" if it has only one line.
std::string_view line_end_of(std::string_view text);

}  // namespace snell::accuracy
