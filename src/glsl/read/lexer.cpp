#include "src/glsl/read/lexer.h"

#include <array>

namespace snell::glsl {

bool identifier_start(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool identifier_part(char c) { return identifier_start(c) || (c >= '0' && c <= '9'); }
bool blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

// Bytes of an exotic blank in UTF-8 that starts here: no-break space, the spaces of U+2000…, U+3000,
// zero-width characters and the byte-order mark.
std::size_t exotic_blank(std::string_view s) {
    auto byte = [&](std::size_t i) { return i < s.size() ? static_cast<unsigned char>(s[i]) : 0u; };
    if (byte(0) == 0xC2 && (byte(1) == 0xA0 || byte(1) == 0x85)) return 2;
    if (byte(0) == 0xE2 && byte(1) == 0x80 &&
        (byte(2) <= 0x8F || byte(2) == 0xA8 || byte(2) == 0xA9 || byte(2) == 0xAF))
        return byte(2) >= 0x80 ? 3 : 0;
    if (byte(0) == 0xE2 && byte(1) == 0x81 && (byte(2) == 0x9F || byte(2) == 0xA0)) return 3;
    if (byte(0) == 0xE3 && byte(1) == 0x80 && byte(2) == 0x80) return 3;
    if (byte(0) == 0xEF && byte(1) == 0xBB && byte(2) == 0xBF) return 3;
    return 0;
}

// A no-break space of Latin-1, which UTF-8 would not have on its own.
bool latin1_blank(std::string_view text, std::size_t i) {
    if (static_cast<unsigned char>(text[i]) != 0xA0) return false;
    return i == 0 || static_cast<unsigned char>(text[i - 1]) < 0x80;
}

void join_continuation(std::string& s, std::size_t backslash) {
    std::size_t end = backslash + 1;
    while (end < s.size() && blank(s[end])) ++end;
    if (end == backslash + 1 || end >= s.size() || (s[end] != '\n' && s[end] != '\r')) return;
    const std::size_t line_end = s.rfind('\n', backslash), line = line_end == std::string::npos ? 0 : line_end + 1;
    if (std::string_view(s).substr(line, backslash - line).find("//") != std::string_view::npos) return;
    s[backslash] = ' ';
    s[end - 1] = '\\';
}

}  // namespace

Cleaned clean(std::string_view text) {
    Cleaned out{std::string(text), false, 0};
    std::string& s = out.text;
    for (std::size_t i = 0; i < s.size(); ++i) {
        const auto c = static_cast<unsigned char>(s[i]);
        if (c == '\\') {
            join_continuation(s, i);
            continue;
        }
        if (c >= 0x20 && c < 0x7F) continue;
        if (c == '\n' || c == '\t' || (c == '\r' && i + 1 < s.size() && s[i + 1] == '\n')) continue;
        if (c == '\r') {  // a line end of old Macintosh editors
            s[i] = '\n';
            continue;
        }
        std::size_t width = c < 0x20 || c == 0x7F ? 1 : exotic_blank(std::string_view(s).substr(i));
        if (width == 0 && latin1_blank(text, i)) width = 1;
        if (width == 0) continue;
        const bool byte_order_mark = i == 0 && width == 3;
        if (c >= 0x80 && !byte_order_mark && !out.odd_blanks) {
            out.odd_blanks = true;
            out.first_odd = static_cast<std::uint32_t>(i);
        }
        for (std::size_t k = 0; k < width; ++k) s[i + k] = ' ';
        i += width - 1;
    }
    return out;
}

std::size_t line_comment_end(std::string_view text, std::size_t i) {
    for (i = text.find('\n', i); i != std::string_view::npos; i = text.find('\n', i + 1)) {
        std::string_view line = text.substr(0, i);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (!line.ends_with('\\')) return i;
    }
    return text.size();
}

Trivia skip_trivia(std::string_view text, std::size_t i) {
    bool line_end = false;
    while (i < text.size()) {
        const char c = text[i];
        if (c == '\n') {
            line_end = true;
            ++i;
        } else if (blank(c) || c == '\r') {
            ++i;
        } else if (c == '\\' && i + 1 < text.size() && (text[i + 1] == '\n' || text[i + 1] == '\r')) {
            i += text[i + 1] == '\r' && i + 2 < text.size() && text[i + 2] == '\n' ? 3 : 2;
        } else if (c == '/' && i + 1 < text.size() && text[i + 1] == '/') {
            i = line_comment_end(text, i);
        } else if (c == '/' && i + 1 < text.size() && text[i + 1] == '*') {
            const std::size_t close = text.find("*/", i + 2);
            i = close == std::string_view::npos ? text.size() : close + 2;
        } else {
            break;
        }
    }
    return {std::min(i, text.size()), line_end};
}

namespace {

Lexeme number(std::string_view text, std::size_t from) {
    std::size_t i = from;
    bool real = false;
    auto at = [&](std::size_t k) { return k < text.size() ? text[k] : '\0'; };
    if (at(i) == '0' && (at(i + 1) == 'x' || at(i + 1) == 'X')) {
        i += 2;
        while (identifier_part(at(i))) ++i;
        return {Kind::integer, text.substr(from, i - from)};
    }
    while (digit(at(i))) ++i;
    if (at(i) == '.') {
        real = true;
        ++i;
        while (digit(at(i))) ++i;
    }
    if (at(i) == 'e' || at(i) == 'E') {
        std::size_t k = i + 1;
        if (at(k) == '+' || at(k) == '-') ++k;
        if (digit(at(k))) {
            real = true;
            i = k;
            while (digit(at(i))) ++i;
        }
    }
    if (real && identifier_start(at(i)) && !digit(at(i + 1))) {  // f, F, h, lf, LF
        if (at(i) == 'f' || at(i) == 'F' || at(i) == 'h' || at(i) == 'd') {
            ++i;
        } else if ((at(i) == 'l' || at(i) == 'L') && (at(i + 1) == 'f' || at(i + 1) == 'F')) {
            i += 2;
        }
    } else if (!real && (at(i) == 'f' || at(i) == 'F')) {
        real = true;
        ++i;
    } else if (!real && (at(i) == 'u' || at(i) == 'U')) {
        ++i;
    }
    return {real ? Kind::real : Kind::integer, text.substr(from, i - from)};
}

constexpr std::array<std::string_view, 23> long_operators = {
    "<<=", ">>=", "++", "--", "<=", ">=", "==", "!=", "&&", "||", "^^", "+=",
    "-=",  "*=",  "/=", "%=", "&=", "|=", "^=", "<<", ">>", "##", "->"};

}  // namespace

Lexeme lex(std::string_view text, std::size_t from) {
    if (from >= text.size()) return {};
    const char c = text[from];
    if (identifier_start(c)) {
        std::size_t i = from;
        while (i < text.size() && identifier_part(text[i])) ++i;
        return {Kind::identifier, text.substr(from, i - from)};
    }
    if (digit(c) || (c == '.' && from + 1 < text.size() && digit(text[from + 1]))) return number(text, from);
    if (std::string_view("()[]{};,.~?:+-*/%<>=!&|^#").find(c) != std::string_view::npos) {
        for (const std::string_view op : long_operators)
            if (text.substr(from).starts_with(op)) return {Kind::punct, text.substr(from, op.size())};
        return {Kind::punct, text.substr(from, 1)};
    }
    std::size_t end = from + 1;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80 &&
           (static_cast<unsigned char>(c) & 0x80))
        ++end;
    return {Kind::other, text.substr(from, end - from)};
}

