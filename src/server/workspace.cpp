#include "src/server/workspace.h"

#include <set>

#include "parser/text/ranges.h"
#include "src/language/find.h"

namespace snell::server {

Scene& Workspace::open(const std::string& path, bool alone) {
    const auto found = ranges::find_if(scenes_, [&](const Scene& s) { return s.path == path && s.alone == alone; });
    if (found != scenes_.end()) return *found;
    return scenes_.emplace_front(Scene{path, alone});
}

const language::Project& Workspace::read(Scene& scene) {
    if (!scene.project)
        scene.project = scene.alone ? language::read_shader(scene.path, documents_.access(), language::Depth::plan)
                                    : language::read_project(scene.path, documents_.access(), language::Depth::plan);
    return *scene.project;
}

// The path of the scene that a shader belongs to, "" if it is alone.
std::string Workspace::scene_path(const Document& document) {
    for (auto scene = scenes_.rbegin(); scene != scenes_.rend(); ++scene)
        if (!scene->alone && read(*scene).file_of(document.path)) return scene->path;
    const auto [entry, added] = found_.try_emplace(document.path);
    if (added && document.path.starts_with('/'))
        entry->second = language::find_scene(document.path, documents_.access());
    // It may have been changed since.
    if (!entry->second.empty() && !read(open(entry->second, false)).file_of(document.path)) entry->second.clear();
    return entry->second;
}

Scene& Workspace::scene_of(const Document& document) {
    const std::string path = document.is_scene() ? document.path : scene_path(document);
    Scene& scene = path.empty() ? open(document.path, true) : open(path, false);
    const auto at = ranges::find_if(scenes_, [&](const Scene& s) { return &s == &scene; });
    scenes_.splice(scenes_.end(), scenes_, at);
    return scenes_.back();
}

const language::Project& Workspace::project_of(const Document& document) { return read(scene_of(document)); }

void Workspace::changed(const std::string& path) {
    for (Scene& scene : scenes_) {
        const bool own = scene.path == path;
        // A file that the scene lacks, or reads as data, may be this one: a name that was not found has no path.
        if (!own && scene.project && !scene.project->file_of(path) && documents_.with_path(path)) continue;
        scene.project.reset();
        scene.check = scene.driver = true;
        scene.changed = Clock::now();
    }
}

void Workspace::rearranged() {
    found_.clear();
    for (Scene& scene : scenes_) {
        scene.project.reset();
        scene.check = scene.driver = true;
    }
}

void Workspace::arrange() {
    std::set<const Scene*> used;
    // Scenes first, so that their shaders find them.
    for (const bool scenes : {true, false})
        for (const auto& [uri, document] : documents_.all())
            if (document.is_scene() == scenes) {
                const std::string path = scenes ? document.path : scene_path(document);
                used.insert(path.empty() ? &open(document.path, true) : &open(path, false));
            }
    scenes_.remove_if([&](const Scene& scene) { return !used.contains(&scene); });
}

}  // namespace snell::server
