// A shader as it is written: its words with what they mean, in every branch of its conditionals, however broken it is.
// The translator reads what a driver compiles (src/glsl/read); an editor shows and renames all of the text.
#pragma once

#include <cstdint>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "parser/text/source.h"
#include "src/glsl/read/token.h"

namespace snell::language {

struct ShaderToken {
    enum class Role : std::uint8_t {
        other,     // an operator, a number
        word,      // of the language: a keyword, a type, an identifier of a layout
        global,    // a name of the program: also functions, macros, structures
        local,     // `declaration` is its own
        member,    // of a structure or a block
        directive  // the word behind the #
    };
    glsl::Kind kind = glsl::Kind::other;
    Role role = Role::other;
    bool in_directive = false;
    bool declares = false;
    std::uint32_t begin = 0, end = 0;
    std::int32_t declaration = -1;  // Outline::declarations: what a local name means, or what a token declares
};

struct ShaderDeclaration {
    enum class Kind : std::uint8_t {
        uniform,
        input,
        output,
        varying,
        variable,
        constant,
        parameter,
        function,
        structure,
        member,
        block,
        macro
    };
    Kind kind = Kind::variable;
    bool local = false;  // of a function, or a parameter of a macro
    bool body = false;   // of a function that is defined here
    std::string_view name;
    std::string_view type;    // as it is written, without qualifiers; of macros: their parameters
    std::string_view owner;   // of a member: its structure
    std::uint32_t token = 0;  // of the name
    std::uint32_t begin = 0;  // offset of the declaration's first word
    std::uint32_t end = 0;    // offset behind it: of a function's body, otherwise of the declarator
    std::uint32_t visible_from = 0, visible_to = 0;          // offsets
    std::uint32_t parameters_begin = 0, parameters_end = 0;  // of functions: offsets between the parentheses
    bool array = false;
};

struct ShaderDirective {
    std::uint32_t begin = 0, end = 0;
    std::string_view word, rest;                 // `rest` without surrounding blanks
    std::uint32_t name_begin = 0, name_end = 0;  // of #include: the name between its quotes or angle brackets
};

struct Outline {
    std::string_view text;
    FileId file = 0;
    std::vector<ShaderToken> tokens;
    std::vector<Span> comments;
    std::vector<ShaderDirective> directives;
    std::vector<ShaderDeclaration> declarations;
    std::vector<Span> braces;  // of { … } of several lines
    bool pastes = false;       // a macro joins names by ##
    bool splits = false;       // a name continues on the next line

    std::string_view word(const ShaderToken& token) const { return text.substr(token.begin, token.end - token.begin); }
    Span span(const ShaderToken& token) const { return {file, token.begin, token.end}; }
    // The place of its name.
    Span span(const ShaderDeclaration& declaration) const { return span(tokens[declaration.token]); }
    // Of a token that declares something, or means something local.
    const ShaderDeclaration& declaration(const ShaderToken& token) const {
        return declarations[static_cast<std::size_t>(token.declaration)];
    }
    // The token that contains the offset or ends there; a name wins over an operator. Null in blanks and comments.
    const ShaderToken* at(std::uint32_t offset) const;
    // The number of tokens that begin before the offset.
    std::size_t before(std::uint32_t offset) const;
    bool in_comment(std::uint32_t offset) const;
    // The directive whose line has the offset; null if there is none.
    const ShaderDirective* directive_at(std::uint32_t offset) const;
    // True if the offset is within the body of a function.
    bool in_body(std::uint32_t offset) const;
    // The tokens that mean the global `name`.
    const std::vector<std::uint32_t>& uses(std::string_view name) const;

    std::unordered_map<std::string_view, std::vector<std::uint32_t>> globals;  // tokens by name
};

Outline read_outline(FileId file, std::string_view text);
// The part of it that finds the declarations outside of directives, and what every name means (resolver.cpp).
void resolve_names(Outline& outline);

}  // namespace snell::language
