// What is wrong near a word that the grammar does not expect: semicolons, brackets, types that are none.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/log/log.h"
#include "src/glsl/read/words.h"

namespace snell::glsl::log {
namespace {

bool is_one_of(std::string_view word, std::string_view list) {
    const std::vector<std::string_view> all = split(list);
    return ranges::find(all, word) != all.end();
}

// `vec5`: no size of such a type is nearer than another.
std::string sizes_of(std::string_view type) {
    if (type.empty() || type.back() < '0' || type.back() > '9') return {};
    const std::string_view family = type.substr(0, type.size() - 1);
    for (const std::string_view one : {"vec", "ivec", "uvec", "bvec", "mat"})
        if (same_word(family, one)) return fmt::format("there are {0}2, {0}3 and {0}4", one);
    return {};
}

// `vex3 a`: two names in a row, of which the first is no type. `first`: they begin a statement.
bool hint_unknown_type(std::string_view type, const Span& span, bool first, Diagnostic& diagnostic) {
    std::string_view meant = type == "real" ? "float" : foreign_type(type);
    std::string help = meant.empty() && !builtin_type(lowered(type)) ? sizes_of(type) : "";
    if (is_one_of(type, "auto let var")) help = "write its type instead: float, vec3 \u2026";
    if (meant.empty() && help.empty()) {
        meant = nearest(type, {"float",       "int",   "uint",    "bool",    "void",      "double",    "vec2",
                               "vec3",        "vec4",  "ivec2",   "ivec3",   "ivec4",     "bvec2",     "bvec3",
                               "bvec4",       "mat2",  "mat3",    "mat4",    "sampler1D", "sampler2D", "sampler3D",
                               "samplerCube", "const", "uniform", "varying", "attribute", "return",    "struct"});
    }
    if (meant == type || (meant.empty() && help.empty() && (!first || builtin_type(type)))) return false;
    diagnostic.message.replace(0, diagnostic.message.find(" ("), fmt::format("'{}' is not a type", type));
    diagnostic.help = meant.empty() ? help : fmt::format("did you mean '{}'?", meant);
    diagnostic.span = span;
    if (!meant.empty()) diagnostic.fixes = {{span, std::string(meant)}};
    return true;
}

bool ends_operand(std::string_view word) {
    const char c = word.empty() ? ' ' : word.back();
    const bool number = c == '.' && word.size() > 1;  // a '.' alone is that of a member
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ')' || c == ']' || number;
}

bool foreign_character(std::string_view word) {
    return !word.empty() && (static_cast<unsigned char>(word[0]) >= 0x80 || word == "$" || word == "@" || word == "`");
}

// The user's text around the unexpected word `at`.
struct Around {
    std::string_view text;
    std::span<const Word> all;
    std::size_t at = 0;
    int parens = 0;     // open ones in the statement so far
    int depth = 0;      // open braces so far
    bool loop = false;  // within the parentheses of a for

