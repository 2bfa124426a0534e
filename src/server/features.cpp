#include "src/server/features.h"

#include <array>

#include "src/server/actions.h"
#include "src/server/commands.h"

namespace snell::server {

namespace {

Json actions(State& state, const Json& params) {
    const Document& document = state.document(params);
    const Scene& scene = state.workspace.scene_of(document);
    for (const Json& file : scene.said)
        if (file.at("uri") == document.uri && file.value("version", std::int64_t{-1}) == document.version)
            return code_actions(file.at("diagnostics"), params);
    return Json::array();  // what was said is of another text
}

struct Method {
    std::string_view name;
    Json (*answer)(State& state, const Json& params);
};
constexpr auto methods = std::to_array<Method>({
    {"textDocument/codeAction", actions},
    {"workspace/executeCommand", execute},
});

}  // namespace

std::optional<Json> feature(State& state, const std::string& method, const Json& params) {
    for (const Method& row : methods)
        if (row.name == method) return row.answer(state, params);
    return std::nullopt;
}

}  // namespace snell::server
