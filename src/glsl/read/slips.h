// What C compilers let pass, and what hides more of a shader than its author saw.
#pragma once

#include <string_view>

#include "parser/text/diagnostic.h"

namespace snell::glsl {

// Reports a comment `/*` that nothing closes, and a backslash that makes the next line a part of a comment `//`.
void check_comments(std::string_view text, FileId file, Diagnostics& diagnostics);

// Reports words behind `#else` or `#endif`, and returns how many bytes of `rest`, which follows the directive's name in
// the text, come before them: all if there are none.
std::size_t before_surplus(std::string_view name, std::string_view rest, Span place, Diagnostics& diagnostics);

}  // namespace snell::glsl
