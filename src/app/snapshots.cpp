#include "src/app/snapshots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "src/content/json.h"
#include "src/content/replace.h"

namespace snell {

namespace {

using Json = nlohmann::ordered_json;

// "Glass.uEta"; "Glass#2.uEta" for the second program of that name.
std::string key_of(const Scene& scene, const Control& control) {
    const std::string& name = scene.programs[control.program].name;
    const auto end = scene.programs.begin() + control.program;
    const auto before = std::count_if(scene.programs.begin(), end, [&](const Program& p) { return p.name == name; });
    return before == 0 ? fmt::format("{}.{}", name, control.name)
                       : fmt::format("{}#{}.{}", name, before + 1, control.name);
}

// Nothing for what is not there; "discarded" for what is no JSON object.
Json read(const std::string& scene) {
    std::ifstream file(snapshots_file(scene), std::ios::binary);
    if (!file) return Json::object();
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    Json json = content::parse_json(text);
    return json.is_object() ? json : Json(Json::value_t::discarded);
}

const Json* member(const Json& json, const std::string& name) {
    if (!json.is_object()) return nullptr;
    const auto found = json.find(name);
    return found == json.end() ? nullptr : &*found;
}

// As `--set` would, so that only what the uniform can hold gets there.
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
    const Scene& scene = document.scene();
    Json values = Json::object(), ladders = Json::object();
    for (const Control& control : document.controls.items)
        if (control.type != ValueType::sampler) values[key_of(scene, control)] = control.value;
    for (std::size_t i = 0; i < scene.ladders.size() && i < document.controls.rungs.size(); ++i)
        ladders[scene.ladders[i].name] = scene.ladders[i].rungs[document.controls.rungs[i]];
    Json& snapshot = json[std::to_string(number)];
    if (!snapshot.is_object()) snapshot = {{"name", ""}};
    snapshot["values"] = std::move(values);
    if (!ladders.empty()) snapshot["ladders"] = std::move(ladders);
    return content::replace_file(file, content::json_text(json) + "\n");
}

Restored restore_snapshot(int number, Document& document) {
    Restored restored;
    const Json json = read(document.path);
    const Json* snapshot = member(json, std::to_string(number));
    const Json* values = snapshot ? member(*snapshot, "values") : nullptr;
    const Json* ladders = snapshot ? member(*snapshot, "ladders") : nullptr;
    if (!values || !values->is_object()) {
        restored.error = json.is_discarded() ? snapshots_file(document.path) + " is not JSON"
                                             : fmt::format("there is no snapshot {}", number);
        return restored;
    }
    std::size_t used = 0;
    for (Control& control : document.controls.items) {
        const Json* numbers = member(*values, key_of(document.scene(), control));
        if (numbers && restore(*numbers, control, document)) ++used;
    }
    restored.lost = values->size() - std::min(used, values->size());
    if (!ladders || !ladders->is_object()) return restored;
    for (const auto& [name, rung] : ladders->items()) {
        Diagnostics ignored;
        if (!rung.is_string() ||
            !choose_rung(document.controls.rungs, document.scene(), name + "=" + rung.get<std::string>(), ignored))
            ++restored.lost;
    }
    return restored;
}

}  // namespace snell
