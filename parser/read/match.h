// Matches statements with the signatures of their commands, which gives their arguments; the uniforms of Program lines
// have a syntax of their own.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/commands/commands.h"
#include "parser/read/syntax.h"
#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/limits.h"

namespace snell {

struct Argument {
    double number = 0;        // number and integer: the value; choice: its index
    std::string_view text;    // path, name, choice, rest; without quotes
    std::uint32_t first = 0;  // vec3: index into Arguments::numbers
    std::uint32_t count = 0;  // vec3: how many numbers were given, 3 or 4
    bool given = false;
    Span span;  // of the whole statement if the argument was not given
};

// The arguments of one statement; the object is reused for the next.
class Arguments {
public:
    std::size_t alternative() const { return alternative_; }
    std::size_t size() const { return size_; }  // parameters of the alternative, then the repeated ones
    const Argument& operator[](std::size_t i) const { return i < arguments_.size() ? arguments_[i] : nothing_; }
    double number(std::size_t i) const { return (*this)[i].number; }
    int integer(std::size_t i) const { return static_cast<int>((*this)[i].number); }
    std::string_view text(std::size_t i) const { return (*this)[i].text; }
    std::span<const double> numbers(std::size_t i) const {
        return std::span(numbers_).subspan((*this)[i].first, (*this)[i].count);
    }
    std::array<double, 3> vec3(std::size_t i) const {
        const std::span<const double> all = numbers(i);
        return {all.size() > 0 ? all[0] : 0, all.size() > 1 ? all[1] : 0, all.size() > 2 ? all[2] : 0};
    }
    bool given(std::size_t i) const { return (*this)[i].given; }
    Span span() const { return span_; }
    Span span(std::size_t i) const { return (*this)[i].span; }
    // True if a number replaces a word that is not one, which is an error in the report.
    bool mended() const { return mended_; }
    // The tokens of the statement, for arguments with a syntax of their own (uniforms).
    const Lexer& lexer() const { return *lexer_; }
    std::span<const Token> tokens() const { return statement_.tokens; }

private:
    friend class Matcher;

    std::vector<Argument> arguments_;
    std::vector<double> numbers_;
    std::string joined_;  // text of a `rest` argument that spans several lines
    Argument nothing_;
    std::size_t alternative_ = 0, size_ = 0;
    bool mended_ = false;
    Span span_;
    const Lexer* lexer_ = nullptr;
    Statement statement_;
};

// Returns false and reports an error if the statement does not fit the signature.
bool match(const Command& command, const Statement& statement, const StatementReader& reader, Collector& report,
           Arguments& arguments);

// Parses the uniforms of Program lines: names and values.

struct UniformList {
    std::string program;  // the words before the first uniform, if requested
    std::vector<UniformValue> uniforms;
};

// Parses `name value name value …`, preceded by the program's name if `named`. Returns everything that can be
// understood and reports the rest.
UniformList read_uniforms(std::span<const Token> tokens, const Lexer& lexer, Collector& report, const Limits& limits,
                          bool named);

// True if the tokens look like a uniform and its value rather than a command, such as `uSc <0. .5 1.>`, or like
// `several`.
bool looks_like_uniform(std::span<const Token> tokens, const Lexer& lexer, bool several);

}  // namespace snell
