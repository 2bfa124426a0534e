// The statements of a scene as they are written, and which argument a place of them is.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "parser/commands/commands.h"
#include "parser/read/syntax.h"

namespace snell::language {

struct SceneStatement {
    const Command* command = nullptr;    // null: an unknown word
    std::uint32_t first = 0, count = 0;  // of Statements::tokens
};

struct Statements {
    std::string_view text;
    FileId file = 0;
    std::vector<Token> tokens;
    std::vector<SceneStatement> items;
    std::vector<Span> comments;

    std::span<const Token> tokens_of(const SceneStatement& statement) const {
        return std::span(tokens).subspan(statement.first, statement.count);
    }
    std::string_view word(const Token& token) const { return text.substr(token.begin, token.end - token.begin); }
    Span span(const Token& token) const { return {file, token.begin, token.end}; }
    Span span(const SceneStatement& statement) const {
        return {file, tokens[statement.first].begin, tokens[statement.first + statement.count - 1].end};
    }
    // The token that contains the offset or ends there; null if there is none.
    const Token* at(std::uint32_t offset) const;
    bool in_comment(std::uint32_t offset) const;
    // The statement that what is written at the offset belongs to: also behind its last token on the same line, or
    // behind a backslash. Null where a statement may begin.
    const SceneStatement* at_statement(std::uint32_t offset) const;
};

Statements read_statements(FileId file, std::string_view text);

// ---- arguments

// An argument of the statement: one token, or the brackets of a vec3.
struct ArgumentPlace {
    std::size_t alternative = 0;
    const Parameter* parameter = nullptr;  // null: surplus
    std::size_t index = 0;                 // of the parameter in its alternative
    std::size_t component = 0;             // of a vec3
    bool bracketed = false;
};
// The argument that token `token` of the statement (at least 1) is, or would be if it was written there.
ArgumentPlace argument_at(const Statements& statements, const SceneStatement& statement, std::size_t token);
// The same in every alternative that what precedes it fits, the most likely first.
std::vector<ArgumentPlace> arguments_at(const Statements& statements, const SceneStatement& statement,
                                        std::size_t token);

// ---- uniforms of Program statements

// Where a place within the list of uniforms is.
struct UniformPlace {
    enum class Part : std::uint8_t { program, name, value } part = Part::program;
    std::string_view name;   // of the uniform whose value it is; without [n]
    std::size_t number = 0;  // how many numbers of the value precede it
    char bracket = 0;        // the open one; 0: none
};
// `token` as in argument_at().
UniformPlace uniform_at(const Statements& statements, const SceneStatement& statement, std::size_t token);

// A name of a uniform in the text, without [n] and members.
struct WrittenUniform {
    std::string_view name;
    Span name_span;
    std::uint32_t value_begin = 0, value_end = 0;
};
std::vector<WrittenUniform> written_uniforms(const Statements& statements, const SceneStatement& statement);

}  // namespace snell::language
