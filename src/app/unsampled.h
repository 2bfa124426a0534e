// Files of textures that nothing samples: the picture does not depend on them.
#pragma once

#include "src/app/document.h"

namespace snell {

// That they are missing becomes a note, where that is all that is wrong: a program that failed may be one that samples
// them, and so may one of another rung.
void excuse_unsampled(Document& document);

// Reads and decodes them all the same: what is wrong with them is a warning.
void check_unsampled(Document& document);

}  // namespace snell
