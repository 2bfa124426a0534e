// workspace/executeCommand: what code lenses and editors' menus call.
#pragma once

#include <array>
#include <string_view>

#include "src/server/state.h"

namespace snell::server {

// Each takes the URI of a scene or a shader; "snell.cost" also the line of a statement, from 0.
// Windows, pictures and costs are of the texts that are open.
inline constexpr std::array<std::string_view, 3> command_names{"snell.open", "snell.render", "snell.cost"};

Json execute(State& state, const Json& params);

// Tells the editor of windows that failed.
void look_after_windows(State& state);

}  // namespace snell::server
