// Tokens of one stage after preprocessing, with everything needed to write the text back as it was.
#pragma once

#include <charconv>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "src/glsl/glsl.h"

namespace snell::glsl {

// What a stage computes, as code for a stack machine, which constants are followed through (translate/folding.cpp): the
// light parser writes it while it reads.

enum class Op : unsigned char {
    number,     // pushes `number`; `type`
    load,       // pushes the variable `a`
    unknown,    // pushes something of which nothing is known
    select,     // .text: a member or components
    index,      // value, index → element
    length,     // .length()
    prefix,     // an operator of one operand
    step,       // ++ and --; a: 1 where it stands behind its operand
    infix,      // an operator of two operands
    choose,     // condition ? value : value
    assign,     // target, value → value; text: the operator
    construct,  // a values; `type`
    call,       // a values; text: the name; b: Unit::functions, or -1 where it is declared further down
    built_in,   // the same for a function of the language; `type` is that of the result
    declare,    // the variable a begins; b: with zero (0), with the value (1), with what GLSL leaves undefined (2)
    drop,       // the value of a statement
    jump,       // to a
    unless,     // condition → ; to a where it is false
    back,       // return; a: 1 with a value
    discard,
};

struct Instruction {
    Op op;
    int a = 0, b = 0;
    int type = -1;  // Code::types
    double number = 0;
    std::string_view text;
};

template <class Type>
struct Code {
    bool whole = true;  // false: something was not understood
    std::vector<Instruction> steps;
    std::vector<Type> types;
    std::vector<Type> variables;  // each has one place: GLSL has no recursion
};

enum class Kind : std::uint8_t { identifier, integer, real, punct, other, end };

struct Token {
    Kind kind = Kind::end;
    std::uint16_t file = 0;    // source string: index into Unit::files
    std::uint32_t offset = 0;  // in that file; of the macro's use for what a macro gave
    std::int32_t macro = -1;   // Unit::invocations
    std::int32_t edit = -1;    // Unit::edits
    std::string_view text;
    std::string_view spelled;  // by the user, where `text` is the built-in variable that is meant; else empty
    std::string_view lead;     // what stands before it: blanks, comments, directives
};

// Changes to a token's text; `before` and `after` go around it. A line end only comes with a #line behind it.
struct Edit {
    std::string before, text, after;
    bool replaced = false;
};

struct Extension {
    std::string name, behaviour;
};

// Structure types: members in order. The names are views of the unit's text or of literals.
enum class Base : std::uint8_t { unknown, none, boolean, integer, uinteger, real, dreal, sampler, structure };

struct Type {
    Base base = Base::unknown;
    std::uint8_t rows = 1, cols = 1;  // vec3: rows 3; mat4: rows 4, cols 4
    std::uint8_t dims = 0;            // of arrays
    std::int32_t structure = -1;      // Unit::structs
    std::int32_t size = -1;           // outermost array size, if known
    std::string_view name;            // of the element, as GLSL calls it

    bool scalar() const { return rows == 1 && cols == 1 && dims == 0; }
    bool same(const Type& o) const {
        return base == o.base && rows == o.rows && cols == o.cols && dims == o.dims && structure == o.structure &&
               (base != Base::sampler || name == o.name);
    }
    bool integral() const { return base == Base::integer || base == Base::uinteger; }
    bool floating() const { return base == Base::real || base == Base::dreal; }
    bool numeric() const { return integral() || floating(); }
    // A number, a truth value, or a vector or matrix of them; or an array of these.
    bool basic() const { return base >= Base::boolean && base <= Base::dreal; }
};

struct Member {
    std::string_view name;
    Type type;
};
struct Struct {
    std::string_view name;
    std::vector<Member> members;
};

enum class Storage : std::uint8_t { plain, constant, in, out, inout, uniform, buffer, shared };

struct LayoutItem {
    std::string name, value;
};

struct Qualifiers {
    std::vector<LayoutItem> layout;
    Storage storage = Storage::plain;
    bool constant = false;  // `const` was written, also beside in, out or uniform
    bool varying = false;   // the word varying was used
    bool attribute = false;
    bool directed = false;  // in or out was written, too
    bool invariant = false, precise = false;
    std::string_view interpolation;  // flat, smooth, noperspective
    std::string_view auxiliary;      // centroid, sample, patch
    std::string_view precision;
    std::string memory;         // coherent, readonly …
    int first = -1, last = -1;  // tokens; none: first > last or -1

