// Directives, macros and includes: from source texts to the tokens that count.
#pragma once

#include "src/glsl/read/token.h"

namespace snell::glsl {

// Fills tokens, files, head, version and extensions of a unit whose stage is set. The text stays as written
// wherever possible: directives and dead groups become the lead of the token after them, a macro's use keeps
// its spelling beside its expansion. Where that can't be (a condition on __VERSION__ or GL_…, whose value the
// driver would judge otherwise; a macro that redefines a word of the language), `verbatim` is false, and
// directives and dead groups turn into empty lines, and macros into their expansion; so also where the caller has set
// `verbatim` to false.
void preprocess(Unit& unit, FileId file, Sources& sources, const Options& options, Diagnostics& diagnostics);

// What marks the place of extension directive n in a lead.
inline constexpr char extension_mark = '\x01';

}  // namespace snell::glsl
