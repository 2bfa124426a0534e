// Requests about texts.
#pragma once

#include <optional>
#include <string>

#include "src/server/state.h"

namespace snell::server {

// Returns the result as JSON, nullopt if there is no such method. Throws a Failure, or nlohmann's exceptions for params
// of a wrong shape.
std::optional<std::string> feature(State& state, const std::string& method, const Json& params);

// Notifications: the texts that are open, and what changes on disk.

// What may have changed the text `uri`, or any text, could not be read: the user is told, and nothing is said of such a
// text, or answered about it, until the editor sends it whole.
void lose(State& state, const std::optional<std::string>& uri, const std::string& why);
// Unknown ones are passed over.
void notice(State& state, const std::string& method, const Json& params);

}  // namespace snell::server
