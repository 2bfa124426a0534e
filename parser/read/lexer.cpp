#include "parser/read/lexer.h"

#include <algorithm>
#include <array>

#include "parser/text/utf8.h"

namespace snell {
namespace {

enum class Class : std::uint8_t {
    word,
    blank,
    line_end,
    hash,
    slash,
    backslash,
    open,
    close,
    paren,
    comma,
    semicolon,
    quote,
    high
};

constexpr std::array<Class, 256> classes = [] {
    std::array<Class, 256> table{};
    for (const unsigned char c : {' ', '\t', '\v', '\f'}) table[c] = Class::blank;
    for (const unsigned char c : {'\r', '\n'}) table[c] = Class::line_end;
    for (const unsigned char c : {'<', '[', '{'}) table[c] = Class::open;
    for (const unsigned char c : {'>', ']', '}'}) table[c] = Class::close;
    for (const unsigned char c : {'(', ')'}) table[c] = Class::paren;
    table['#'] = Class::hash;
    table['/'] = Class::slash;
    table['\\'] = Class::backslash;
    table[','] = Class::comma;
    table[';'] = Class::semicolon;
    table['"'] = Class::quote;
    for (std::size_t c = 0x80; c < 256; ++c) table[c] = Class::high;
    return table;
}();

Class class_of(char c) { return classes[static_cast<unsigned char>(c)]; }

// These characters look like blanks but are not blanks of the language. They are read as blanks, with a warning.
bool odd_blank(const utf8::Char& c) {
    const char32_t code = c.code;
    if (code == 0xA0) return true;  // also as a byte of Latin-1
    return c.valid && ((code >= 0x2000 && code <= 0x200F) || code == 0x1680 || (code >= 0x2028 && code <= 0x202F) ||
                       code == 0x205F || (code >= 0x2060 && code <= 0x2064) || code == 0x3000 || code == 0xFEFF);
}

bool odd_quote(const utf8::Char& c) { return c.valid && (c.code == 0x201C || c.code == 0x201D || c.code == 0x201E); }

}  // namespace

Lexer::Lexer(std::string_view text, FileId file) : text_(text), file_(file) {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
}

Line Lexer::read_line(std::vector<Token>& tokens) {
    Line line;
    bool line_start = true, glued = false;
    while (at_ < text_.size()) {
        const auto at = static_cast<std::uint32_t>(at_);
        const Token token{TokenKind::word, glued, line_start, false, at, at + 1};
        const std::size_t before = tokens.size();
        const char c = text_[at_];
        switch (class_of(c)) {
            case Class::blank:
                ++at_;
                break;
            case Class::line_end:
                at_ += c == '\r' && text_.substr(at_ + 1, 1) == "\n" ? 2 : 1;
                return line;
            case Class::hash:
                comment(line);
                break;
            case Class::slash:
                text_.substr(at_ + 1, 1) == "/" ? comment(line) : word(tokens, token);
                break;
            case Class::backslash:
                backslash(tokens, token, line);
                break;
            case Class::open:
                mark(tokens, token, TokenKind::open, 1);
                break;
            case Class::close:
                mark(tokens, token, TokenKind::close, -1);
                break;
            case Class::paren:
                mark(tokens, token, c == '(' ? TokenKind::open : TokenKind::close, c == '(' ? 1 : -1);
                break;
            case Class::semicolon:
            case Class::comma:
                mark(tokens, token, TokenKind::comma, 0);
                break;
            case Class::quote:
                quoted(tokens, token, 1);
                break;
            case Class::high:
                high(tokens, token);
                break;
            case Class::word:
                word(tokens, token);
                break;
        }
        glued = tokens.size() > before;
        line_start = line_start && !glued;
    }
    line.at_end = true;
    return line;
}

void Lexer::mark(std::vector<Token>& tokens, Token token, TokenKind kind, int deeper) {
    depth_ = std::max(0, depth_ + deeper);
    ++at_;
    token.kind = kind;
    tokens.push_back(token);
}

void Lexer::backslash(std::vector<Token>& tokens, Token token, Line& line) {
    const std::size_t end = end_of_backslashes(at_);
    line.continued = line.continued || ends_line(end);
    if (!ends_line(end) && !blank(end)) return word(tokens, token);
    if (!ends_line(end)) stray_.push_back({file_, token.begin, static_cast<std::uint32_t>(end)});
    at_ = end;
}

void Lexer::high(std::vector<Token>& tokens, Token token) {
    const utf8::Char odd = utf8::decode(text_, at_);
    if (!odd_blank(odd) && !odd_quote(odd)) return word(tokens, token);
    note_odd(odd.code, at_, odd.length);
    if (odd_quote(odd)) return quoted(tokens, token, odd.length);
    at_ += odd.length;
}

void Lexer::word(std::vector<Token>& tokens, Token token) {
    std::size_t i = at_;
    for (; i < text_.size(); ++i) {
        const Class c = class_of(text_[i]);
        if (c == Class::word || c == Class::quote) continue;
        if (c == Class::slash && text_.substr(i + 1, 1) != "/") continue;
        if (c == Class::semicolon && !ends_word(i)) continue;
        if (c == Class::paren && depth_ == 0) continue;
        if (c == Class::backslash) {
            const std::size_t end = end_of_backslashes(i);
            if (blank(end) || ends_line(end)) break;
            i = end - 1;
            continue;
        }
        if (c == Class::high) {
            const utf8::Char odd = utf8::decode(text_, i);
            if (!odd_blank(odd)) {
                i += odd.length - 1;
                continue;
            }
        }
        break;
    }
    at_ = i;
    token.end = static_cast<std::uint32_t>(i);
    tokens.push_back(token);
}

// A semicolon ends a word where C would have it: before a blank, a line end or another separator.
bool Lexer::ends_word(std::size_t at) const {
    if (depth_ > 0 || at + 1 >= text_.size()) return true;
    const Class next = class_of(text_[at + 1]);
    return next != Class::word && next != Class::slash && next != Class::high;
}

void Lexer::quoted(std::vector<Token>& tokens, Token token, std::uint32_t quote_length) {
    token.kind = TokenKind::text;
    std::size_t i = at_ + quote_length;
    std::size_t close_length = 0;
    while (i < text_.size() && class_of(text_[i]) != Class::line_end) {
        if (text_[i] == '"') close_length = 1;
        const utf8::Char c = utf8::decode(text_, i);
        if (odd_quote(c)) close_length = c.length;
        if (close_length > 0) break;
        i += c.length;
    }
    token.unclosed = close_length == 0;
    at_ = i + close_length;
    token.end = static_cast<std::uint32_t>(at_);
    tokens.push_back(token);
}

void Lexer::comment(Line& line) {
    line.comment = true;
    std::size_t end = at_;
    while (end < text_.size() && class_of(text_[end]) != Class::line_end) ++end;
    const std::size_t last = text_.substr(at_, end - at_).find_last_not_of(" \t\v\f");
    line.comment_continued = last != std::string_view::npos && text_[at_ + last] == '\\';
    at_ = end;
}

std::size_t Lexer::end_of_backslashes(std::size_t at) const {
    while (at < text_.size() && text_[at] == '\\') ++at;
    return at;
}

bool Lexer::blank(std::size_t at) const {
    if (at >= text_.size()) return false;
    const Class c = class_of(text_[at]);
    return c == Class::blank || (c == Class::high && odd_blank(utf8::decode(text_, at)));
}

// Whether only blanks come before the end of the line or a comment.
bool Lexer::ends_line(std::size_t at) const {
    while (blank(at)) at += utf8::decode(text_, at).length;
    if (at >= text_.size()) return true;
    const Class c = class_of(text_[at]);
    return c == Class::line_end || c == Class::hash || (c == Class::slash && text_.substr(at, 2) == "//");
}

void Lexer::note_odd(char32_t code, std::size_t at, std::uint32_t length) {
    for (OddCharacter& odd : odd_) {
        if (odd.code == code) {
            ++odd.count;
            return;
        }
    }
    const auto begin = static_cast<std::uint32_t>(at);
    odd_.push_back({code, 1, {file_, begin, begin + length}});
}

}  // namespace snell
