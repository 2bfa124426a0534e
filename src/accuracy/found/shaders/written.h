// Whether variables have a value where a statement is left out.
#pragma once

#include <string_view>

#include "src/glsl/read/token.h"

namespace snell::accuracy {

// Whether all of the variable was certainly written on every path from the function's begin to the token, which is
// outside of brackets. What only a call writes is not known.
bool surely_written(const glsl::Unit& unit, const glsl::Function& function, std::string_view name, int token);
// Whether without the assignment, a statement that begins with the token, its variable has as much of a value as
// before. `updates`: it reads what it changes, as += does.
bool can_go(const glsl::Unit& unit, const glsl::Function& function, int first, bool updates);

}  // namespace snell::accuracy
