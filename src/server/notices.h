// Notifications: the texts that are open, and what changes on disk.
#pragma once

#include <string>

#include "src/server/state.h"

namespace snell::server {

// Unknown ones are passed over.
void notice(State& state, const std::string& method, const Json& params);

}  // namespace snell::server
