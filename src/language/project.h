// A scene with everything that it reads, as an editor sees it: texts of open documents stand in the place of files. No
// driver, no protocol.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/glsl/glsl.h"
#include "src/plan/files.h"
#include "src/plan/plan.h"

namespace snell::language {

// Where a shader's text is compiled.
struct ShaderUse {
    Index program = none;  // index into Scene::programs, and into Project::translations
    Stage stage = Stage::vertex;
    bool operator==(const ShaderUse&) const = default;
};

// A text of GLSL: a stage of a program, or what stages include.
struct Shader {
    std::string path;  // on disk; empty: of snell's library, such as <snell/fresnel.glsl>
    FileId file = 0;   // the first source of this name; programs that include it have sources of their own
    std::vector<ShaderUse> uses;
    bool included = false;  // by another shader; false: a statement of the scene names it
};

struct Project {
    std::string path;  // of the scene; of the shader if it is open alone
    // There is no scene: `plan` has one program of one stage, and the text of `scene_file` is empty.
    bool alone = false;
    std::unique_ptr<Files> files;
    Sources sources;
    static constexpr FileId scene_file = 0;  // what is read first
    Plan plan;                               // its scene, and programs with the texts of their shaders
    // In the order of Scene::programs; not `ok` where there are no shaders, or where they have errors.
    std::vector<glsl::Translation> translations;
    Diagnostics diagnostics;  // of parser, plan, translator and lints, sorted
    std::vector<Shader> shaders;
    // By the name of a source: the one that was read first from the same file, by whatever links and ".." lead there.
    std::map<std::string, FileId, std::less<>> firsts;

    const Scene& scene() const { return plan.scene; }
    // The path on disk of a source; empty if it has none (snell's library).
    std::string_view path_of(FileId file) const;
    // The first source that was read from `path`, by whatever links and ".." lead there.
    std::optional<FileId> file_of(std::string_view path) const;
    // The source that stands for the file in all answers: an editor has it once, however often it is read.
    FileId first(FileId file) const;
    // Null: a scene.
    const Shader* shader_of(FileId file) const;
    bool is_scene(FileId file) const { return !alone && shader_of(file) == nullptr; }
};

// How far a project is read: each step takes longer, and has what the one before has.
enum class Depth : std::uint8_t {
    plan,       // parsed and planned, with the files that shaders include
    translated  // with `translations`, lints and all diagnostics
};

// Reads a scene. Never throws; if the scene cannot be read, `diagnostics` says why, and `plan` is empty.
Project read_project(const std::string& scene_path, const Access& access, Depth depth = Depth::translated);
// Reads a shader as a program of itself; its stage goes by its extension and its text.
Project read_shader(const std::string& shader_path, const Access& access, Depth depth = Depth::translated);

// The stage that a shader's name, or else its text, tells; nullopt: neither does (what others include).
std::optional<Stage> stage_of(std::string_view path, std::string_view text);

// A scene that names the shader, or a text that includes it: in the shader's folder, the ones above, and the ones
// below, all as they are on disk. Returns "" if there is none among the first hundred. Scenes whose text names the
// shader are preferred.
std::string find_scene(const std::string& shader_path);

}  // namespace snell::language
