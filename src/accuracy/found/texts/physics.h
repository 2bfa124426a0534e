// Better changes that no lint finds.
#pragma once

#include "src/accuracy/found/texts/texts.h"

namespace snell::accuracy::texts {

// Exact Fresnel equations for Schlick's formula; then add_surroundings.
void add_physics(const Reading& reading, const std::vector<Span>& eye_space, Offers& to);

// Both interfaces of balls of glass, and rooms that are near. `eye_space`: lookups by directions in eye coordinates,
// which no room can mend.
void add_surroundings(const Reading& reading, const std::vector<Span>& eye_space, Offers& to);

}  // namespace snell::accuracy::texts
