// Whether the context is still one.
#pragma once

namespace snell::gl {

// True: the driver has taken the context away, after a shader that did not end or a fault of its own. What was drawn
// since is undefined, and nothing more can be. Always false where the context does not notify of resets.
bool lost();

// True: lost() would tell.
bool tells_of_loss();

}  // namespace snell::gl
