// What editors ask of a scene and its shaders. All take any text, however broken, and any offset; files are those of
// Project::file_of, and spans lie within their texts. Nothing is read but the folder whose files are offered. Answers
// are plain values, with places as bytes of a source. No protocol.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/text/source.h"
#include "src/language/project.h"
#include "src/plan/values/write_back.h"

namespace snell::language {

struct Completion {
    enum class Kind : std::uint8_t {
        command,  // of the language of scenes, with its arguments
        choice,   // a word of an enumeration, a truth value, a rung
        number,   // a value, such as a texture unit
        file,
        folder,
        uniform,
        program,
        function,
        variable,
        constant,  // also macros
        type,
        keyword,
        member,
    };
    std::string label;
    Kind kind = Kind::variable;
    std::string detail;         // one line, such as a signature or a type
    std::string documentation;  // Markdown
    Span replaced;              // what `text` replaces: the word that is being written
    std::string text;
    bool snippet = false;         // `text` has the placeholders of LSP: $1, ${1:radius}, $0; \ $ } are escaped
    int rank = 1;                 // smaller ones first; of equal ones by label
    bool more = false;            // completion continues after it: a folder
    std::vector<Edit> also = {};  // elsewhere in the text, such as the declaration of the uniform
};

struct Hover {
    Span span;                  // of what it explains
    std::string documentation;  // Markdown
    // A file in docs/, such as "images/Sphere.png", which may not be installed, or a path; empty: none.
    std::string picture = {};
};

struct Signature {
    std::string label;
    std::string documentation;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> parameters;  // bytes of the label
};
struct SignatureHelp {
    std::vector<Signature> signatures;
    std::size_t signature = 0, parameter = 0;  // the current ones; `parameter` may be past the last
};

struct Symbol {
    enum class Kind : std::uint8_t {
        pass,
        program,
        uniform,
        ladder,
        rung,
        draw,
        texture,
        include,
        function,
        variable,
        constant,
        structure,
        member,
        macro,
    };
    Kind kind = Kind::variable;
    std::string name, detail;
    Span span, name_span;  // the second is within the first
    std::vector<Symbol> children = {};
};

struct Color {
    Span span;                   // of the numbers, which `color_edits` takes
    std::array<double, 4> rgba;  // within 0 and 1
};

// Where a name can be renamed, or why not.
struct Renaming {
    Span span;            // of the name under the cursor; empty: there is none
    std::string name;     // what it is now
    std::string refused;  // why it can't be renamed; empty: it can
};
struct Rename {
    std::vector<Edit> edits;  // sorted by file and place, each place once
    std::string refused;      // why there are none
};

// The questions.

std::vector<Completion> completions(const Project& project, FileId file, std::uint32_t offset);
std::optional<Hover> hover(const Project& project, FileId file, std::uint32_t offset);
std::optional<SignatureHelp> signature_help(const Project& project, FileId file, std::uint32_t offset);

// The declarations of the name at `offset`; for the name of a file in a statement, the start of that file.
std::vector<Span> definition(const Project& project, FileId file, std::uint32_t offset);
// Every place that names the same, in all files of the project, sorted.
std::vector<Span> references(const Project& project, FileId file, std::uint32_t offset, bool declarations = true);
Renaming renaming(const Project& project, FileId file, std::uint32_t offset);
// Renames what is at `offset`. Afterwards the scene draws the same picture.
Rename rename(const Project& project, FileId file, std::uint32_t offset, std::string_view name);

std::vector<Symbol> symbols(const Project& project, FileId file);
std::vector<Color> colors(const Project& project, FileId file);
// The edits that make the color at `span`, one of colors(), another one, in the author's style of numbers.
std::vector<Edit> color_edits(const Project& project, const Span& span, const std::array<double, 4>& rgba);

// The layout of a scene's text: indentation, and the alignment of lines that continue a statement. Nothing else
// changes: only blanks and tabs at the beginning of lines, and before backslashes that stand below each other.
//
// Statements between RenderToTexture or RenderToCube and the end of the pass, PushMatrix and PopMatrix, glBegin and
// glEnd are indented by four blanks each, if the block ends in the same text. A line that continues a statement begins
// below its first argument, or below what follows an open bracket; backslashes that stand below each other stay so.
// Comments are indented like what surrounds them. Lines of blanks, and statements that are not commands, stay as they
// are.

// Returns what changes, in order and without overlap, each within a line, in the statements and comments that touch the
// bytes begin … end. Any bytes are accepted; nothing changes in UTF-16, and in texts that are too large to be scenes.
std::vector<Edit> layout_edits(std::string_view text, FileId file = 0, std::uint32_t begin = 0,
                               std::uint32_t end = UINT32_MAX);

// The text after all of these. Formatting it again changes nothing, and it reads to the same scene.
std::string formatted(std::string_view text);

}  // namespace snell::language
