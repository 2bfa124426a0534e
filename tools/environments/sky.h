// A summer afternoon outdoors: sun, clouds, mountains, a lake to the right (+X) and a meadow.
#pragma once

#include "tools/environments/faces.h"

namespace snell::environments {

// Unit vector to the sun: ahead (-Z), to the left (-X), well above the horizon.
glm::dvec3 sun_direction();
Colour sky_radiance(const glm::dvec3& direction);

}  // namespace snell::environments
