// The texts of a scene: its own, with the scenes that it includes, and what its shaders include.
#pragma once

#include <optional>
#include <string>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/glsl/glsl.h"
#include "src/plan/files.h"

namespace snell {

// The result of parsing alone, for those that need no graphics.
struct ParsedDocument {
    FileId file = 0;
    Scene scene;
};
// Returns nullopt if the file cannot be read.
std::optional<ParsedDocument> parse_document(const std::string& path, Files& files, Sources& sources,
                                             Diagnostics& diagnostics);

// The folder that file names in the scene are relative to.
std::string scene_folder(const std::string& path);

// What the shaders of a scene include: the library for angle brackets, else files.
glsl::IncludeReader shader_includes(Files& files);

}  // namespace snell
