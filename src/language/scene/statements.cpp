#include "src/language/scene/statements.h"

#include <algorithm>

namespace snell::language {

namespace {

bool line_end(char c) { return c == '\n' || c == '\r'; }

// Between tokens there are only blanks, backslashes and comments.
void find_comments(Statements& found) {
    std::uint32_t from = 0;
    const auto within = [&](std::uint32_t end) {
        const std::string_view text = found.text;
        for (std::uint32_t i = from; i < end;) {
            const bool begins = text[i] == '#' || (text[i] == '/' && text.substr(i, 2) == "//");
            std::uint32_t close = i + 1;
            if (begins) {
                while (close < end && !line_end(text[close])) ++close;
                found.comments.push_back({found.file, i, close});
            }
            i = close;
        }
    };
    for (const Token& token : found.tokens) {
        within(token.begin);
        from = token.end;
    }
    within(static_cast<std::uint32_t>(found.text.size()));
}

}  // namespace

Statements read_statements(FileId file, std::string_view text) {
    Statements found;
    found.text = text;
    found.file = file;
    Collector unheard(0);
    StatementReader reader(text, file, unheard);
    Statement statement;
    while (reader.next(statement)) {
        const auto first = static_cast<std::uint32_t>(found.tokens.size());
        found.tokens.insert(found.tokens.end(), statement.tokens.begin(), statement.tokens.end());
        const Token& command = statement.command();
        found.items.push_back({command.kind == TokenKind::word ? find_command(reader.lexer().text(command)) : nullptr,
                               first, static_cast<std::uint32_t>(statement.tokens.size())});
    }
    find_comments(found);
    return found;
}

const Token* Statements::at(std::uint32_t offset) const {
    const auto next = std::upper_bound(tokens.begin(), tokens.end(), offset,
                                       [](std::uint32_t at, const Token& token) { return at < token.begin; });
    if (next == tokens.begin()) return nullptr;
    const Token& token = *std::prev(next);
    if (token.begin == offset && token.kind != TokenKind::word && next != std::next(tokens.begin())) {
        const Token& left = *std::prev(next, 2);  // a word that ends at a bracket
        if (left.end == offset && left.kind == TokenKind::word) return &left;
    }
    return token.end >= offset ? &token : nullptr;
}

bool Statements::in_comment(std::uint32_t offset) const {
    const auto next = std::lower_bound(comments.begin(), comments.end(), offset,
                                       [](const Span& comment, std::uint32_t at) { return comment.begin < at; });
    return next != comments.begin() && std::prev(next)->end >= offset;
}

const SceneStatement* Statements::at_statement(std::uint32_t offset) const {
    const auto next = std::upper_bound(
        items.begin(), items.end(), offset,
        [&](std::uint32_t at, const SceneStatement& statement) { return at < tokens[statement.first].begin; });
    if (next == items.begin()) return nullptr;
    const SceneStatement& statement = *std::prev(next);
    const std::uint32_t end = tokens[statement.first + statement.count - 1].end;
    return offset <= end_of_lines(text, end) ? &statement : nullptr;
}

}  // namespace snell::language
