#include "src/app/open/snapshots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"
#include "src/document/save_values.h"

namespace snell {

namespace {

using Json = nlohmann::ordered_json;

// Returns "Glass.uEta", or "Glass#2.uEta" for the second program of that name.
std::string key_of(const Scene& scene, const Control& control) {
    const std::string& name = scene.programs[control.program].name;
    const auto end = scene.programs.begin() + control.program;
    const auto before = std::count_if(scene.programs.begin(), end, [&](const Program& p) { return p.name == name; });
    return before == 0 ? fmt::format("{}.{}", name, control.name)
                       : fmt::format("{}#{}.{}", name, before + 1, control.name);
}

// Returns an empty object if the file is missing or empty, and "discarded" if it is not a JSON object.
Json read(const std::string& scene) {
    const std::string text = content::whole_file(snapshots_file(scene));
    if (text.empty()) return Json::object();
    Json json = content::parse_json(text);
    return json.is_object() ? json : Json(Json::value_t::discarded);
}

const Json* member(const Json& json, const std::string& name) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

// With `changed_only` the snapshot has only values that differ from the scene's.
Json snapshot_of(const Document& document, bool changed_only) {
    const Scene& scene = document.scene();
    Json snapshot = {{"values", Json::object()}};
    for (const Control& control : document.controls.items)
        if (control.type != ValueType::sampler && !(changed_only && control.value == control.initial))
            snapshot["values"][key_of(scene, control)] = control.value;
    const Rungs& rungs = document.controls.rungs;
    for (std::size_t i = 0; i < scene.ladders.size() && i < rungs.size(); ++i)
        if (!(changed_only && rungs[i] == scene.ladders[i].current))
            snapshot["ladders"][scene.ladders[i].name] = scene.ladders[i].rungs[rungs[i]];
    return snapshot;
}

// Values are set as by `--set`, which refuses what the uniform cannot hold.
bool restore(const Json& numbers, Control& control, Document& document) {
    if (!numbers.is_array() || numbers.size() != control.value.size()) return false;
    Controls one;
    one.items.push_back(control);
    std::string text = control.name + "=";
    for (const Json& number : numbers) {
        if (!number.is_number() || !std::isfinite(number.get<double>())) return false;
        text += fmt::format("{}{}", text.ends_with('=') ? "" : ",", number.get<double>());
    }
    Diagnostics ignored;
    if (!set_control(one, document.scene(), text, ignored)) return false;
    control = std::move(one.items.front());
    return true;
}

bool has_values(const Json& snapshot) {
    const Json* values = member(snapshot, "values");
    return values && values->is_object();
}

// Returns the number of ladders and rungs that the scene does not have.
std::size_t restore_ladders(const Json& snapshot, const Scene& scene, Rungs& rungs) {
    std::size_t lost = 0;
    const Json* ladders = member(snapshot, "ladders");
    if (!ladders || !ladders->is_object()) return lost;
    for (const auto& [name, rung] : ladders->items()) {
        Diagnostics ignored;
        if (!rung.is_string() || !choose_rung(rungs, scene, name + "=" + rung.get<std::string>(), ignored)) ++lost;
    }
    return lost;
}

Restored restore_all(const Json& snapshot, Document& document) {
    const Json& values = snapshot["values"];
    std::size_t used = 0;
    for (Control& control : document.controls.items) {
        const Json* numbers = member(values, key_of(document.scene(), control));
        if (numbers && restore(*numbers, control, document)) ++used;
    }
    const std::size_t lost = restore_ladders(snapshot, document.scene(), document.controls.rungs);
    return {{}, values.size() - std::min(used, values.size()) + lost};
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

std::string store_snapshot(int number, const Document& document) {
    Json json = read(document.path);
    const std::string file = snapshots_file(document.path);
    if (json.is_discarded()) return file + " is not JSON: it is left as it is";
    Json& snapshot = json[std::to_string(number)];
    if (!snapshot.is_object()) snapshot = {{"name", ""}};
    snapshot.update(snapshot_of(document, false));
    return content::replace_file(file, content::json_text(json) + "\n");
}

Restored restore_snapshot(int number, Document& document) {
    const Json json = read(document.path);
    if (const Json* snapshot = member(json, std::to_string(number)); snapshot && has_values(*snapshot))
        return restore_all(*snapshot, document);
    return {json.is_discarded() ? snapshots_file(document.path) + " is not JSON"
                                : fmt::format("there is no snapshot {}", number)};
}

std::string changed_text(const Document& document) {
    return changed_values(document) == 0 ? "" : content::json_text(snapshot_of(document, true));
}

void restore_rungs(const std::string& changed, const Scene& scene, Rungs& rungs) {
    restore_ladders(content::parse_json(changed), scene, rungs);
}

Restored restore_changed(const std::string& changed, Document& document) {
    const Json json = content::parse_json(changed);
    return has_values(json) ? restore_all(json, document) : Restored{"no values", 0};
}

}  // namespace snell
