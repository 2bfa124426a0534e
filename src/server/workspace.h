// The scenes that belong to the texts that are open, as they were read last, and what was said of them.
#pragma once

#include <chrono>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "src/language/project.h"
#include "src/server/documents.h"
#include "src/server/wire/lines.h"

namespace snell::server {

using Clock = std::chrono::steady_clock;

// A scene, or a shader without one.
struct Scene {
    std::string path;
    bool alone = false;                        // a shader
    std::optional<language::Project> project;  // nullopt: it must be read again
    Json said = Json::array();                 // as published() has it
    bool check = true, driver = true;          // what is still to be done
    bool failed = false;                       // a check gave nothing since the texts changed
    Clock::time_point changed = Clock::now();
};

class Workspace {
public:
    explicit Workspace(const Documents& documents) : documents_(documents) {}

    // The scene of a text; a shader of several scenes is asked about in the one that was used last.
    Scene& scene_of(const Document& document);
    const language::Project& project_of(const Document& document);
    // Reads the scene if it has changed since.
    const language::Project& read(Scene& scene);
    // A text, or a file on disk, is another one now.
    void changed(const std::string& path);
    // Which files there are is another now: shaders may belong to other scenes.
    void rearranged();
    // Keeps the scenes of the texts that are open, and no others: the scenes among them, for shaders that those do not
    // have one on disk, and shaders without any scene alone. Which these are is a function of the texts and the files,
    // not of what was asked before.
    void arrange();
    // Whether arrange() has dropped a scene since this was asked last.
    bool dropped() { return std::exchange(dropped_, false); }

    std::list<Scene>& scenes() { return scenes_; }  // the one that was used last is last

private:
    Scene& open(const std::string& path, bool alone);
    bool has(Scene& scene, const Document& document);
    const std::string& scene_on_disk(const Document& document);

    const Documents& documents_;
    std::list<Scene> scenes_;
    std::map<std::string, std::string> found_;  // by the path of a shader: a scene on disk, "" if there is none
    bool arranged_ = false, dropped_ = false;
};

}  // namespace snell::server
