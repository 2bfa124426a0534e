#include "parser/read/syntax.h"

#include <algorithm>

#include "parser/commands/commands.h"
#include "parser/text/number.h"
#include "parser/text/utf8.h"

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

void report_decimal_commas(const Statement& statement, const Lexer& lexer, Report& report) {
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

}  // namespace snell
