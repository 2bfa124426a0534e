// Requests about texts.
#pragma once

#include <optional>
#include <string>

#include "src/server/state.h"

namespace snell::server {

// Returns the result as JSON, nullopt if there is no such method. Throws a Failure, or nlohmann's exceptions for params
// of a wrong shape.
std::optional<std::string> feature(State& state, const std::string& method, const Json& params);

}  // namespace snell::server
