// Source texts and places in them.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

using FileId = std::uint32_t;

// A half-open range of bytes of one source text. Line and column are only computed when it is printed.
struct Span {
    FileId file = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool operator==(const Span&) const = default;
};

// 1-based; columns count characters (UTF-8 code points; each invalid byte counts as one).
struct Position {
    int line = 1;
    int column = 1;
};

// Where each line of a text begins. CR, LF and CRLF end a line.
std::vector<std::uint32_t> line_starts(std::string_view text);

// All texts that diagnostics may refer to: scenes, included scenes, shaders. References that it returns stay valid
// during its lifetime.
class Sources {
public:
    // Adds a text under a name for diagnostics, and returns its id.
    FileId add(std::string name, std::string text);

    std::string_view name(FileId file) const;
    std::string_view text(FileId file) const;
    std::size_t size() const { return entries_.size(); }

    Position position(FileId file, std::uint32_t offset) const;
    // Returns the line (1-based) without its line end; empty if there is no such line.
    std::string_view line(FileId file, int line) const;
    // Returns the span of that line without surrounding blanks, or of one column if column > 0.
    Span line_span(FileId file, int line, int column = 0) const;

private:
    struct Entry {
        std::string name;
        std::string text;
        std::vector<std::uint32_t> lines;  // offsets of the beginnings of lines
    };
    const Entry* entry(FileId file) const { return file < entries_.size() ? &entries_[file] : nullptr; }
    std::deque<Entry> entries_;
};

}  // namespace snell
