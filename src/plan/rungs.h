// Which rung of each ladder is chosen. Plain values; drop-downs, command-line flags and tests write the same ones.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "src/glsl/glsl.h"

namespace snell {

// By Scene::ladders: places in Ladder::rungs.
using Rungs = std::vector<std::size_t>;

// As the scene's text marks them.
Rungs marked_rungs(const Scene& scene);

// What shaders see of them, `rungs` as `ladders`: FRESNEL and the number of each of its rungs, FRESNEL_f0 …; where
// these are numbers, the current one as FRESNEL_VALUE.
std::vector<glsl::Define> ladder_defines(std::span<const Ladder> ladders, const Rungs& rungs);

// "FRESNEL=exact". False, with an error that suggests the nearest name, when there is no such ladder or rung.
bool choose_rung(Rungs& rungs, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics);

// The choices of `from` for every ladder and rung that both have, by name; `to` keeps its own where the scene's
// text marks another rung than before.
void carry_over(const Rungs& from, const Scene& from_scene, Rungs& to, const Scene& to_scene);

}  // namespace snell
