// Names and values of uniforms, as Program lines list them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "parser/lexer.h"
#include "parser/limits.h"
#include "parser/report.h"
#include "parser/scene.h"

namespace snell {

struct UniformList {
    std::string program;  // the words before the first uniform, when asked for
    std::vector<UniformValue> uniforms;
};

// Reads `name value name value …`; with `named`, the name of the program stands before them. Whatever can be
// understood is returned, the rest reported.
UniformList read_uniforms(std::span<const Token> tokens, const Lexer& lexer, Report& report, const Limits& limits,
                          bool named);

// Whether the tokens read like a uniform and its value rather than a command: `uSc <0. .5 1.>`; or like `several`.
bool looks_like_uniform(std::span<const Token> tokens, const Lexer& lexer, bool several);

}  // namespace snell
