// Parses the uniforms of Program lines: names and values.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "parser/read/syntax.h"
#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/limits.h"

namespace snell {

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
