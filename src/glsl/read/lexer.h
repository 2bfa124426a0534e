// Characters to tokens of GLSL, one at a time, with the cleaning of what is no GLSL text; and texts to the tokens that
// count.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl {

struct Cleaned {
    std::string text;         // as long as the original: offsets stay
    bool odd_blanks = false;  // there were no-break spaces or the like
    std::uint32_t first_odd = 0;
};
// Byte-order marks, no-break and other exotic spaces, and control characters become blanks; a backslash
// followed by blanks at the end of a line moves to the end, but for comments `//`, whose next line it would hide.
Cleaned clean(std::string_view text);

// The end of the blanks and comments that start at `from`; a newline counts as blank.
struct Trivia {
    std::size_t end = 0;
    bool line_end = false;  // outside of comments
};
Trivia skip_trivia(std::string_view text, std::size_t from);
// The end of the line of the comment `//` at or before `i`, and of those that a backslash at its end adds to it.
std::size_t line_comment_end(std::string_view text, std::size_t i);
// The end of the line of the directive at `i`, continuations and comments included.
std::size_t directive_end(std::string_view text, std::size_t i);
// The token that starts at `from`, which is no blank. Of kind end at the end of the text.
struct Lexeme {
    Kind kind = Kind::end;
    std::string_view text;
};
Lexeme lex(std::string_view text, std::size_t from);

bool identifier_start(char c);
bool identifier_part(char c);
bool blank(char c);
// How often the word is in the text, without those that are a part of another.
std::size_t count_word(std::string_view text, std::string_view word);
inline bool has_word(std::string_view text, std::string_view word) { return count_word(text, word) > 0; }

// A name that follows `include` in its line: of a file, or in angle brackets of a text of snell's library.
struct IncludeName {
    std::string_view name;
    bool angle = false;
};
// Those in comments and in branches that are never compiled count, too. Lines that are no directives do no harm.
std::vector<IncludeName> included_names(std::string_view text);
// What helps where a text of that name declares its names again.
std::string included_twice(std::string_view name);

// Directives, macros and includes: from source texts to the tokens that count.

// Fills tokens, files, head, version and extensions of a unit whose stage is set. The text stays as written
// wherever possible: directives and dead groups become the lead of the token after them, a macro's use keeps
// its spelling beside its expansion. Where that can't be (a condition on __VERSION__ or GL_…, whose value the
// driver would judge otherwise; a macro that redefines a word of the language), `verbatim` is false, and
// directives and dead groups turn into empty lines, and macros into their expansion; so also where the caller has set
// `verbatim` to false.
void preprocess(Unit& unit, FileId file, Sources& sources, const Options& options, Diagnostics& diagnostics);

// What marks the place of extension directive n in a lead.
inline constexpr char extension_mark = '\x01';

}  // namespace snell::glsl
