// The texts of a scene: its own, with the scenes that it includes, what its shaders include, and all files that it may
// read.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/glsl/glsl.h"
#include "src/plan/files.h"
#include "src/plan/plan.h"

namespace snell {

// The result of parsing alone, for those that need no graphics.
struct ParsedDocument {
    FileId file = 0;
    Scene scene;
};
// Returns nullopt if the file cannot be read.
std::optional<ParsedDocument> parse_document(const std::string& path, Files& files, Sources& sources,
                                             Diagnostics& diagnostics);
// Parses and plans, which is all of opening a scene that needs no driver. Returns nullopt if the file cannot be read.
std::optional<Plan> read_plan(const std::string& path, Files& files, Sources& sources, Diagnostics& diagnostics);

// The folder that file names in the scene are relative to.
std::string scene_folder(const std::string& path);

// What the shaders of a scene include: the library for angle brackets, else files.
glsl::IncludeReader shader_includes(Files& files);

// The files that a scene may read, found without compiling.

struct ShaderText {
    std::string path;
    std::string_view text;
};

// Returns the stages of the program first, then each included file once. Includes in comments and in branches that are
// never compiled count, too; a file that cannot be read has an empty text. The texts live as long as `sources` and
// `reader`.
std::vector<ShaderText> shader_texts(const PlannedProgram& program, const Sources& sources, Files& reader);

// For callers that must not write over any of them: returns the paths of everything that `files` has read, and of all
// meshes, textures, noise and included shaders that the plan names, whatever its rungs are. Includes in comments and in
// branches that are never compiled count, too.
std::vector<std::string> used_files(const Plan& plan, const Sources& sources, const Files& files);

}  // namespace snell
