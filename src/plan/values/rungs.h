// The chosen rung of each ladder. Plain values; drop-downs, command-line flags and tests write the same ones.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "src/glsl/glsl.h"

namespace snell {

// For each of Scene::ladders, an index into Ladder::rungs.
using Rungs = std::vector<std::size_t>;

// The rungs that the scene's text marks.
Rungs marked_rungs(const Scene& scene);

// The macros that tell shaders the chosen rungs; `rungs` is in the order of `ladders`. A ladder FRESNEL defines FRESNEL
// (the number of the chosen rung), FRESNEL_f0 … (the number of each rung) and, if its rungs are numbers, FRESNEL_VALUE
// (the chosen one).
std::vector<glsl::Define> ladder_defines(std::span<const Ladder> ladders, const Rungs& rungs);

// Chooses a rung by a text such as "FRESNEL=exact". Returns false and reports an error, which suggests the nearest
// name, if there is no such ladder or rung.
bool choose_rung(Rungs& rungs, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics);

// Copies the choices of `from` for every ladder and rung that both have, by name. `to` keeps its own choice if the
// scene's text now marks another rung than before.
void carry_over(const Rungs& from, const Scene& from_scene, Rungs& to, const Scene& to_scene);

}  // namespace snell
