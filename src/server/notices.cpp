#include "src/server/notices.h"

#include "src/content/uri.h"
#include "src/server/capabilities.h"

namespace snell::server {

namespace {

void did_open(State& state, const Json& params) {
    const Json& item = params.at("textDocument");
    const std::string uri = string_at(item, "uri");
    const Document& opened =
        state.documents.open({uri, content::path_of_uri(uri), item.value("languageId", ""),
                              item.value("version", std::int64_t{0}), string_at(item, "text"), state.halves});
    state.workspace.rearranged();
    state.workspace.scene_of(opened);
}

Place valid_place(const Json& range, const char* end) { return place_of(range.at(end)); }

void did_change(State& state, const Json& params) {
    Document& document = state.document(params);
    std::vector<Change> changes;
    for (const Json& json : params.at("contentChanges")) {
        Change change{std::nullopt, string_at(json, "text"), state.halves};
        if (const auto range = json.find("range"); range != json.end() && !range->is_null())
            change.range = Change::Range{valid_place(*range, "start"), valid_place(*range, "end")};
        changes.push_back(std::move(change));
    }
    apply(document, changes, state.encoding);
    document.version = params.at("textDocument").value("version", document.version + 1);
    state.workspace.changed(document.path);
}

void did_save(State& state, const Json& params) {
    Document& document = state.document(params);
    const auto text = params.find("text");
    if (text == params.end() || !text->is_string() || (!document.lost && *text == document.text)) return;
    apply(document, {{std::nullopt, text->get<std::string>(), state.halves}}, state.encoding);
    state.workspace.rearranged();
}

void did_close(State& state, const Json& params) {
    const Document& document = state.document(params);
    state.documents.close(std::string(document.uri));
    state.workspace.rearranged();
}

void did_change_files(State& state, const Json& params) {
    bool arrangement = false;
    for (const Json& change : params.at("changes")) {
        const std::string path = content::path_of_uri(string_at(change, "uri"));
        arrangement = arrangement || change.value("type", 2) != 2;
        if (!state.documents.with_path(path)) state.workspace.changed(path);
    }
    if (arrangement) state.workspace.rearranged();
}

void initialized(State& state, const Json&) {
    if (state.can("/workspace/didChangeWatchedFiles/dynamicRegistration"))
        state.ask("client/registerCapability", watched_files());
}

}  // namespace

void lose(State& state, const std::optional<std::string>& uri, const std::string& why) {
    const int lost = state.documents.lose(uri);
    if (lost == 0) return;
    state.workspace.rearranged();
    const std::string name = uri ? uri->substr(uri->rfind('/') + 1) : std::to_string(lost) + " texts";
    state.notify("window/showMessage", {{"type", 2},
                                        {"message", "snell could not read a change of " + name + ": " + why +
                                                        ". Save to have it read again."}});
}

void notice(State& state, const std::string& method, const Json& params) {
    if (method == "initialized") initialized(state, params);
    if (method == "textDocument/didOpen") did_open(state, params);
    if (method == "textDocument/didChange") did_change(state, params);
    if (method == "textDocument/didSave") did_save(state, params);
    if (method == "textDocument/didClose") did_close(state, params);
    if (method == "workspace/didChangeWatchedFiles") did_change_files(state, params);
}

}  // namespace snell::server
