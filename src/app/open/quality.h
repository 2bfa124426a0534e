// Quality presets for `--quality`, which were measured for a scene and stored in a file next to it.
#pragma once

#include <string>
#include <vector>

#include "parser/text/diagnostic.h"
#include "src/plan/files.h"
#include "src/plan/values/rungs.h"

namespace snell::app {

// The path of the presets: room.glib → room.quality.json
std::string quality_path(const std::string& scene);

// What the command line says of a scene's ladders.
struct RungWishes {
    std::string quality;               // the name of a preset, or ""
    std::vector<std::string> ladders;  // such as "FRESNEL=exact"; they take precedence over the preset
    std::vector<std::string> swept;    // names of ladders whose rung is chosen for each picture
};

// Chooses the rungs. With a preset, it also prints them to standard error. Reports an error if there are no presets, if
// `access` refuses their file, or if the scene's ladders or rungs have changed since they were measured.
void choose_rungs(const std::string& path, const RungWishes& wishes, const Access& access, const Scene& scene,
                  Rungs& rungs, Diagnostics& diagnostics);

}  // namespace snell::app