    // The value that the layout gives a name; empty if it gives none.
    std::string_view layout_value(std::string_view name) const {
        for (const LayoutItem& item : layout)
            if (item.name == name) return item.value;
        return {};
    }
    // The same as a number that is 0 or larger; -1 if there is none.
    int layout_number(std::string_view name) const {
        const std::string_view digits = layout_value(name);
        int n = -1;
        std::from_chars(digits.data(), digits.data() + digits.size(), n);
        return n;
    }
    bool erase_layout(std::string_view name) {
        return std::erase_if(layout, [&](const LayoutItem& item) { return item.name == name; }) > 0;
    }
};

// One declared global variable.
struct Global {
    std::string_view name;
    Type type;  // dims counts all array dimensions
    Qualifiers qualifiers;
    int group = -1;
    int name_token = -1;
    int init_first = -1, init_last = -1;  // tokens of the initialiser
    std::string dims;                     // "[3]" as it will be written
    bool init_constant = true;
    bool init_fits = true;   // unless it can't compile, as far as types are known
    bool dirty = false;      // to be written anew
    bool removed = false;    // its declaration disappears
    bool drop_init = false;  // the initialiser is not written here
    bool read = false, written = false;
    std::string new_type;  // instead of the type's name
    std::string new_name;
    std::string initial;          // what it begins with where the text gives it nothing
    std::vector<double> value;    // of a constant initialiser, where known
    std::vector<int> uses;        // tokens
    int variable = -1;            // Code::variables
    int attribute = -1;           // Attribute: that the runtime gives it
    int most_index = -1;          // of the constants that index an array
    bool indexed_freely = false;  // or something else indexes it
};

// One declaration with one or several declarators, ended by a semicolon.
struct Group {
    int first = -1, last = -1;  // tokens, `;` included
    int type_first = -1, type_last = -1;
    std::vector<int> globals;
    bool defines_struct = false;
};

struct Block {
    Qualifiers qualifiers;
    std::string_view name, instance;
    bool arrayed = false;
    int first = -1, last = -1, open = -1, close = -1;
    std::vector<Member> members;
    int variable = -1;                               // Code::variables: of the instance, or of the first member
    std::vector<std::pair<int, int>> member_tokens;  // each member's tokens, `;` included
};

struct Parameter {
    Type type;
    Storage storage = Storage::in;
    int variable = -1;     // Code::variables
    bool written = false;  // or nobody knows
};

struct Function {
    std::string_view name;
    Type result;
    std::vector<Parameter> parameters;
    int first = -1, parameters_end = -1;  // tokens: of the signature
    int name_token = -1;
    int open = -1, close = -1;     // tokens of the body's braces; -1: a prototype
    bool local = false;            // a prototype within a function
    int code = -1, code_end = -1;  // Code::steps: of the body
    int block = -1;                // of Unit::tree: the body
};

// `layout(…) in;` and `layout(…) out;`
struct StageLayout {
    Qualifiers qualifiers;
    int last = -1;
};

// An expression that is written otherwise in some programs. The text has `snell_markN(` in front of it until that is
// known (read/marks.cpp).
struct Mark {
    enum class Kind : std::uint8_t {
        divisor,   // may be 0
        decision,  // a condition, or the bound of a loop: a number if it is known
        weight,    // of a product or mix(): 0 or 1 if that is known, and what it leaves out is finite
        product,   // with such a weight
        kept,      // a constant of the text that a driver could follow where decisions are made: it does not see it
    };
    Kind kind = Kind::divisor;
    int step = -1;             // of Code::steps: the one whose result it is
    int one = -1, other = -1;  // weight: what 0 leaves out, and what 1 does; product: its weights, of Unit::marks;
                               // kept: the instruction that gives it to a variable
    int last = -1;             // the token that the parenthesis follows; -1: it can't be written otherwise
    bool number = false;       // made of numbers of the text only
    bool known = false;        // and their value is known: a component is 0
};

// A call of EmitStreamVertex or EndStreamPrimitive.
struct StreamCall {
    int first = -1, last = -1;     // tokens, ')' included
    std::optional<double> stream;  // where it is a constant
};

struct Node;

// One stage of a program.
struct Unit {
    Stage stage = Stage::vertex;
    Span reference;
    bool built_in = false;  // ours, where the program names none
    std::vector<FileId> files;
    std::deque<std::string> arena;  // texts that no source holds

