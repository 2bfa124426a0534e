// For read_outline().
#pragma once

#include "src/language/shader/outline.h"

namespace snell::language {

// Finds the declarations outside of directives, and what every name means.
void resolve_names(Outline& outline);

}  // namespace snell::language
