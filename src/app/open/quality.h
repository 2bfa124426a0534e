// Quality presets for `--quality`, which were measured for a scene and stored in a file next to it.
#pragma once

#include <string>

#include "parser/text/diagnostic.h"
#include "src/plan/values/rungs.h"

namespace snell::app {

// The path of the presets: room.glib → room.quality.json
std::string quality_path(const std::string& scene);

// Chooses the rungs of the preset and prints them to standard error. Returns false and reports an error if there are no
// presets, or if the scene's ladders or rungs have changed since they were measured.
bool choose_quality(const std::string& path, const std::string& name, const Scene& scene, Rungs& rungs,
                    Diagnostics& diagnostics);

}  // namespace snell::app
