// The language server: JSON-RPC through two file descriptors, until the editor is done.
#pragma once

#include "src/server/state.h"

namespace snell::server {

// Returns the exit status that the protocol asks for: 0 after "shutdown" and "exit", otherwise 1.
int serve(Services services, int in, int out);

}  // namespace snell::server
