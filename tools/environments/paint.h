// What the things of the room are painted with. Lengths in scene units; the room reaches from -5 to 5.
#pragma once

#include "tools/environments/model.h"

namespace snell::environments {

// Wallpaper above, panels below, mouldings, and an enamel sign with the name of the axis on each wall.
Material wall(const Spot& spot);
Material floor_boards(const Spot& spot);
Material carpet(const Spot& spot);
Material ceiling(const Spot& spot);
Material view_of_the_lake(const Spot& spot);
Material books(const Spot& spot);
Material curtain(const Spot& spot);
Material stone(const Spot& spot);
Material fire(const Spot& spot);
Material door(const Spot& spot);
Material clock_face(const Spot& spot);
Paint wood(const Colour& tone);
Paint cloth(const Colour& tone);
Paint leaves();
// Pictures fill the front of a box; `low` and `high` are its corners.
enum class Motif { mountains, refraction, squares, sunset };
Paint picture(Motif motif, const glm::dvec3& low, const glm::dvec3& high);

}  // namespace snell::environments
