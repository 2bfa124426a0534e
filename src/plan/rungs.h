// Which rung of each ladder is chosen. Plain values; drop-downs, command-line flags and tests write the same ones.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"

namespace snell {

// By Scene::ladders: places in Ladder::rungs.
using Rungs = std::vector<std::size_t>;

// As the scene's text marks them.
Rungs marked_rungs(const Scene& scene);

// "FRESNEL=exact". False, with an error that suggests the nearest name, when there is no such ladder or rung.
bool choose_rung(Rungs& rungs, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics);

// The choices of `from` for every ladder and rung that both have, by name; `to` keeps its own where the scene's
// text marks another rung than before.
void carry_over(const Rungs& from, const Scene& from_scene, Rungs& to, const Scene& to_scene);

}  // namespace snell
