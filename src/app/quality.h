// `--quality`: the presets that were measured of a scene, in a file beside it.
#pragma once

#include <string>

#include "parser/diagnostic.h"
#include "src/plan/rungs.h"

namespace snell::app {

// room.glib → room.quality.json
std::string quality_path(const std::string& scene);

// Chooses the rungs of the preset and says on stderr which they are. False, with an error, where nothing was measured,
// or of another scene than it is now: a ladder or a rung has come or gone.
bool choose_quality(const std::string& path, const std::string& name, const Scene& scene, Rungs& rungs,
                    Diagnostics& diagnostics);

}  // namespace snell::app
