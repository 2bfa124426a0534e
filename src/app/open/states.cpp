#include "src/app/open/states.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/content/text_forms.h"

namespace snell {

namespace {

constexpr std::size_t most_differences = 3;  // that a label names

// Settings stand between blanks, of which values in brackets may have some: "uColor=[1 .5 0] uIndex=1.33"; or commas
// and blanks, as in labels.
std::vector<std::string_view> settings_of(std::string_view text) {
    std::vector<std::string_view> settings;
    std::size_t begin = 0;
    int depth = 0;
    for (std::size_t at = 0; at <= text.size(); ++at) {
        const char c = at < text.size() ? text[at] : ' ';
        depth += std::string_view("[{<").find(c) != text.npos   ? 1
                 : std::string_view("]}>").find(c) != text.npos ? -1
                                                                : 0;
        if (at < text.size() && (c != ' ' || depth > 0)) continue;
        const std::size_t end = at > begin && text[at - 1] == ',' ? at - 1 : at;
        if (end > begin) settings.push_back(text.substr(begin, end - begin));
        begin = at + 1;
    }
    return settings;
}

NamedState of_settings(std::string_view text, const Scene& scene) {
    NamedState state;
    const auto none = [&] {
        return NamedState{.error = fmt::format("'{}' names no state: 'saved', 'reference', 'snapshot 1' or settings, "
                                               "such as uIndex=1.33",
                                               utf8::printable(text))};
    };
    const std::vector<std::string_view> settings = settings_of(text);
    if (settings.empty()) return none();
    for (const std::string_view setting : settings) {
        const std::string_view name = setting.substr(0, setting.find('='));
        if (name.size() == setting.size()) return none();
        const bool ladder = ranges::find(scene.ladders, name, &Ladder::name) != scene.ladders.end();
        (ladder ? state.ladders : state.sets).emplace_back(setting);
    }
    return state;
}

std::string first_message(const Diagnostics& diagnostics) {
    if (diagnostics.items().empty()) return "";
    const Diagnostic& first = diagnostics.items().front();
    return first.help.empty() ? first.message : first.message + "; " + first.help;
}

// "1.33" of "1.3300000000000001", "40000" of "40000", and "1 .5 0" of "1,0.5,0".
std::string short_value(const std::string& text, int least) {
    const std::vector<double> numbers = read_numbers(text);
    if (numbers.empty()) return text;
    std::string words;
    for (const double number : numbers) {
        const bool large = std::abs(number) >= 1e4 && std::abs(number) < 1e8;  // whole thousands stay whole
        const int digits = large ? std::max(8, least) : least;
        words += fmt::format("{}{:.{}g}", words.empty() ? "" : " ", number, digits);
    }
    return words;
}

// "uIndex" of a setting of "Glass.uIndex", if no other program has one of that name; "BEND" of a ladder.
std::string name_of(const std::string& key, const Setup& setup) {
    if (key.starts_with(ladder_option)) return key.substr(ladder_option.size());
    const std::string uniform = key.substr(key.rfind('.'));
    const bool only = ranges::count_if(setup, [&](const Setup::value_type& other) {
                          return other.first.starts_with(set_option) && other.first.ends_with(uniform);
                      }) == 1;
    return only ? uniform.substr(1) : key.substr(set_option.size());
}

}  // namespace

NamedState named_state(std::string_view name, const std::string& path, const Scene& scene) {
    if (name == state_now) return {};
    if (name == state_saved) return {.written = true};
    NamedState state;
    if (name == state_reference) {
        for (const Ladder& ladder : scene.ladders) state.ladders.push_back(ladder.name + "=" + ladder.rungs.back());
        return state;
    }
    if (!name.starts_with(state_snapshot)) return of_settings(name, scene);
    const std::string_view number = name.substr(state_snapshot.size());
    const int index = number.size() == 1 ? number[0] - '0' : 0;
    if (index < 1 || index > most_snapshots) return {.error = no_snapshot(number, path)};
    Setup setup = read_snapshot(index, path, state.error);
    setup = Renaming(setup, setup, scene)(setup);
    return {true, arguments_of(setup, set_option), arguments_of(setup, ladder_option), state.error};
}

std::string apply_state(const NamedState& state, const Scene& scene, Rungs& rungs) {
    Diagnostics refused;
    if (state.written) rungs = marked_rungs(scene);
    for (const std::string& ladder : state.ladders) choose_rung(rungs, scene, ladder, refused);
    return first_message(refused);
}

std::string apply_state(const NamedState& state, const Scene& scene, Controls& controls) {
    Diagnostics refused;
    if (state.written)
        for (Control& control : controls.items) reset(control);
    for (const std::string& set : state.sets) {
        Diagnostics here;
        // "uEta=1,33" of one number has a decimal comma, as in the fields of sliders.
        std::string decimal = set;
        std::replace(decimal.begin(), decimal.end(), ',', '.');
        if (!set_control(controls, scene, set, here) && here.items().back().code == "uniform-value-count") {
            Diagnostics otherwise;
            if (set_control(controls, scene, decimal, otherwise)) here = std::move(otherwise);
        }
        refused.append(here);
    }
    return first_message(refused);
}

StateDifference difference(const Setup& left, const Setup& right) {
    StateDifference found;
    std::size_t count = 0;
    const auto differs = [&](const Setup::value_type& here) {
        const auto there = right.find(here.first);
        return (here.first.starts_with(ladder_option) || here.first.starts_with(set_option)) && there != right.end() &&
               there->second != here.second;
    };
    const auto all = static_cast<std::size_t>(ranges::count_if(left, differs));
    for (const auto& here : left) {
        if (!differs(here) || ++count > most_differences) continue;
        const auto& [key, value] = here;
        const std::string name = name_of(key, left);
        const char* comma = count > 1 ? ", " : "";
        std::string here_text, there_text;
        for (int digits = 4; digits <= 16 && here_text == there_text; digits *= 2) {
            here_text = short_value(value, digits);
            there_text = short_value(right.at(key), digits);
        }
        found.left += fmt::format("{}{} {}", comma, name, here_text);
        // Of a single one the left says which.
        found.right += fmt::format("{}{}{}", comma, all > 1 ? name + " " : "", there_text);
    }
    if (all > most_differences)
        for (std::string* side : {&found.left, &found.right})
            *side += fmt::format(" and {} more", all - most_differences);
    return found;
}

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
    return content::without_links(scene).replace_extension("snapshots.json").string();
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

std::string delete_snapshot(int number, const std::string& scene) {
    Json json = read(scene);
    const std::string file = snapshots_file(scene);
    if (json.is_discarded()) return file + " cannot be read as JSON: it is left as it is";
    json.erase(std::to_string(number));
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
