#include "src/ui/kit/excerpt.h"

#include <algorithm>
#include <vector>

#include "parser/text/utf8.h"

namespace snell::ui {

namespace {

// Byte offsets of the characters, and of the end.
std::vector<std::size_t> characters(std::string_view text) {
    std::vector<std::size_t> starts;
    for (std::size_t at = 0; at < text.size(); at += utf8::decode(text, at).length) starts.push_back(at);
    starts.push_back(text.size());
    return starts;
}

// Characters `first` to `first + count`, after the `margin`, which is always kept.
std::string window(std::string_view text, std::size_t margin, std::size_t first, std::size_t count,
                   std::string_view dots) {
    const std::vector<std::size_t> at = characters(text);
    const std::size_t length = at.size() - 1;
    if (length <= margin) return std::string(text);
    std::string part(text.substr(0, at[margin]));
    const std::size_t begin = std::min(margin + first, length), end = std::min(begin + count, length);
    std::string_view body = text.substr(at[begin], at[end] - at[begin]);
    const bool left = first > 0, right = end < length && !dots.empty();
    if (left && begin < end) {
        part += dots.empty() ? body.substr(0, at[begin + 1] - at[begin]) : dots;
        body.remove_prefix(at[begin + 1] - at[begin]);
    }
    if (right && !body.empty()) body = body.substr(0, body.size() - (at[end] - at[end - 1]));
    part += body;
    if (right) part += dots;
    return part;
}

}  // namespace

bool is_source(std::string_view line) {
    const std::size_t bar = line.find_first_not_of(" 0123456789");
    return bar != std::string_view::npos && line[bar] == '|';
}

Excerpt excerpt(std::string_view source, std::string_view carets, std::size_t columns) {
    const std::size_t margin = std::min(source.find('|'), source.size()) + 2;
    const std::size_t length = characters(source).size() - 1;
    if (length <= columns || columns <= margin + 3) return {std::string(source), std::string(carets)};
    const std::size_t room = columns - margin;
    const std::size_t caret = std::min(carets.find('^'), carets.size());
    const std::size_t place = caret > margin ? caret - margin : 0;
    // A third of the visible characters precedes the caret.
    const std::size_t last = length - margin - room;
    const std::size_t first = place + 2 < room ? 0 : std::min(place - room / 3, last);
    return {window(source, margin, first, room, "\u2026"), window(carets, margin, first, room, {})};
}

}  // namespace snell::ui
