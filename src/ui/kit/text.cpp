#include "src/ui/kit/text.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/words.h"

namespace snell::ui {

void Text::add_all(fmt::string_view format, fmt::format_args arguments) {
    fmt::vformat_to(std::back_inserter(buffer_), format, arguments);
}

MarkedLine excerpt(const MarkedLine& line, std::size_t columns) {
    std::vector<std::string_view> characters;
    const std::string_view text = line.text;
    for (std::size_t at = 0; at < text.size(); at += characters.back().size())
        characters.push_back(text.substr(at, utf8::decode(text, at).length));
    const auto caret = static_cast<std::size_t>(line.begin);
    const std::size_t length = std::max(characters.size(), caret + 1);
    if (length <= columns || columns <= 3) return line;
    // A third of the visible characters precedes the caret.
    const std::size_t first = caret + 2 < columns ? 0 : std::min(caret - columns / 3, length - columns);
    const std::size_t end = std::min(first + columns, characters.size());
    MarkedLine part;
    for (std::size_t i = first; i < end; ++i) {
        const bool cut = (i == first && first > 0) || (i + 1 == end && end < characters.size());
        part.text += cut ? "\u2026" : characters[i];
    }
    part.begin = line.begin - static_cast<int>(first);
    part.end = std::min(line.end - static_cast<int>(first), static_cast<int>(columns));
    return part;
}

}  // namespace snell::ui
