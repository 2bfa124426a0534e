// Better changes that no lint finds: more rounds, exact Fresnel, both interfaces, a room that is near.
#pragma once

#include "src/accuracy/found/texts.h"

namespace snell::accuracy::physics {

void add_physics(const Plan& plan, const texts::Shaders& shaders, const Sources& sources, texts::Collector& to);

}  // namespace snell::accuracy::physics
