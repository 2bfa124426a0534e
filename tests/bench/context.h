// The context that benchmarks draw in.
#pragma once

#include <string>

#include "src/gl/context.h"

namespace snell::bench {

// Made and current from the first call on; null where there is no graphics.
const gl::Caps* graphics();
// Who draws, and with which OpenGL.
std::string renderer();

}  // namespace snell::bench
