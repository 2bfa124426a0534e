#include "src/app/open/complain.h"

#include <fmt/format.h>

#include "parser/text/words.h"

namespace snell {

std::string statement_text(const Span& span, const Sources& sources) {
    constexpr std::size_t most = 200;
    std::string text;
    for (const char c : sources.text(span.file).substr(span.begin, span.end - span.begin)) {
        const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\\';
        if (!blank)
            text += c;
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
        if (text.size() >= most) break;
    }
    return utf8::printable(text);
}

std::string statement_place(const Span& span, const Sources& sources) {
    const std::string_view file = sources.name(span.file);
    return utf8::printable(
        fmt::format("{}:{}", file.substr(file.rfind('/') + 1), sources.position(span.file, span.begin).line));
}

}  // namespace snell
