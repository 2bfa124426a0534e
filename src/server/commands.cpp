#include "src/server/commands.h"

#include "src/server/wire/uri.h"

namespace snell::server {

namespace {

// The path of the scene that a text belongs to.
std::string scene_of(State& state, const std::string& uri) {
    const Document* document = state.documents.find(uri);
    if (!document) return path_of_uri(uri);
    const Scene& scene = state.workspace.scene_of(*document);
    if (scene.alone) throw Failure{Failure::request_failed, "no scene names this shader"};
    return scene.path;
}

// The window reads files, and follows them.
void tell_of_unsaved(State& state, const std::string& scene) {
    for (const Scene& open : state.workspace.scenes())
        for (const auto& [uri, document] : state.documents.all()) {
            if (open.path != scene || document.saved || !open.project || !open.project->file_of(document.path))
                continue;
            state.notify(
                "window/showMessage",
                {{"type", 3}, {"message", "The window shows the scene as it was saved, and again when you save."}});
            return;
        }
}

}  // namespace

Json execute(State& state, const Json& params) {
    const std::string command = string_at(params, "command");
    const Json& arguments = params.at("arguments");
    const std::string scene = scene_of(state, arguments.at(0).get<std::string>());
    if (!scene.starts_with('/')) throw Failure{Failure::request_failed, "the scene was never saved"};
    const int line = arguments.size() > 1 ? arguments.at(1).get<int>() : -1;
    if (command == command_names[0] && state.services.open) {
        const std::string wrong = state.services.open(scene);
        if (!wrong.empty()) throw Failure{Failure::request_failed, wrong};
        tell_of_unsaved(state, scene);
        return nullptr;
    }
    if (command == command_names[1])
        state.wanted.push_back({Errand::Kind::render, scene, line});
    else if (command == command_names[2])
        state.wanted.push_back({Errand::Kind::cost, scene, line});
    else
        throw Failure{Failure::invalid_params, "there is no command '" + command + "'"};
    return nullptr;
}

}  // namespace snell::server
