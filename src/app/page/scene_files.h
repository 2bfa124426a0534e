// Everything that a scene reads, as a page carries it.
#pragma once

#include <string>
#include <vector>

#include "src/app/page/pack.h"
#include "src/plan/files.h"

namespace snell::app {

struct SceneFiles {
    std::string scene;  // the name of the scene among the files
    std::vector<PackedFile> files;
    std::string error;  // "", or why the scene cannot be in a page
};

// Reads the scene and all files that it names, whatever its rungs and values are. Images of formats that pages do not
// decode are there twice: as they are, and decoded.
SceneFiles scene_files(const std::string& scene, const Access& access);

}  // namespace snell::app
