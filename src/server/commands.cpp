#include "src/server/commands.h"

#include "src/content/uri.h"

namespace snell::server {

namespace {

// The path of the scene that a text belongs to.
std::string scene_of(State& state, const std::string& uri) {
    const Document* document = state.documents.find(uri);
    if (!document) return content::path_of_uri(uri);
    const Scene& scene = state.workspace.scene_of(*document);
    if (scene.alone) throw Failure{Failure::request_failed, "no scene names this shader"};
    return scene.path;
}

}  // namespace

Json execute(State& state, const Json& params) {
    const std::string command = string_at(params, "command");
    const Json& arguments = params.at("arguments");
    const std::string scene = scene_of(state, arguments.at(0).get<std::string>());
    if (!scene.starts_with('/')) throw Failure{Failure::request_failed, "the scene was never saved"};
    const int line = arguments.size() > 1 ? arguments.at(1).get<int>() : -1;
    if (command == command_names[0] && state.services.open)
        state.windows.push_back(state.services.open(scene, state.documents.access()));
    else if (command == command_names[1])
        state.wanted.push_back({Errand::Kind::render, scene, line});
    else if (command == command_names[2])
        state.wanted.push_back({Errand::Kind::cost, scene, line});
    else
        throw Failure{Failure::invalid_params, "there is no command '" + command + "'"};
    return nullptr;
}

void look_after_windows(State& state) {
    std::erase_if(state.windows, [&](const Window& window) {
        const std::optional<std::string> ended = window();
        if (ended && !ended->empty()) state.notify("window/showMessage", {{"type", 1}, {"message", *ended}});
        return ended.has_value();
    });
}

}  // namespace snell::server
