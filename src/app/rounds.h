// Loops that Mesa's llvmpipe would end early, without a word.
#pragma once

#include "src/app/document.h"
#include "src/gl/caps.h"
#include "src/plan/plan.h"

namespace snell {

// Warns of them as `snell check` does. Looks at nothing where another driver draws, or where no shader has a loop.
void warn_of_rounds(const Plan& plan, Document& document, const gl::Caps& caps);

}  // namespace snell
