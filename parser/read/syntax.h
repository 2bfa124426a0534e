// Groups tokens into statements: one per line, or more lines continued by backslashes. It tolerates common deviations
// of existing scenes.
#pragma once

#include <span>
#include <vector>

#include "parser/read/lexer.h"
#include "parser/text/report.h"

namespace snell {

struct Statement {
    std::span<const Token> tokens;  // at least one; valid until the next statement is read
    const Token& command() const { return tokens.front(); }
    std::span<const Token> arguments() const { return tokens.subspan(1); }
};

// Whether token i is a comma between the digits of two words, with neither blanks nor further such commas.
bool is_decimal_comma(std::span<const Token> all, std::size_t i, const Lexer& lexer);

// Warns of a comma between two digits outside of brackets, which is read as two numbers. Three and more numbers with
// commas between them are a list.
void report_decimal_commas(const Statement& statement, const Lexer& lexer, Report& report);

// Where the lines of a statement end whose last token ends at `at`: behind comments, and behind lines that a backslash
// adds but that have no token.
std::size_t end_of_lines(std::string_view text, std::size_t at);

class StatementReader {
public:
    StatementReader(std::string_view text, FileId file, Report& report) : lexer_(text, file), report_(report) {}

    // Returns false at the end of the text.
    bool next(Statement& statement);
    // Reports the odd characters of the text, each kind once. Call it after the last statement.
    void report_oddities();

    const Lexer& lexer() const { return lexer_; }
    Span span(const Statement& s) const { return {lexer_.file(), s.tokens.front().begin, s.tokens.back().end}; }

private:
    bool swallows_command(std::size_t first) const;

    Lexer lexer_;
    Report& report_;
    std::vector<Token> tokens_;
};

}  // namespace snell
