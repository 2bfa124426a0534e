// Inside explain_log: what drivers write, read into one form; no GL here.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/glsl.h"

namespace snell::glsl::log {

// What an entry of a log complains about. Everything not recognised is `other` and keeps the driver's words.
enum class Kind : std::uint8_t {
    undeclared,      // a = name
    no_function,     // a = name
    no_overload,     // a = name, b = argument types ("vec3, float"), may be empty
    few_arguments,   // of a call; a = name, may be empty
    many_arguments,  // likewise
    convert,         // a = from, b = to; either may be empty
    returns,         // a = from, b = to
    operands,        // a = left, b = right; may be empty
    condition,       // not true or false
    constructor_few,
    constructor_many,
    swizzle,     // a = the letters
    redeclared,  // a = name
    read_only,   // a = name, may be empty
    not_constant,
    not_global,     // a = variable or qualifier
    syntax,         // a = unexpected token in the driver's words, may be empty
    end_of_file,    // in the middle of something
    if_unfinished,  // #if without #endif
    no_return,      // a = function
    needs_version,  // a = name, b = version
    no_main,
    no_body,       // a = function
    not_written,   // a = input
    types_differ,  // a = variable
    other,
    noise,  // "2 compilation errors", headlines
};

enum class Driver : std::uint8_t { mesa, nvidia, khronos };  // khronos: AMD, Intel, Apple, ANGLE, glslang

struct Entry {
    Driver driver = Driver::mesa;
    Severity severity = Severity::error;
    int string = -1;  // source string number; -1: the entry names no place
    int line = 0;
    int column = 0;              // of the translated text, as the driver counts; 0: none
    std::optional<Stage> stage;  // named by a headline or the message itself
    std::string text;
    Kind kind = Kind::other;
    std::string a, b;
};

// The entries of a log in its order; candidates of calls and repetitions dropped.
std::vector<Entry> read(std::string_view log);

// Sets kind, a and b from text.
void classify(Entry& entry);

// "4-component vector of float" → "vec4"; other text unchanged.
std::string type_name(std::string_view words);

// ---- the user's text -----------------------------------------------------------------------------------

struct Word {
    std::uint32_t begin = 0, end = 0;
    int line = 1;
    bool name = false;  // identifier or keyword
    bool directive = false;
};

// The words of a shader without comments; `name` or number, or one punctuation character each.
std::vector<Word> words(std::string_view text);

inline std::string_view text_of(std::string_view text, const Word& word) {
    return text.substr(word.begin, word.end - word.begin);
}

struct Declared {
    std::string_view name, qualifier, type;  // qualifier: uniform, in, out, varying, attribute or nothing
    std::uint32_t begin = 0, end = 0;        // of the name
    int line = 1;
    int depth = 0;  // of braces
    int uses = 0;   // besides the declaration
    bool function = false;
};

// What the text declares: variables, parameters, functions, macros; in order.
std::vector<Declared> declared(std::string_view text, const std::vector<Word>& words);

// Words and declarations of the texts that are asked for, read once.
class Texts {
public:
    explicit Texts(const Sources& sources) : sources_(sources) {}
    const std::vector<Word>& words(FileId file);
    std::span<const Word> on_line(FileId file, int line);
    const std::vector<Declared>& declared(FileId file);

private:
    struct View {
        std::vector<Word> words;
        std::optional<std::vector<Declared>> declared;
    };
    View& view(FileId file);
    const Sources& sources_;
    std::map<FileId, View> views_;
};

// The brace that is never closed, judged by indentation; npos if all are.
std::size_t unclosed_brace(std::string_view text);
// The parenthesis that a block begins or ends within, or the text; npos if there is none.
std::size_t unclosed_parenthesis(std::string_view text);

// ---- words for people ----------------------------------------------------------------------------------

// The user's word for one of the translation's: snell_Vertex → gl_Vertex. `user` is the user's text (or the
// line in question), which decides where several words are possible.
std::string user_name(std::string_view translated, std::string_view user);
// The same for every name in a message.
std::string user_words(std::string_view message, std::string_view user);

// What is said of an error of a kind.
struct KindWords {
    Kind kind;
    std::string_view code;
    std::array<std::string_view, 3> messages = {};  // see words.cpp
    std::string_view help = {};                     // where it is the same for all
};
const KindWords& words_of(Kind kind);

// Where an entry stands in the user's text.
struct Place {
    FileId file = 0;
    int line = 0;
    Span span;
    bool known = false;
};

struct Context {
    const Translation& translation;
    const StageOutput* stage;
    Span where;
    const Sources& sources;
    Texts& texts;

    // Whether the stage includes the text more than once.
    bool twice(FileId file) const {
        const auto named = [&](FileId other) { return sources.name(other) == sources.name(file); };
        return stage && std::count_if(stage->files.begin(), stage->files.end(), named) > 1;
    }
};

// An entry that blames what follows an unfinished text turns into one about the end of that text.
Place place(Entry& entry, const Context& context);
// Gives an entry about unnumbered(text) the source string and the line that `text` has there.
void number(Entry& entry, std::string_view text);

// The one-line message in the user's words.
std::string message(const Entry& entry, const Place& place, const Context& context);
// Both for operands whose types are known, whatever the driver said.
std::string message(const Misfit& misfit);
std::string help(const Misfit& misfit);
// Whether a declaration or statement may begin at `offset` of a text.
bool finished(std::string_view text, const std::vector<Word>& words, std::uint32_t offset);
// Fills help and notes of the diagnostic.
void hint(const Entry& entry, const Place& place, const Context& context, Diagnostic& diagnostic);

// Those for what the grammar does not expect.
void hint_syntax(const Place& place, const Context& context, Diagnostic& diagnostic);
void hint_not_global(const Place& place, const Context& context, Diagnostic& diagnostic);
void hint_end_of_file(const Place& place, const Context& context, Diagnostic& diagnostic);

// The stage that a message names, if any.
std::optional<Stage> stage_in(std::string_view text);

}  // namespace snell::glsl::log
