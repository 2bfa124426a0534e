#include "src/app/open/states.h"

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/snapshots.h"

namespace snell {

namespace {

constexpr std::size_t most_differences = 3;  // that a label names

// Settings stand between blanks, of which values in brackets may have some: "uColor=[1 .5 0] uIndex=1.33".
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
        if (at > begin) settings.push_back(text.substr(begin, at - begin));
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

// "1.33" of "1.3300000000000001", and "1 .5 0" of "1,0.5,0".
std::string short_value(const std::string& text) {
    const std::vector<double> numbers = read_numbers(text);
    if (numbers.empty()) return text;
    std::string words;
    for (const double number : numbers) words += fmt::format("{}{:.4g}", words.empty() ? "" : " ", number);
    return words;
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
    const Setup setup = read_snapshot(index, path, state.error);
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
    for (const std::string& set : state.sets) set_control(controls, scene, set, refused);
    return first_message(refused);
}

StateDifference difference(const Setup& left, const Setup& right) {
    StateDifference found;
    std::size_t count = 0;
    for (const auto& [key, value] : left) {
        const bool rung = key.starts_with(ladder_option);
        const auto other = right.find(key);
        if ((!rung && !key.starts_with(set_option)) || other == right.end() || other->second == value) continue;
        if (++count > most_differences) continue;
        const std::string name = key.substr(rung ? key.find(' ') + 1 : key.rfind('.') + 1);
        const char* comma = count > 1 ? ", " : "";
        found.left += fmt::format("{}{} {}", comma, name, short_value(value));
        found.right += comma + short_value(other->second);
    }
    if (count > most_differences)
        for (std::string* side : {&found.left, &found.right})
            *side += fmt::format(" and {} more", count - most_differences);
    return found;
}

}  // namespace snell
