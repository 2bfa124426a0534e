#include "parser/text/source.h"

#include <algorithm>
#include <cstring>

#include "parser/text/words.h"

namespace snell {
namespace {

bool marked(std::string_view text) { return text.starts_with("\xEF\xBB\xBF"); }

// Characters in text[begin, end).
int characters(std::string_view text, std::size_t begin, std::size_t end) {
    int count = 0;
    while (begin < end) {
        std::uint64_t eight = 0;
        if (begin + sizeof eight <= end) std::memcpy(&eight, text.data() + begin, sizeof eight);
        const bool ascii = begin + sizeof eight <= end && (eight & 0x8080808080808080u) == 0;
        begin += ascii ? sizeof eight : utf8::decode(text, begin).length;
        count += ascii ? static_cast<int>(sizeof eight) : 1;
    }
    return count;
}

}  // namespace

std::vector<std::uint32_t> line_starts(std::string_view text) {
    const bool only_lf = text.find('\r') == text.npos;
    const auto next = [&](std::size_t from) {
        return only_lf ? text.find('\n', from) : text.find_first_of("\r\n", from);
    };
    std::vector<std::uint32_t> starts{0};
    for (std::size_t at = next(0); at != text.npos; at = next(at)) {
        at += text.substr(at, 2) == "\r\n" ? 2 : 1;
        starts.push_back(static_cast<std::uint32_t>(at));
    }
    return starts;
}

FileId Sources::add(std::string name, std::string text) {
    std::vector<std::uint32_t> lines = line_starts(text);
    entries_.push_back({std::move(name), std::move(text), std::move(lines)});
    return static_cast<FileId>(entries_.size() - 1);
}

std::string_view Sources::name(FileId file) const {
    const Entry* e = entry(file);
    return e ? e->name : std::string_view{};
}

std::string_view Sources::text(FileId file) const {
    const Entry* e = entry(file);
    return e ? e->text : std::string_view{};
}

Position Sources::position(FileId file, std::uint32_t offset) const {
    const Entry* e = entry(file);
    if (!e) return {};
    const std::size_t end = std::min<std::size_t>(offset, e->text.size());
    const auto next = std::upper_bound(e->lines.begin(), e->lines.end(), end);
    std::size_t start = *(next - 1);
    if (start == 0 && marked(e->text)) start = std::min<std::size_t>(3, end);
    return {static_cast<int>(next - e->lines.begin()), 1 + characters(e->text, start, end)};
}

std::string_view Sources::line(FileId file, int line) const {
    const Entry* e = entry(file);
    if (!e || line < 1 || static_cast<std::size_t>(line) > e->lines.size()) return {};
    const std::string_view text = e->text;
    const auto index = static_cast<std::size_t>(line);
    const std::size_t start = e->lines[index - 1];
    std::size_t end = index < e->lines.size() ? e->lines[index] : text.size();
    if (index < e->lines.size()) end -= text.substr(start, end - start).ends_with("\r\n") ? 2 : 1;
    return text.substr(start, end - start);
}

Span Sources::line_span(FileId file, int line, int column) const {
    const std::string_view text = this->text(file);
    const std::string_view found = this->line(file, line);
    if (found.data() == nullptr)
        return {file, static_cast<std::uint32_t>(text.size()), static_cast<std::uint32_t>(text.size())};
    const auto base = static_cast<std::uint32_t>(found.data() - text.data());
    if (column > 0) {
        std::size_t at = base == 0 && marked(found) ? 3 : 0;
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