std::size_t directive_end(std::string_view text, std::size_t i) {
    while (i < text.size() && text[i] != '\n') {
        if (text[i] == '\\' && i + 1 < text.size()) {
            i += text[i + 1] == '\r' && i + 2 < text.size() ? 3 : 2;
        } else if (text.substr(i, 2) == "/*") {
            const std::size_t close = text.find("*/", i + 2);
            i = close == std::string_view::npos ? text.size() : close + 2;
        } else if (text.substr(i, 2) == "//") {
            i = line_comment_end(text, i);
        } else {
            ++i;
        }
    }
    return std::min(i, text.size());
}

std::size_t count_word(std::string_view text, std::string_view word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t end = at + word.size();
        const bool whole =
            (at == 0 || !identifier_part(text[at - 1])) && (end == text.size() || !identifier_part(text[end]));
        count += whole ? 1 : 0;
    }
    return count;
}

std::vector<IncludeName> included_names(std::string_view text) {
    constexpr std::string_view directive = "include";
    std::vector<IncludeName> names;
    for (std::size_t at = text.find(directive); at != text.npos; at = text.find(directive, at + directive.size())) {
        const std::size_t open = text.find_first_of("\"<\n", at);
        if (open == text.npos || text[open] == '\n') continue;
        const bool angle = text[open] == '<';
        const std::size_t end = text.find_first_of(angle ? ">\n" : "\"\n", open + 1);
        if (end != text.npos && text[end] != '\n') names.push_back({text.substr(open + 1, end - open - 1), angle});
    }
    return names;
}

}  // namespace snell::glsl
