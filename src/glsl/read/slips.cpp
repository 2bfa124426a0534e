#include "src/glsl/read/slips.h"

#include <algorithm>

#include "src/glsl/read/macro.h"

namespace snell::glsl {

namespace {

std::string_view past_blanks(std::string_view line) {
    return line.substr(std::min(line.find_first_not_of(" \t\v\f\r"), line.size()));
}

// Nothing is lost with a line that is empty, or a comment too.
bool harmless(std::string_view next) {
    next = past_blanks(next);
    return next.empty() || next.starts_with("//");
}

void check_continued(std::string_view text, Span comment, Diagnostics& diagnostics) {
    const std::string_view whole = text.substr(comment.begin, comment.end - comment.begin);
    // An author who turns `#define F(x) \` into a comment means its next lines, too.
    const std::size_t slashes = whole.find_first_not_of('/');
    if (slashes == std::string_view::npos || past_blanks(whole.substr(slashes)).starts_with('#')) return;
    for (std::size_t end = whole.find('\n'); end != std::string_view::npos; end = whole.find('\n', end + 1)) {
        const std::string_view rest = whole.substr(end + 1);
        if (harmless(rest.substr(0, rest.find('\n')))) continue;
        const auto at = comment.begin + static_cast<std::uint32_t>(whole.rfind('\\', end));
        diagnostics.warning("comment-continued", {comment.file, at, at + 1},
                            "this '\\' makes the next line a part of the comment",
                            "remove it, or put another character after it");
        return;
    }
}

}  // namespace

void check_comments(std::string_view text, FileId file, Diagnostics& diagnostics) {
    for (std::size_t i = text.find('/'); i != std::string_view::npos; i = text.find('/', i)) {
        const std::size_t begin = i;
        const auto span_to = [&](std::size_t end) {
            return Span{file, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
        };
        const std::string_view opening = text.substr(begin, 2);
        if (opening == "//") {
            i = line_comment_end(text, begin);
            check_continued(text, span_to(i), diagnostics);
        } else if (opening == "/*") {
            const std::size_t close = text.find("*/", begin + 2);
            if (close == std::string_view::npos) {
                diagnostics.error("unclosed-comment", span_to(begin + 2), "this comment is never closed",
                                  "write '*/' where it ends");
                return;
            }
            i = close + 2;
        } else {
            ++i;
        }
    }
}

std::size_t before_surplus(std::string_view name, std::string_view rest, Span place, Diagnostics& diagnostics) {
    const std::vector<MacroToken> tokens = macro_tokens(rest);
    // `#else if` means more than `#else`: that is for the driver to refuse.
    if ((name != "else" && name != "endif") || tokens.empty() || tokens.front().text == "if") return rest.size();
    const std::string_view first = tokens.front().text, last = tokens.back().text;
    const auto begin = static_cast<std::size_t>(first.data() - rest.data());
    const auto end = static_cast<std::size_t>(last.data() + last.size() - rest.data());
    const auto at = static_cast<std::uint32_t>(place.end - rest.size());
    const Span words{place.file, static_cast<std::uint32_t>(at + begin), static_cast<std::uint32_t>(at + end)};
    Diagnostic& said = diagnostics.warning(
        "surplus-words", words, "nothing may follow #" + std::string(name) + ": the rest of the line is ignored",
        "make it a comment: //");
    if (rest.find('\n', begin) == rest.npos) said.fixes = {{{words.file, words.begin, words.begin}, "// "}};
    return begin;
}

}  // namespace snell::glsl
