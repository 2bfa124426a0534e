#include "src/language/find.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "parser/text/words.h"
#include "src/language/project.h"
#include "src/plan/locate.h"

namespace snell::language {

namespace {

namespace fs = std::filesystem;

constexpr int levels_above = 3;
constexpr std::size_t most_entries = 10'000;     // of a folder that are looked at
constexpr std::size_t most_scenes = 4'000;       // whose texts are searched for the shader's name
constexpr std::size_t most_others = 100;         // that are read because what they include may name it
constexpr std::uintmax_t most_bytes = 1u << 20;  // of a scene

// The scenes of a folder, sorted; its folders are added to `below`.
std::vector<std::string> scenes_in(const fs::path& folder, std::vector<fs::path>* below) {
    std::vector<std::string> scenes;
    std::error_code error;
    std::size_t seen = 0;
    for (fs::directory_iterator it(folder, error), end; !error && it != end && seen < most_entries;
         it.increment(error), ++seen) {
        std::error_code none;
        if (has_extension(it->path().native(), "glib") && it->is_regular_file(none) &&
            it->file_size(none) <= most_bytes)
            scenes.push_back(it->path().string());
        if (below && it->is_directory(none)) below->push_back(it->path());
    }
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

std::vector<std::string> scenes_around(const fs::path& shader) {
    std::vector<std::string> scenes;
    const auto add = [&](const std::vector<std::string>& more) {
        scenes.insert(scenes.end(), more.begin(), more.end());
    };
    std::vector<fs::path> below;
    fs::path folder = shader.parent_path();
    for (int level = 0; level <= levels_above && scenes.size() < most_scenes; ++level) {
        add(scenes_in(folder, level == 0 ? &below : nullptr));
        if (folder == folder.parent_path()) break;
        folder = folder.parent_path();
    }
    std::sort(below.begin(), below.end());
    for (const fs::path& one : below)
        if (scenes.size() < most_scenes) add(scenes_in(one, nullptr));
    if (scenes.size() > most_scenes) scenes.resize(most_scenes);
    return scenes;
}

bool names(const std::string& scene, const std::string& stem) {
    Files files("");
    std::string error;
    const auto text = files.read(scene, error);
    return text && contains(*text, stem);
}

bool belongs(const std::string& scene, const std::string& shader) {
    return read_project(scene, {}, Depth::plan).file_of(shader).has_value();
}

}  // namespace

std::string find_scene(const std::string& shader_path) {
    const std::string stem = fs::path(shader_path).stem().string();
    std::vector<std::string> others;
    for (const std::string& scene : scenes_around(shader_path)) {
        if (names(scene, stem)) {
            if (belongs(scene, shader_path)) return scene;
        } else if (others.size() < most_others) {
            others.push_back(scene);
        }
    }
    for (const std::string& scene : others)
        if (belongs(scene, shader_path)) return scene;
    return {};
}

std::optional<Stage> stage_of(std::string_view path, std::string_view text) {
    for (int i = 0; i < stage_count; ++i) {
        const auto stage = static_cast<Stage>(i);
        for (const std::string_view extension : stage_extensions(stage))
            if (extension != "glsl" && has_extension(path, extension)) return stage;
    }
    const auto has = [&](std::string_view word) { return text.find(word) != std::string_view::npos; };
    if (!has("main")) return std::nullopt;
    if (has("EmitVertex")) return Stage::geometry;
    if (has("gl_TessLevelOuter")) return Stage::tess_control;
    if (has("gl_TessCoord")) return Stage::tess_evaluation;
    return has("gl_Position") || has("ftransform") ? Stage::vertex : Stage::fragment;
}

}  // namespace snell::language
