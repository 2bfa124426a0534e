// Problems with files of textures that nothing samples, so that the picture does not depend on them.
#pragma once

#include "src/document/document.h"

namespace snell {

// Turns the errors about such missing files into notes if the scene has no other errors and no ladders: a program that
// failed, or one of another rung, may sample them.
void excuse_unsampled(Document& document);

// Reads and decodes these files nevertheless; problems with them become warnings.
void check_unsampled(Document& document);

}  // namespace snell
