// What is said of a scene without graphics.
#pragma once

#include <string>

#include "src/document/document.h"

namespace snell::web {

// Reads the scene and its shaders, with lints. The document has no runtime.
Document checked(const std::string& path);

}  // namespace snell::web
