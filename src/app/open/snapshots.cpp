#include "src/app/open/snapshots.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"
#include "src/plan/setup.h"

namespace snell {

namespace {

using Json = nlohmann::ordered_json;

// Returns an empty object if the file is missing or empty, and "discarded" if it cannot be read or is not a JSON
// object.
Json read(const std::string& scene) {
    const std::string file = snapshots_file(scene), text = content::whole_file(file);
    std::error_code missing;
    if (text.empty() && (std::filesystem::file_size(file, missing) == 0 || missing)) return Json::object();
    Json json = content::parse_json(text);
    return json.is_object() ? json : Json(Json::value_t::discarded);
}

const Json* member(const Json& json, const std::string& name) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

}  // namespace

std::string snapshots_file(const std::string& scene) {
    return std::filesystem::path(scene).replace_extension("snapshots.json").string();
}

std::array<bool, most_snapshots + 1> snapshots_there(const std::string& scene) {
    std::array<bool, most_snapshots + 1> there{};
    const Json json = read(scene);
    for (int number = 1; number <= most_snapshots; ++number)
        there[static_cast<std::size_t>(number)] = member(json, std::to_string(number)) != nullptr;
    return there;
}

Setup snapshot_of(const Document& document) {
    Setup setup = setup_of(document.scene(), document.controls);
    erase(setup, range_option);
    return setup;
}

std::string store_snapshot(int number, const Document& document) {
    return store_snapshot(number, document.path, snapshot_of(document));
}

std::string store_snapshot(int number, const std::string& scene, const Setup& values) {
    Json json = read(scene);
    const std::string file = snapshots_file(scene);
    if (json.is_discarded()) return file + " cannot be read as JSON: it is left as it is";
    Json& snapshot = json[std::to_string(number)];
    if (!snapshot.is_object()) snapshot = {{"name", ""}};
    snapshot["options"] = setup_text(values);
    return content::replace_file(file, content::json_text(json) + "\n");
}

std::string no_snapshot(std::string_view number, const std::string& scene) {
    std::string there;
    const auto stored = snapshots_there(scene);
    for (std::size_t i = 1; i < stored.size(); ++i)
        if (stored[i]) there += fmt::format("{}{}", there.empty() ? "" : ", ", i);
    const char* noun = there.empty() ? "none" : there.size() > 1 ? "snapshots " : "snapshot ";
    return fmt::format("there is no snapshot {}; the scene has {}{}", utf8::printable(number), noun, there);
}

Setup read_snapshot(int number, const std::string& scene, std::string& error) {
    const Json json = read(scene);
    const Json* const snapshot = member(json, std::to_string(number));
    const Json* const options = snapshot ? member(*snapshot, "options") : nullptr;
    if (options && options->is_string()) return read_setup(options->get<std::string>());
    error = json.is_discarded() ? snapshots_file(scene) + " cannot be read as JSON"
            : snapshot          ? fmt::format("snapshot {} has another form: store it again", number)
                                : no_snapshot(std::to_string(number), scene);
    return {};
}

Restored restore_snapshot(int number, Document& document) {
    Restored restored;
    const Setup setup = read_snapshot(number, document.path, restored.error);
    if (restored.error.empty()) restored.lost = apply_setup(setup, document.scene(), document.controls);
    return restored;
}

}  // namespace snell