    std::string_view word(std::size_t i) const { return i < all.size() ? text_of(text, all[i]) : std::string_view(); }
    std::string_view before() const { return at > 0 ? word(at - 1) : std::string_view(); }
    Span span(FileId file, std::size_t i) const { return {file, all[i].begin, all[i].end}; }
};

// The '{' whose block the last '}' before `at` ended; all.size() if there is none.
std::size_t last_block(const Around& a) {
    std::vector<std::size_t> open;
    std::size_t ended = a.all.size();
    for (std::size_t i = 0; i < a.at; ++i) {
        if (a.all[i].directive) continue;
        if (a.word(i) == "{") open.push_back(i);
        if (a.word(i) != "}" || open.empty()) continue;
        ended = open.back();
        open.pop_back();
    }
    return ended;
}

Around around(std::string_view text, std::span<const Word> all, std::uint32_t offset) {
    Around a;
    a.text = text;
    a.all = all;
    while (a.at < a.all.size() && a.all[a.at].begin < offset) {
        const std::string_view w = a.word(a.at);
        if (!a.all[a.at].directive) a.depth += w == "{" ? 1 : w == "}" ? -1 : 0;
        ++a.at;
    }
    // A ';' within the parentheses of a for ends no statement.
    bool ended = false;
    int open = 0, most = 0;
    for (std::size_t i = a.at; i-- > 0 && !a.loop;) {
        const std::string_view w = a.word(i);
        if (a.all[i].directive || w == "{" || w == "}") break;
        ended = ended || (w == ";" && open >= 0);
        open += w == "(" ? 1 : w == ")" ? -1 : 0;
        if (open > most) a.loop = i > 0 && a.word(i - 1) == "for";
        most = std::max(most, open);
        if (!ended || a.loop) a.parens = open;
    }
    return a;
}

// The last word of the directive that `at` is in, which backslashes lead on from line to line.
std::size_t end_of_directive(const Around& a, std::size_t at) {
    const auto goes_on = [&](std::size_t next) {
        const std::string_view between = a.text.substr(a.all[next - 1].end, a.all[next].begin - a.all[next - 1].end);
        return between.find('\n') == between.npos || between.find('\\') != between.npos;
    };
    while (at + 1 < a.all.size() && a.all[at + 1].directive && goes_on(at + 1)) ++at;
    return at;
}

// A '(' of these words that none of them closes; 0 if there is none.
std::size_t open_parenthesis(const Around& a, std::size_t first, std::size_t last) {
    std::vector<std::size_t> open;
    for (std::size_t i = first; i <= last; ++i) {
        if (a.word(i) == "(") open.push_back(i);
        if (a.word(i) == ")" && !open.empty()) open.pop_back();
    }
    return open.empty() ? 0 : open.back();
}

// `#define PI 3.14;`, `#define PI = 3.14` and `#define PI radians(180.` break the lines that use PI.
bool hint_macro(const Around& a, const Place& place, Diagnostic& diagnostic) {
    for (std::size_t i = 0; i + 1 < a.all.size(); ++i) {
        if (!a.all[i].directive || a.word(i) != "define") continue;
        const std::size_t last = end_of_directive(a, i), open = open_parenthesis(a, i, last);
        const bool assigned = a.word(i + 2) == "=" && i + 2 <= last;
        if (!assigned && a.word(last) != ";" && open == 0) continue;
        const std::size_t surplus = assigned ? i + 2 : last;
        for (const Word& w : a.all) {
            if (w.line != place.line || w.directive || text_of(a.text, w) != a.word(i + 1)) continue;
            diagnostic.span = {place.file, w.begin, w.end};
            if (open > 0) {
                diagnostic.help = fmt::format("the macro '{}' lacks a ')'", a.word(i + 1));
                diagnostic.notes.push_back({a.span(place.file, open), "this '(' is never closed"});
                return true;
            }
            diagnostic.help = fmt::format("the macro '{}' {} a '{}': remove it there", a.word(i + 1),
                                          assigned ? "begins with" : "ends with", a.word(surplus));
            diagnostic.notes.push_back(
                {a.span(place.file, surplus),
                 fmt::format("this '{}' comes along wherever the macro is used", a.word(surplus))});
            diagnostic.fixes = {{a.span(place.file, surplus), ""}};
            return true;
        }
    }
    return false;
}

// Whether the '}' before `at` ends a structure or a block of variables, which a ';' follows.
bool ends_structure(const Around& a) {
    const std::size_t open = a.before() == "}" ? last_block(a) : a.all.size();
    if (open == 0 || open >= a.all.size()) return false;
    const std::string_view kind = open > 1 ? a.word(open - 2) : "";
    return kind == "struct" || a.word(open - 1) == "struct" || kind == "uniform" || kind == "in" || kind == "out";
}

// Tells of a ';' that is missing before `at`, in place of the message if `instead`.
void tell_semicolon(const Around& a, const Place& place, bool instead, Diagnostic& diagnostic) {
    const Word& before = a.all[a.at - 1];
    const Span end{place.file, before.end - 1, before.end};
    constexpr std::string_view missing = "a ';' is missing after this";
    if (instead) {
        diagnostic.message.replace(0, diagnostic.message.find(" ("), missing);
        diagnostic.span = end;
        diagnostic.help = a.before() == "}" ? "the '}' of a struct or a block of variables is followed by a ';'" : "";
    } else {
        diagnostic.notes.push_back({end, std::string(missing)});
    }
    diagnostic.fixes = {{{place.file, before.end, before.end}, ";"}};
}

// `float f(float x)` without its '{': what follows is a statement and no declaration that stands outside of functions.
bool hint_body(const Around& a, Diagnostic& diagnostic) {
    if (a.depth > 0 || a.before() != ")" || a.parens != 0 || !a.all[a.at].name) return false;
    std::size_t open = a.at - 1;
    for (int count = 0; open > 0; --open) {
        count += a.word(open) == ")" ? 1 : a.word(open) == "(" ? -1 : 0;
        if (count == 0) break;
    }
    if (open < 2 || !a.all[open - 1].name || !a.all[open - 2].name) return false;
    const std::string_view here = a.word(a.at);
    const bool declares = builtin_type(here) || is_one_of(here, "void uniform varying attribute in out const struct");
    const bool local = a.at + 2 < a.all.size() && a.word(a.at + 2) != "(" && builtin_type(here);
    if (declares && !local) return false;
    diagnostic.help = fmt::format("a '{{' is missing before '{}'", here);
    return true;
}

// `vec3 n = normalize(vN) vec3 i`: whether a declaration begins at `at`, in the line of the value before it.
bool declares_after_value(const Around& a) {
    if (a.depth == 0 || a.parens != 0 || a.at + 1 >= a.all.size() || !a.all[a.at + 1].name) return false;
    if (!builtin_type(a.word(a.at)) || !ends_operand(a.before()) || a.all[a.at - 1].line != a.all[a.at].line)
        return false;
    int open = 0;
    for (std::size_t i = a.at; i-- > 1 && !is_one_of(a.word(i), "; { }");) {
        open += a.word(i) == ")" ? 1 : a.word(i) == "(" ? -1 : 0;
        const bool called = a.word(i) == "(" && a.all[i - 1].name && !is_one_of(a.word(i - 1), "if while switch");
        if (open == 0 && (called || a.word(i) == "=") && i + 1 < a.at) return true;
    }
    return false;
}

bool hint_semicolon(Around a, const Place& place, Diagnostic& diagnostic) {
    const int line = a.all[a.at].line;
    const bool opens = a.word(a.at) == "{";
    while (a.at > 0 && a.all[a.at - 1].directive) {
        // What comes before the end of a branch may not be compiled.
        if (const std::string_view word = a.word(--a.at); word == "endif" || word == "else" || word == "elif")
            return false;
    }
    // Names on the next line may be variables of the structure: what follows them is blamed.
    Around earlier = a;
    while (earlier.at > 0 && earlier.all[earlier.at - 1].name) --earlier.at;
    if (ends_structure(earlier) && earlier.all[earlier.at - 1].line < earlier.all[earlier.at].line) a = earlier;
    const bool structure = ends_structure(a);
    if (a.at == 0 || a.parens != 0 || opens || !(structure || ends_operand(a.before()))) return false;
    const Word& before = a.all[a.at - 1];
    const bool new_line = before.line < line;
    if (!new_line && !structure && a.word(a.at) != "}" && !declares_after_value(a)) return false;
    diagnostic.help = new_line ? fmt::format("line {} seems to lack a ';' at its end", before.line)
                               : fmt::format("a ';' is missing before '{}'", a.word(a.at));
    tell_semicolon(a, place, structure || diagnostic.message.starts_with("syntax error ("), diagnostic);
    return true;
}

// A brace before the place that is never closed.
bool hint_brace(const Place& place, std::string_view text, Diagnostic& diagnostic) {
    const std::size_t brace = unclosed_brace(text);
    if (brace == std::string_view::npos || brace >= place.span.begin) return false;
    const auto offset = static_cast<std::uint32_t>(brace);
    diagnostic.notes.push_back({{place.file, offset, offset + 1}, "this '{' is never closed"});
    return true;
}

bool hint_brackets(const Around& a, const Place& place, Diagnostic& diagnostic) {
    const std::string_view here = a.word(a.at);
    if (a.loop && here != ";" && here != "{") {
        diagnostic.help = "the three parts of a 'for' are separated by ';'";
    } else if ((here == ";" || here == "{") && a.parens > 0) {
        diagnostic.help = fmt::format("a ')' is missing before the '{}'", here);
        const std::uint32_t end = a.all[a.at - 1].end;  // an open parenthesis is before it
        diagnostic.fixes = {{{diagnostic.span.file, end, end}, ")"}};
    } else if (a.parens < 0 || (here == ")" && a.parens == 0)) {
        diagnostic.help = "there are more ')' than '('";
    } else if (here == "{" && a.before() == ")" && a.depth > 0) {
        diagnostic.help = "a function cannot be defined inside another one: is a '}' missing above?";
        hint_brace(place, a.text, diagnostic);
    } else if (here == "{" && a.depth == 0 && ends_operand(a.before()) && a.before() != ")") {
        diagnostic.help = fmt::format("a function needs parentheses: {}()", a.before());
    } else {
        return false;
    }
    return true;
}

bool hint_character(Span span, std::string_view text, Diagnostic& diagnostic) {
    if (!foreign_character(text.substr(span.begin, 1))) return false;
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
    while (span.end < text.size() && continues(text[span.end])) ++span.end;
    diagnostic.span = span;
    diagnostic.message.replace(0, diagnostic.message.find(" ("), "a character that GLSL does not know");
    diagnostic.help = "was it pasted from elsewhere? type it again";
    return true;
}

// Whether the word at `at` follows an operand within an expression: an operator is missing.
bool second_operand(const Around& a, bool number) {
    if (a.at < 2 || !ends_operand(a.before()) || a.all[a.at - 1].line != a.all[a.at].line) return false;
    if (number) return a.parens > 0;
    if (a.depth == 0 && a.before() == ")") return false;  // of a layout
    if (!a.all[a.at].name || builtin_type(a.word(a.at)) || is_one_of(a.word(a.at - 2), "( ; { } ,")) return false;
    bool value = a.parens > 0;
    for (std::size_t i = a.at; i-- > 0 && !value && !is_one_of(a.word(i), "; { }");)
        value = a.word(i) == "=" || (a.word(i) == "return" && i + 1 < a.at);
    return value && a.before() != "return";
}

bool is_number(std::string_view word) {
    return std::isdigit(static_cast<unsigned char>(word[0])) != 0 || (word[0] == '.' && word.size() > 1);
}

// Whether the word at `at` is an operand, or begins a declaration, right after another operand.
bool after_operand(const Around& a) {
    return (second_operand(a, is_number(a.word(a.at))) && !builtin_type(a.before())) || declares_after_value(a);
}

// The first such word in the line of `a.at`; `word`: that is this one, if it is not empty.
std::optional<std::size_t> operand_in_line(const Around& a, std::string_view word) {
    for (std::size_t i = 0; i < a.all.size(); ++i)
        if (a.all[i].line == a.all[a.at].line && (word.empty() || a.word(i) == word) &&
            after_operand(around(a.text, a.all, a.all[i].begin)))
            return i;
    return std::nullopt;
}

// Two operands, or a sign too many, where one word says what was meant.
bool hint_words(const Around& a, const Place& place, Diagnostic& diagnostic) {
    const std::string_view here = a.word(a.at), next = a.word(a.at + 1), before = a.before();
    for (const Word& w : a.all)
        if (const std::string_view word = text_of(a.text, w);
            w.line == place.line && (word == "elseif" || word == "elif" || word == "elsif")) {
            diagnostic.span = {place.file, w.begin, w.end};
            diagnostic.help = "did you mean 'else if'?";
            diagnostic.fixes = {{diagnostic.span, "else if"}};
            return true;
        }
    const bool name = a.at > 0 && a.all[a.at - 1].name;
    const bool number = is_number(here);
    if (here == "=" && next == "=" && name && a.parens == 0) {
        diagnostic.help = "'==' compares; '=' gives a value";
        diagnostic.fixes = {{{place.file, a.all[a.at].begin, a.all[a.at + 1].end}, "="}};
    } else if (number && a.at > 1 && name && a.all[a.at - 2].name && builtin_type(a.word(a.at - 2))) {
        diagnostic.help = fmt::format("a '=' is missing before '{}'", here);
        diagnostic.fixes = {{{place.file, a.all[a.at].begin, a.all[a.at].begin}, "= "}};
    } else if (a.all[a.at].name && next == "(" && a.depth == 0 && (before == ";" || before == "}" || a.at == 0)) {
        diagnostic.help = fmt::format("the type of what it returns comes before a function's name: float {}(…)", here);
    } else if (a.all[a.at].name && name && a.at > 1 && builtin_type(a.word(a.at - 2)) && !builtin_type(before) &&
               a.all[a.at - 1].line == a.all[a.at].line && !second_operand(a, number)) {
        diagnostic.help = fmt::format("a ',' is missing before '{}'", here);
        const std::uint32_t end = a.all[a.at - 1].end;
        diagnostic.fixes = {{{place.file, end, end}, ","}};
    } else if (second_operand(a, number)) {
        diagnostic.help = builtin_function(before)
                              ? fmt::format("what a function is given stands in ( ): {}(…)", before)
                              : fmt::format("an operator or a ',' is missing before '{}'", here);
    } else {
        return false;
    }
    return true;
}

// Words and signs of other languages.
bool hint_foreign(const Around& a, Diagnostic& diagnostic) {
    const std::string_view here = a.word(a.at), next = a.word(a.at + 1), before = a.before();
    constexpr std::pair<std::string_view, std::string_view> words[] = {
        {"and", "'&&' joins conditions"},
        {"or", "'||' joins conditions"},
        {"not", "'!' turns a condition round"},
        {"then", "remove 'then': what is done follows the condition"}};
    for (const auto& [word, help] : words)
        if (here == word || before == word) diagnostic.help = help;
    if (here == ":" && next == "=") diagnostic.help = "'=' gives a value";
    if (here == "*" && before == "*") diagnostic.help = "pow(x, y) is a power";
    if (here == "version" && a.at == 0) diagnostic.help = fmt::format("a '#' is missing: #version {}", next);
    for (const std::string_view word : {"if", "while", "for", "switch"})
        if (before == word && here != "(") {
            diagnostic.message.replace(0, diagnostic.message.find(" ("),
                                       fmt::format("parentheses are missing after '{}'", word));
            diagnostic.help = fmt::format("write {} (…)", word);
        }
    return !diagnostic.help.empty();
}

// A '?' that chooses nothing is a template's.
bool hint_template(const Around& a, const Place& place, Diagnostic& diagnostic) {
    for (std::size_t i = 1; i < a.all.size(); ++i) {
        if (a.all[i].line != place.line || a.word(i) != "?" || ends_operand(a.word(i - 1))) continue;
        diagnostic.span = a.span(place.file, i);
        diagnostic.message.replace(0, diagnostic.message.find(" ("), "this '?' was never filled in");
        diagnostic.help = "write what belongs there";
        return true;
    }
    return false;
}

}  // namespace

void hint_not_global(const Place& place, const Context& context, Diagnostic& diagnostic) {
    diagnostic.help = "declare it above the function";
    if (place.known && hint_brace(place, context.sources.text(place.file), diagnostic))
        diagnostic.help = "is a '}' missing above?";
}

bool finished(std::string_view text, const std::vector<Word>& words, std::uint32_t offset) {
    const Around a = around(text, words, offset);
    const std::string_view last = a.before();
    return last.empty() || last == ";" || last == "{" || (last == "}" && !ends_structure(a));
}

void hint_syntax(const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    const std::string_view text = context.sources.text(place.file);
    Around a = around(text, context.texts.words(place.file), place.span.begin);
    if (a.at < a.all.size()) {
        // Where the compiler names no word, the place is that of the whole line; its column may be that of another such
        // word.
        const bool unnamed = diagnostic.message.starts_with("syntax error (");
        const auto found =
            unnamed || !after_operand(a) ? operand_in_line(a, unnamed ? "" : a.word(a.at)) : std::nullopt;
        if (found) {
            a = around(text, context.texts.words(place.file), a.all[*found].begin);
            diagnostic.span = a.span(place.file, a.at);
        }
        if (hint_character(a.span(place.file, a.at), text, diagnostic)) return;
        if (hint_template(a, place, diagnostic)) return;
        if (hint_macro(a, place, diagnostic) || hint_body(a, diagnostic)) return;
        if (hint_semicolon(a, place, diagnostic)) return;
        if (hint_foreign(a, diagnostic) || hint_words(a, place, diagnostic)) return;
        const bool two_names =
            a.at > 0 && a.all[a.at - 1].name && a.all[a.at].name && a.all[a.at - 1].line == a.all[a.at].line;
        const std::string_view ahead = a.at > 1 ? a.word(a.at - 2) : std::string_view();
        const bool first = (ahead.empty() || ahead == ";" || ahead == "{" || ahead == "}") &&
                           ranges::none_of(context.texts.declared(place.file),
                                           [&](const Declared& d) { return d.name == a.before(); });
        if (two_names && hint_unknown_type(a.before(), a.span(place.file, a.at - 1), first, diagnostic)) return;
        if (a.all[a.at].name && a.at + 1 < a.all.size() && a.all[a.at + 1].name &&
            a.all[a.at + 1].line == a.all[a.at].line &&
            hint_unknown_type(a.word(a.at), a.span(place.file, a.at), false, diagnostic))
            return;
        if (hint_brackets(a, place, diagnostic)) return;
    }
    if (!hint_brace(place, text, diagnostic) && a.word(a.at) == "}" && a.depth <= 0) {
        diagnostic.help = "there are more '}' than '{'";
        if (const std::size_t block = last_block(a); block < a.all.size())
            diagnostic.help +=
                fmt::format(": the one before it ends the block that begins in line {}", a.all[block].line);
    }
}

void hint_end_of_file(const Place& place, const Context& context, Diagnostic& diagnostic) {
    if (!place.known) return;
    const std::string_view text = context.sources.text(place.file);
    const std::size_t brace = unclosed_brace(text);
    const std::size_t open = brace == std::string_view::npos ? unclosed_parenthesis(text) : brace;
    if (open == std::string_view::npos) {
        // Some compilers stop at the first character that they do not know.
        for (const Word& w : context.texts.words(place.file))
            if (hint_character({place.file, w.begin, w.end}, text, diagnostic)) return;
        const Around a = around(text, context.texts.words(place.file), place.span.end);
        if (ends_structure(a) || (ends_operand(a.before()) && a.before() != ")" && a.parens == 0))
            return tell_semicolon(a, place, true, diagnostic);
        diagnostic.help = "the last statement lacks its end: a ';', a ')' or a body in { }";
        return;
    }
    const auto offset = static_cast<std::uint32_t>(open);
    diagnostic.notes.push_back({diagnostic.span, "the text ends here"});
    diagnostic.span = {place.file, offset, offset + 1};
    diagnostic.message.replace(0, diagnostic.message.find(" ("),
                               "this '" + std::string(text.substr(open, 1)) + "' is never closed");
    diagnostic.help = brace == std::string_view::npos ? "close it with ')'" : "close it with '}'";
}

}  // namespace snell::glsl::log
