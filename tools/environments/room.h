// A furnished room around the origin, ten units in each direction, in which no two walls can be confused: a window
// ahead (-Z), books to the right (+X), a fireplace to the left (-X), a door behind (+Z), a carpet below, beams above.
#pragma once

#include <memory>

#include "tools/environments/light.h"

namespace snell::environments {

class Room {
public:
    Room();
    // Seen from the origin; direction of any length.
    Colour operator()(const glm::dvec3& direction) const;

private:
    std::shared_ptr<const Model> model_;
    std::shared_ptr<const Light> light_;
};

}  // namespace snell::environments