    std::vector<Token> tokens;  // the last one is Kind::end
    std::vector<Edit> edits;
    std::vector<std::string_view> invocations;  // of macros, as written: name and arguments
    std::string_view head;                      // what stands before a #version directive
    bool has_version = false;
    int version = 110;
    std::string_view profile;
    int version_line = 1;
    bool verbatim = true;  // macros and conditionals stay in the text
    std::vector<Extension> extensions;
    std::vector<std::string> defined;  // names given by #define anywhere
    bool has_conditionals = false;

    std::vector<Struct> structs;
    std::vector<Global> globals;
    std::vector<Group> groups;
    std::vector<Block> blocks;
    std::vector<Function> functions;
    std::unordered_set<std::string_view> function_names;
    std::vector<StageLayout> layouts;
    std::vector<std::pair<int, int>> redeclared;           // tokens of `invariant A, B;` and `precise A, B;`
    std::unordered_set<std::string_view> shared_by_kinds;  // names of a function and of a variable

    Code<Type> code;
    std::vector<Node>* tree = nullptr;          // filled by the parser if set: read/tree.h
    std::map<std::string_view, int> built_ins;  // Code::variables of the built-in variables that are named
    std::vector<Misfit> misfits;
    std::map<std::string_view, int> unknown_calls;  // functions called before any declaration; first place
    std::vector<Mark> marks;                        // see read/marks.cpp
    std::vector<StreamCall> streams;
    std::set<std::string_view> legacy_written;  // built-in variables that are assigned
    bool alpha_known = false;                   // some write of a colour output gave it alpha 1
    bool alpha_unknown = false;                 // some write may have given it another

    std::string header;      // declarations before the user's text, whole lines
    std::string main_start;  // statements at the start of main
    std::string trailer;     // whole lines after the user's text
    std::vector<std::string> wanted_extensions;

    Edit& edit(int token) {
        Token& t = tokens[static_cast<std::size_t>(token)];
        if (t.edit < 0) {
            t.edit = static_cast<std::int32_t>(edits.size());
            edits.emplace_back();
        }
        return edits[static_cast<std::size_t>(t.edit)];
    }
    void replace(int token, std::string_view text) {
        Edit& e = edit(token);
        e.text = text;
        e.replaced = true;
    }
    // Leaves tokens out; what leads them stays, and with it the lines.
    void erase(int first, int last) {
        for (int k = first; k <= last; ++k) edit(k) = {{}, {}, {}, true};
    }
    // The text of the token as it will be written.
    std::string_view now(int token) const {
        const Token& t = tokens[static_cast<std::size_t>(token)];
        if (t.edit >= 0 && edits[static_cast<std::size_t>(t.edit)].replaced)
            return edits[static_cast<std::size_t>(t.edit)].text;
        return t.text;
    }
    const Struct& structure(const Type& type) const { return structs[static_cast<std::size_t>(type.structure)]; }
    const Token& at(int token) const { return tokens[static_cast<std::size_t>(token)]; }
    Span span(int token) const {
        const Token& t = at(token);
        const FileId file = t.file < files.size() ? files[t.file] : files.front();
        const std::string_view spelled = t.spelled.empty() ? t.text : t.spelled;
        const auto length = static_cast<std::uint32_t>(t.macro < 0 ? spelled.size() : 1);
        return {file, t.offset, t.offset + length};
    }
    std::string_view keep(std::string text) { return arena.emplace_back(std::move(text)); }
};

}  // namespace snell::glsl
