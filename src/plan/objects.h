// Objects that the user moves: the draws of the scene, by their statements.
#pragma once

#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "parser/scene.h"
#include "src/plan/view.h"

namespace snell {

// World from model with the transformation that the user gave the object: about the object's own origin, along the axes
// of the scene's camera, in units of the world. `view`: eye from world without the user's eye transformation; rigid.
glm::dmat4 placed(const Transformation& object, const glm::dmat4& view, const glm::dmat4& model);

// By Scene::draws: what each draws, and how many before it draw the same.
std::vector<std::string> object_names(const Scene& scene);

// After another reading of the scene, the same object: by its place where there are as many as before (some parameter
// was edited), else by its name. none: it is gone.
Index carried(const std::vector<std::string>& from, const std::vector<std::string>& to, Index object);

// Objects keep their transformations, and what is gone loses them.
void carry_objects(const std::vector<std::string>& from, const std::vector<std::string>& to, View& view);

}  // namespace snell
