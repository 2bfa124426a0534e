// Detects that the driver has reset the context.
#pragma once

namespace snell::gl {

// True if the driver has reset the context, after a shader that did not end or a fault of its own. Everything drawn
// since is undefined, and the context cannot be used any more. Always false if the context does not report resets.
bool lost();

}  // namespace snell::gl
