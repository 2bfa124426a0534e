// Objects that the user moves: draws of the scene, identified by their statements.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell {

// World from model with the user's transformation of the object: about the object's own origin, along the axes of the
// scene's camera, in world units.
glm::dmat4 placed(const Transformation& object, const Camera& camera, const glm::dmat4& model);

// One name for each of Scene::draws: what it draws, and how many draws before it draw the same.
std::vector<std::string> object_names(const Scene& scene);

// Finds an object again after the scene was read again: by its index if there are as many draws as before (a parameter
// was edited), otherwise by its name. Returns none if the object is gone.
Index carried(const std::vector<std::string>& from, const std::vector<std::string>& to, Index object);

// Moves the transformations of objects to their new indices; those of objects that are gone are removed.
void carry_objects(const std::vector<std::string>& from, const std::vector<std::string>& to, View& view);

}  // namespace snell
