#include "src/plan/values/remembered.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/values/declared.h"

namespace snell {

namespace {

constexpr std::size_t most_gone = 1000;  // values of uniforms that the scene does not have

// A value that was set while its program was broken may have one number for all components.
bool spread(std::vector<double>& numbers, std::size_t count) {
    if (numbers.size() == 1 && count > 1) numbers.assign(count, numbers[0]);
    return numbers.size() == count;
}

bool recall_value(RememberedValue from, Control& control, Follow follow) {
    const std::size_t count = control.value.size();
    if (control.type == ValueType::sampler || !spread(from.value, count) || !spread(from.initial, count)) return false;
    for (double& number : from.value) number = fit_to_type(number, control.type);
    if (follow == Follow::text && from.initial != control.initial) return false;
    if (from.value == control.value) return false;
    const Range range = limit_range({from.min, from.value[0], from.max}, control.type);
    from.min = range.min;
    from.max = range.max;
    take_value(from, control, follow);
    return true;
}

}  // namespace

std::vector<std::string> control_names(const Scene& scene, const Controls& controls) {
    std::map<std::string_view, int> count;
    std::vector<std::string> programs;
    for (const Program& program : scene.programs) {
        const int before = count[program.name]++;
        programs.push_back(before == 0 ? program.name : fmt::format("{}#{}", program.name, before + 1));
    }
    std::vector<std::string> names;
    names.reserve(controls.items.size());
    for (const Control& control : controls.items) names.push_back(programs[control.program] + "." + control.name);
    return names;
}

RememberedValue remembered(const Control& control) {
    return {control.value, control.initial, control.min, control.max, control.initial_min, control.initial_max};
}

void remember(const Scene& scene, const Controls& controls, Remembered& memory, bool all) {
    const std::vector<std::string> names = control_names(scene, controls);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Control& control = controls.items[i];
        if (control.type != ValueType::sampler && (all || control.value != control.initial))
            memory.values[names[i]] = remembered(control);
        else if (const auto noted = memory.values.find(names[i]);
                 noted != memory.values.end() && (control.listed || noted->second.initial == control.initial))
            memory.values.erase(noted);
    }
    if (memory.values.size() > names.size() + most_gone) {
        const std::set<std::string_view> here(names.begin(), names.end());
        std::erase_if(memory.values, [&](const auto& value) { return !here.contains(value.first); });
    }
    for (std::size_t i = 0; i < scene.ladders.size() && i < controls.rungs.size(); ++i) {
        const Ladder& ladder = scene.ladders[i];
        if (all || controls.rungs[i] != ladder.current)
            memory.rungs[ladder.name] = {ladder.rungs[controls.rungs[i]], ladder.rungs[ladder.current]};
        else
            memory.rungs.erase(ladder.name);
    }
}

void take_value(const RememberedValue& from, Control& control, Follow follow) {
    control.value = from.value;
    if (control.widget != Widget::slider) return;
    const bool same_range = from.initial_min == control.initial_min && from.initial_max == control.initial_max;
    const auto [lowest, highest] = std::minmax_element(control.value.begin(), control.value.end());
    control.min = control.initial_min;
    control.max = control.initial_max;
    if (!same_range && follow == Follow::text) {
        for (double& value : control.value) value = std::clamp(value, control.min, control.max);
    } else if (*lowest < control.min || *highest > control.max) {
        control.min = std::min({control.min, same_range ? from.min : *lowest, *lowest});
        control.max = std::max({control.max, same_range ? from.max : *highest, *highest});
    }
}

bool recall(const Remembered& memory, const Scene& scene, Controls& controls, Follow follow) {
    bool changed = false;
    if (memory.values.empty()) return changed;
    const std::vector<std::string> names = control_names(scene, controls);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (const auto found = memory.values.find(names[i]); found != memory.values.end())
            changed |= recall_value(found->second, controls.items[i], follow);
    return changed;
}

bool recall(const Remembered& memory, const Scene& scene, Rungs& rungs, Follow follow) {
    bool changed = false;
    for (std::size_t i = 0; i < scene.ladders.size() && i < rungs.size(); ++i) {
        const Ladder& ladder = scene.ladders[i];
        const auto found = memory.rungs.find(ladder.name);
        if (found == memory.rungs.end()) continue;
        if (follow == Follow::text && found->second.initial != ladder.rungs[ladder.current]) continue;
        const auto rung = ranges::find(ladder.rungs, found->second.rung);
        const auto index = static_cast<std::size_t>(rung - ladder.rungs.begin());
        if (rung == ladder.rungs.end() || rungs[i] == index) continue;
        rungs[i] = index;
        changed = true;
    }
    return changed;
}

}  // namespace snell
