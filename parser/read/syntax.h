// Text to tokens, and tokens to statements: one per line, or more lines continued by backslashes. Common deviations of
// existing scenes are tolerated.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"

namespace snell {

// Splits text into tokens, one line at a time. Tokens are offsets into the text; nothing is copied.

enum class TokenKind : std::uint8_t {
    word,
    text,   // "…"; the span includes the quotes
    open,   // < [ { (
    close,  // > ] } )
    comma,  // or a semicolon
};

struct Token {
    TokenKind kind = TokenKind::word;
    bool glued = false;       // follows the previous token without a blank
    bool line_start = false;  // the first token of its line
    bool unclosed = false;    // a text without its closing quote
    std::uint32_t begin = 0, end = 0;
};

struct Line {
    bool at_end = false;             // the end of the text was reached
    bool continued = false;          // ended by a backslash
    bool comment = false;            // contains a comment
    bool comment_continued = false;  // the backslash is inside of the comment
};

// A character that resembles another one. The lexer reads it as that one; it is reported once per text.
struct OddCharacter {
    char32_t code = 0;
    std::uint32_t count = 0;
    Span first;
};

class Lexer {
public:
    // `text` must outlive the lexer.
    Lexer(std::string_view text, FileId file);

    // Appends the tokens of the line that begins at position(), and advances to the next line.
    Line read_line(std::vector<Token>& tokens);
    // Must be called before the first line of a statement. It forgets brackets that the previous statement left open.
    void begin_statement() { depth_ = 0; }

    std::size_t position() const { return at_; }
    void rewind(std::size_t position) { at_ = position; }
    bool at_end() const { return at_ >= text_.size(); }

    std::string_view text() const { return text_; }
    std::string_view text(const Token& token) const { return text_.substr(token.begin, token.end - token.begin); }
    FileId file() const { return file_; }
    Span span(const Token& token) const { return {file_, token.begin, token.end}; }

    const std::vector<OddCharacter>& odd_characters() const { return odd_; }
    const std::vector<Span>& stray_backslashes() const { return stray_; }

private:
    void word(std::vector<Token>& tokens, Token token);
    bool ends_word(std::size_t at) const;
    void quoted(std::vector<Token>& tokens, Token token, std::uint32_t quote_length);
    void comment(Line& line);
    void mark(std::vector<Token>& tokens, Token token, TokenKind kind, int deeper);
    void backslash(std::vector<Token>& tokens, Token token, Line& line);
    void high(std::vector<Token>& tokens, Token token);
    std::size_t end_of_backslashes(std::size_t at) const;
    bool blank(std::size_t at) const;
    bool ends_line(std::size_t at) const;
    void note_odd(char32_t code, std::size_t at, std::uint32_t length);

    std::string_view text_;
    FileId file_;
    std::size_t at_ = 0;
    int depth_ = 0;
    std::vector<OddCharacter> odd_;
    std::vector<Span> stray_;
};

// Groups tokens into statements: one per line, or more lines continued by backslashes. It tolerates common deviations
// of existing scenes.

struct Statement {
    std::span<const Token> tokens;  // at least one; valid until the next statement is read
    const Token& command() const { return tokens.front(); }
    std::span<const Token> arguments() const { return tokens.subspan(1); }
};

// Whether token i is a comma between the digits of two words, with neither blanks nor further such commas.
bool is_decimal_comma(std::span<const Token> all, std::size_t i, const Lexer& lexer);

// Warns of a comma between two digits outside of brackets, which is read as two numbers. Three and more numbers with
// commas between them are a list.
void report_decimal_commas(const Statement& statement, const Lexer& lexer, Collector& report);

// Where the lines of a statement end whose last token ends at `at`: behind comments, and behind lines that a backslash
// adds but that have no token.
std::size_t end_of_lines(std::string_view text, std::size_t at);

class StatementReader {
public:
    StatementReader(std::string_view text, FileId file, Collector& report) : lexer_(text, file), report_(report) {}

    // Returns false at the end of the text.
    bool next(Statement& statement);
    // Reports the odd characters of the text, each kind once. Call it after the last statement.
    void report_oddities();

    const Lexer& lexer() const { return lexer_; }
    Span span(const Statement& s) const { return {lexer_.file(), s.tokens.front().begin, s.tokens.back().end}; }

private:
    bool swallows_command(std::size_t first) const;

    Lexer lexer_;
    Collector& report_;
    std::vector<Token> tokens_;
};

}  // namespace snell
