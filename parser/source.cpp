#include "parser/source.h"

#include <algorithm>

#include "parser/utf8.h"

namespace snell {
namespace {

// Offset just past the line end at or after `at`; text.size() when there is none. CR, LF and CRLF end a line.
std::size_t next_line(std::string_view text, std::size_t at) {
    const std::size_t end = text.find_first_of("\r\n", at);
    if (end == std::string_view::npos) return text.size();
    const bool pair = text[end] == '\r' && end + 1 < text.size() && text[end + 1] == '\n';
    return end + (pair ? 2 : 1);
}

bool line_end(char c) { return c == '\n' || c == '\r'; }

}  // namespace

FileId Sources::add(std::string name, std::string text) {
    entries_.push_back({std::move(name), std::move(text)});
    return static_cast<FileId>(entries_.size() - 1);
}

std::string_view Sources::name(FileId file) const { return file < size() ? entries_[file].name : std::string_view{}; }

std::string_view Sources::text(FileId file) const { return file < size() ? entries_[file].text : std::string_view{}; }

Position Sources::position(FileId file, std::uint32_t offset) const {
    const std::string_view text = this->text(file);
    const std::size_t end = std::min<std::size_t>(offset, text.size());
    Position position;
    std::size_t start = 0;
    for (std::size_t next = next_line(text, 0); next <= end && next > start && line_end(text[next - 1]);
         next = next_line(text, next)) {
        start = next;
        ++position.line;
    }
    if (start == 0 && text.starts_with("\xEF\xBB\xBF")) start = std::min<std::size_t>(3, end);
    for (std::size_t i = start; i < end; ++position.column) i += utf8::decode(text, i).length;
    return position;
}

std::string_view Sources::line(FileId file, int line) const {
    const std::string_view text = this->text(file);
    if (line < 1) return {};
    std::size_t start = 0;
    for (int i = 1; i < line; ++i) {
        const std::size_t next = next_line(text, start);
        if (next == start || !line_end(text[next - 1])) return {};
        start = next;
    }
    const std::size_t end = text.find_first_of("\r\n", start);
    return text.substr(start, end == std::string_view::npos ? end : end - start);
}

Span Sources::line_span(FileId file, int line, int column) const {
    const std::string_view text = this->text(file);
    const std::string_view found = this->line(file, line);
    if (found.data() == nullptr)
        return {file, static_cast<std::uint32_t>(text.size()), static_cast<std::uint32_t>(text.size())};
    const auto base = static_cast<std::uint32_t>(found.data() - text.data());
    if (column > 0) {
        std::size_t at = base == 0 && found.starts_with("\xEF\xBB\xBF") ? 3 : 0;
        for (int i = 1; i < column && at < found.size(); ++i) at += utf8::decode(found, at).length;
        const auto begin = static_cast<std::uint32_t>(base + at);
        return {file, begin, at < found.size() ? begin + utf8::decode(found, at).length : begin};
    }
    const std::size_t first = found.find_first_not_of(" \t\v\f");
    if (first == std::string_view::npos) return {file, base, base};
    const std::size_t last = found.find_last_not_of(" \t\v\f");
    return {file, static_cast<std::uint32_t>(base + first), static_cast<std::uint32_t>(base + last + 1)};
}

}  // namespace snell
