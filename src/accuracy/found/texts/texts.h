// What changes are found in: the author's texts as the parsers read them, with places that can be edited.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/found/change.h"
#include "src/glsl/read/tree.h"

namespace snell::accuracy::texts {

using Edits = std::vector<Edit>;

// Collects changes; each is made of edits of texts that the author may change.
class Collector {
public:
    // At most `most` changes are added.
    Collector(const Files& files, const Sources& sources, std::vector<Change>& changes, std::size_t most);

    // Adds a change unless it has no effect, overlapping edits, an edit of a text that is not the author's, or the
    // edits of another change. Excerpts are of the text at `where`, and at `more`. Returns false if it was not added.
    bool add(ChangeKind kind, Span where, std::vector<Edit> edits, std::string_view lint = {},
             const std::vector<Span>& more = {});
    // True for texts that belong to the scene, false for those that snell itself provides.
    bool author(FileId file) const { return names_.contains(sources_.name(file)); }
    // The same place in the first of several readings of the file.
    Span first_reading(Span span) const;
    std::string_view text(Span span) const {
        return sources_.text(span.file).substr(span.begin, span.end - span.begin);
    }
    bool full() const { return left_ == 0; }
    const Sources& sources() const { return sources_; }

private:
    std::string edited(Span span, const std::vector<Edit>& edits) const;

    const Sources& sources_;
    std::vector<Change>& changes_;
    std::size_t left_;
    std::set<std::string, std::less<>> names_;
};

// ---- scenes -------------------------------------------------------------------------------------------------

// A statement of a scene's text.
struct Statement {
    std::string_view command;     // as in the table of commands; empty: unknown
    Span span, name;              // of all of it; of the command
    std::vector<Span> arguments;  // its words and texts
    bool bracketed = false;       // it has brackets, so that arguments are not in the order of the signature
};

// The statements of the scene and of the texts that it includes, each text once.
std::vector<Statement> statements(const Files& files, const Sources& sources);
// The statement that begins at the place; null if there is none.
const Statement* statement_at(const std::vector<Statement>& all, Span place);
// Whether all files of the texture are there, or of the one that it is computed from.
bool is_there(const Scene& scene, Index texture, const Files& files);
// "\r\n" or "\n", as the text has it.
std::string_view line_end(std::string_view text);

// ---- shaders ------------------------------------------------------------------------------------------------

// An expression.
struct Tree {
    enum class Kind : std::uint8_t {
        other,  // was not understood
        number,
        name,
        call,     // text: the function; parts: arguments
        select,   // text: the member; parts: of what
        index,    // parts: of what, index
        group,    // parts: what is in the brackets
        prefix,   // text: the operator; parts: operand
        postfix,  // text: the operator; parts: operand
        infix,    // text: the operator; parts: operands
        choose,   // parts: condition and the two values
        assign,   // text: the operator; parts: target, value
    };
    Kind kind = Kind::other;
    int first = -1, last = -1;  // tokens
    std::string_view text;
    std::vector<Tree> parts;

    bool is(Kind k, std::string_view t = {}) const { return kind == k && (t.empty() || text == t); }
    bool infix(std::string_view op) const { return is(Kind::infix, op); }
    bool call(std::string_view name, std::size_t arguments) const {
        return is(Kind::call, name) && parts.size() == arguments;
    }
    // A call of one of these functions.
    bool calls(std::initializer_list<std::string_view> names) const {
        return kind == Kind::call && std::find(names.begin(), names.end(), text) != names.end();
    }
};
// The outermost expression that begins at the token; Kind::other if there is none.
Tree expression(const glsl::Unit& unit, int first);
// What is within the brackets around an expression.
const Tree& bare(const Tree& tree);
std::optional<double> number_of(const Tree& tree);
// A number as GLSL writes one of this kind.
std::string numeral(double value, bool whole);
// True if both have the same tokens, brackets around them aside.
bool same(const glsl::Unit& unit, const Tree& a, const Tree& b);

// A part of a function's body that holds one expression.
struct Piece {
    enum class Kind : std::uint8_t { expression, declaration, result, condition };
    Kind kind = Kind::expression;
    int first = -1, last = -1;  // tokens, `;` included
    std::string_view type;      // declaration: as written
    std::string_view name;      // declaration: the variable
    int name_token = -1;
    Tree value;              // Kind::other if a declaration has no initialiser
    int depth = 0;           // of blocks, branches and loops around it
    bool whole = true;       // a declaration of one variable, or another statement that can be left out
    std::vector<int> loops;  // indices into Body::loops, outermost first
};
struct Loop {
    int word = -1;              // for, while, do
    int open = -1, close = -1;  // brackets of the head
};
struct Body {
    const glsl::Function* function = nullptr;
    std::vector<Piece> pieces;
    std::vector<Loop> loops;
    // Of declared variables: the piece that gives one its only value; -1: none does.
    std::map<std::string_view, int> certain;
};
// The functions with a body, in the order of the text.
std::vector<Body> bodies(const glsl::Unit& unit);

// One stage as the translator reads it for the plan's rungs.
struct Shader {
    glsl::Unit unit;
    glsl::Tree tree;              // of the unit, which refers to it
    std::vector<Index> programs;  // that use it
    std::vector<Body> bodies;
};
// A deque, because a unit refers to its texts and its tree.
using Shaders = std::deque<Shader>;
// A scene with the stages of all its programs, equal ones once. `sources` gets the texts of included shaders.
struct Reading {
    Reading(const Plan& plan, Files& files, Sources& sources);

    const Plan& plan;
    Files& files;
    Sources& sources;
    Shaders shaders;
};

// The function around the token; null if there is none.
const Body* body_around(const Shader& shader, int token);
// The declaration of the variable that a name means, if it is a local one that has a value there and is assigned
// nowhere else; null otherwise.
const Piece* declaration_of(const Shader& shader, const Tree& name);
// What a variable has as its value, if that is certain; the tree itself otherwise.
const Tree& resolved(const Shader& shader, const Tree& tree);

// The place of tokens in the author's text; nothing if a macro made them, they are in several texts, or directives are
// between them.
std::optional<Span> span_of(const glsl::Unit& unit, const Collector& to, int first, int last);
inline std::optional<Span> span_of(const glsl::Unit& unit, const Collector& to, const Tree& tree) {
    return span_of(unit, to, tree.first, tree.last);
}
inline Edit before(Span span, std::string text) { return {{span.file, span.begin, span.begin}, std::move(text)}; }
inline Edit after(Span span, std::string text) { return {{span.file, span.end, span.end}, std::move(text)}; }
// Declares a global variable before the function around the token. The edit is empty if the shader has it, and there is
// none if there is no place for it.
std::optional<Edit> declared(const Shader& shader, const Collector& to, int token, std::string_view declaration);
// Includes a file of snell's library, such as "snell/fresnel.glsl". The edit is empty if the shader includes it.
std::optional<Edit> included(const Shader& shader, const Collector& to, std::string_view file);
inline bool adds(const Edit& edit) { return !edit.text.empty(); }
// Calls `each` for the expression and all within it, outermost first.
template <class Each>
void for_each(const Tree& tree, const Each& each) {
    each(tree);
    for (const Tree& part : tree.parts) for_each(part, each);
}

}  // namespace snell::accuracy::texts

namespace snell::accuracy {

// With add_shader_changes the parts of find_changes.
void add_scene_changes(const texts::Reading& reading, std::vector<Change>& changes);
void add_better_changes(const texts::Reading& reading, std::vector<Change>& changes);
void add_omissions(const texts::Reading& reading, std::vector<Change>& changes);

}  // namespace snell::accuracy
