#include "parser/read/syntax.h"

#include <algorithm>
#include <array>

#include "parser/commands/commands.h"
#include "parser/text/number.h"
#include "parser/text/words.h"

namespace snell {
namespace {

bool is_whole(std::string_view word) {
    if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
    return !word.empty() && word.find_first_not_of("0123456789") == std::string_view::npos;
}

bool is_truth(std::string_view word) { return word == "true" || word == "false"; }

}  // namespace

bool StatementReader::next(Statement& statement) {
    tokens_.clear();
    lexer_.begin_statement();
    Line line;
    while (tokens_.empty()) {
        if (line.at_end) return false;
        line = lexer_.read_line(tokens_);
    }
    const Command* command = nullptr;
    bool looked_up = false;
    while (!line.at_end) {
        bool continued = line.continued;
        if (!continued && line.comment_continued) {
            if (!looked_up) command = find_command(lexer_.text(tokens_.front()));
            looked_up = true;
            // A backslash at the end of a comment means what it says only where lists of uniforms are continued.
            continued = command != nullptr && command->name == "Program";
        }
        if (!continued) break;
        const std::size_t first = tokens_.size();
        const std::size_t start = lexer_.position();
        const Line next = lexer_.read_line(tokens_);
        if (tokens_.size() == first) {
            // A comment is skipped and the statement goes on; a blank line ends it.
            if (!next.continued && !next.comment) break;
            const bool at_end = next.at_end;
            line = {at_end, true, false, false};
            continue;
        }
        if (swallows_command(first)) {
            if (line.continued) {
                const std::string name(lexer_.text(tokens_[first]));
                report_.warning("swallowed-command", lexer_.span(tokens_[first]),
                                "the line before ends with '\\', which makes '" + name + "' a part of its statement",
                                "it is read as a statement of its own; remove the '\\' before it");
            }
            tokens_.resize(first);
            lexer_.rewind(start);
            break;
        }
        line = next;
    }
    statement.tokens = tokens_;
    return true;
}

// Whether the line of tokens_[first], which continues a statement, is a command all the same. A uniform may be
// named like a command: what follows the name decides.
bool StatementReader::swallows_command(std::size_t first) const {
    const Token& token = tokens_[first];
    const std::string_view word = lexer_.text(token);
    const Command* found = token.kind == TokenKind::word ? find_command(word) : nullptr;
    if (found == nullptr) return false;
    const std::size_t count = tokens_.size() - first;
    if (count == 1) return true;
    const Token& value = tokens_[first + 1];
    const char bracket = lexer_.text()[value.begin];
    if (value.kind == TokenKind::open) return bracket == '[' && found->takes(ArgumentKind::vec3);
    // Commands may be written in any case, but 'scale 2.' in a list of uniforms is almost certainly a uniform.
    const bool as_in_table = word == found->name || word == found->alias;
    const bool lone_value = count == 2 && (plausible_number(lexer_.text(value)) || is_truth(lexer_.text(value)));
    return as_in_table || !lone_value;
}

void StatementReader::report_oddities() {
    for (const OddCharacter& odd : lexer_.odd_characters()) {
        const bool quote = odd.code >= 0x201C && odd.code <= 0x201E;
        std::string message = odd.code == 0xA0 ? "no-break space " : "character ";
        message += utf8::code_point(odd.code);
        message += quote ? " is read as '\"'" : " is read as a blank";
        if (odd.count > 1) message += " (" + std::to_string(odd.count) + " times in this text)";
        report_.warning(quote ? "odd-quote" : "odd-blank", odd.first, std::move(message));
    }
    for (const Span span : lexer_.stray_backslashes())
        report_.warning("stray-backslash", span, "a '\\' in the middle of a line continues nothing");
}

bool is_decimal_comma(std::span<const Token> all, std::size_t i, const Lexer& lexer) {
    if (i == 0 || i + 1 >= all.size() || lexer.text(all[i]) != ",") return false;
    const Token &left = all[i - 1], &right = all[i + 1];
    if (!all[i].glued || !right.glued || !is_whole(lexer.text(left)) || !is_whole(lexer.text(right))) return false;
    const auto joins = [&](std::size_t comma) { return lexer.text(all[comma]) == "," && all[comma + 1].glued; };
    const bool before = i > 1 && left.glued && joins(i - 2);
    const bool after = i + 3 < all.size() && all[i + 2].glued && joins(i + 2);
    return !before && !after && lexer.text(right).front() >= '0';
}

void report_decimal_commas(const Statement& statement, const Lexer& lexer, Collector& report) {
    const std::span<const Token> all = statement.arguments();
    int depth = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        depth += all[i].kind == TokenKind::open ? 1 : all[i].kind == TokenKind::close ? -1 : 0;
        if (depth > 0 || !is_decimal_comma(all, i, lexer)) continue;
        const Token &left = all[i - 1], &right = all[i + 1];
        if (left.glued || (i + 2 < all.size() && all[i + 2].glued)) continue;
        const std::string a(lexer.text(left)), b(lexer.text(right));
        report.warning("decimal-comma", {lexer.file(), left.begin, right.end},
                       "'" + a + "," + b + "' is read as two numbers, " + a + " and " + b,
                       "for one number write a point: " + a + "." + b + "; for two, a blank between them");
    }
}

std::size_t end_of_lines(std::string_view text, std::size_t at) {
    bool continued = false, any = false, comment = false;
    std::size_t end = at;
    for (; end < text.size(); ++end) {
        const char c = text[end];
        if (c == '\n' || c == '\r') {
            if (!continued && !(comment && any)) break;
            if (text.substr(end, 2) == "\r\n") ++end;
            any = true;
            continued = comment = false;
        } else if (c == '#' || text.substr(end, 2) == "//") {
            comment = true;
            end = std::min(text.find_first_of("\r\n", end), text.size()) - 1;
            continued = continued || text[text.find_last_not_of(" \t\v\f", end)] == '\\';
        } else if (c == '\\') {
            continued = true;
        }
    }
    return end;
}

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
