// Source texts and places in them.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace snell {

using FileId = std::uint32_t;

// A half-open range of bytes of one source text. Line and column are computed only when printed.
struct Span {
    FileId file = 0;
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    bool operator==(const Span&) const = default;
};

// 1-based; columns count characters (UTF-8 code points; invalid bytes count one each).
struct Position {
    int line = 1;
    int column = 1;
};

// Every text that a diagnostic may point into: scenes, included scenes, shaders.
// References handed out stay valid for the life of the registry.
class Sources {
public:
    FileId add(std::string name, std::string text);

    std::string_view name(FileId file) const;
    std::string_view text(FileId file) const;
    std::size_t size() const { return entries_.size(); }

    Position position(FileId file, std::uint32_t offset) const;
    // The line (1-based) without its line end; empty when there is no such line.
    std::string_view line(FileId file, int line) const;
    // The span of that line, without blanks at either end; of column only, if column > 0.
    Span line_span(FileId file, int line, int column = 0) const;

private:
    struct Entry {
        std::string name;
        std::string text;
        std::vector<std::uint32_t> lines;  // where each begins
    };
    const Entry* entry(FileId file) const { return file < entries_.size() ? &entries_[file] : nullptr; }
    std::deque<Entry> entries_;
};

}  // namespace snell
