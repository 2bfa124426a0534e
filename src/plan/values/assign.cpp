// Assigns values: those that texts such as "Program.uniform=value" name, and those of the scene again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "parser/text/number.h"
#include "parser/text/words.h"
#include "src/plan/values/controls.h"
#include "src/plan/values/declared.h"

namespace snell {
namespace {

std::optional<double> number(std::string_view text) {
    const std::string word = lowered(text);
    if (word == "true" || word == "on" || word == "yes") return 1;
    if (word == "false" || word == "off" || word == "no") return 0;
    if (text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+') text.remove_prefix(1);
    const auto value = read_whole<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

// Whether the word is a number that no type holds.
bool too_large(std::string_view word) {
    double value = 0;
    const auto [end, error] = read_real(word.data(), word.data() + word.size(), value);
    return error == std::errc::result_out_of_range && end == word.data() + word.size();
}

// Parses numbers separated by commas or blanks, optionally in brackets. Returns nullopt, with the offending word in
// `bad`, if one is not a number.
std::optional<std::vector<double>> numbers(std::string_view text, std::string& bad) {
    text = trimmed(text);
    if (text.size() > 1 &&
        ((text.front() == '[' && text.back() == ']') || (text.front() == '{' && text.back() == '}') ||
         (text.front() == '<' && text.back() == '>'))) {
        text = trimmed(text.substr(1, text.size() - 2));
    }
    std::vector<double> values;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(", \t\r\n"), text.size());
        const std::string_view word = text.substr(0, end);
        const std::optional<double> value = number(word);
        if (!value) {
            bad = word;
            return std::nullopt;
        }
        values.push_back(*value);
        text = trimmed(text.substr(end));
        if (text.empty() || text.front() != ',') continue;
        text = trimmed(text.substr(1));
        if (text.empty()) return std::nullopt;  // nothing follows the comma
    }
    return values;
}

// The controls that `name` means: those of every program, or of one program if prefixed by "Program.".
std::vector<Control*> named(Controls& controls, const Scene& scene, std::string_view name) {
    std::vector<Control*> found;
    const auto collect = [&](std::string_view uniform, std::optional<std::string_view> program) {
        for (Control& control : controls.items) {
            if (program && (control.program >= scene.programs.size() ||
                            trimmed(scene.programs[control.program].name) != trimmed(*program))) {
                continue;
            }
            if (control.name == uniform) found.push_back(&control);
        }
    };
    collect(name, std::nullopt);
    for (std::size_t dot = name.find('.'); dot != std::string_view::npos && found.empty();
         dot = name.find('.', dot + 1)) {
        collect(name.substr(dot + 1), name.substr(0, dot));
    }
    if (!found.empty() || name.find('#') == std::string_view::npos) return found;
    // "P#2.uA" is that of the second program P; "P#1.uA" that of the first, whose name has no number.
    const std::vector<std::string> names = control_names(scene, controls);
    std::string plain(name);
    if (const std::size_t one = plain.find("#1."); one != std::string::npos) plain.erase(one, 2);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] == name || names[i] == plain) found.push_back(&controls.items[i]);
    return found;
}

// The numbers of a control that a name means.
struct Selected {
    std::size_t first = 0, count = 0;
};

struct Target {
    Control* control;
    Selected part;
};

// The component that an ending such as ".g" selects, here 1; nullopt for others.
std::optional<std::size_t> component_of(std::string_view ending) {
    if (ending.size() != 2 || ending[0] != '.') return std::nullopt;
    for (const std::string_view letters : {"xyzw", "rgba"})
        if (const std::size_t at = letters.find(ending[1]); at != std::string_view::npos) return at;
    return std::nullopt;
}

// What an ending such as ".g" or "[2]" selects of the control; nullopt if it has no such part.
std::optional<Selected> part_of(const Control& control, std::string_view ending) {
    if (const auto component = component_of(ending)) {
        const bool vector = control.type != ValueType::matrix && control.array_size == 1 && control.components > 1;
        return vector && *component < control.value.size() ? std::optional(Selected{*component, 1}) : std::nullopt;
    }
    if (ending.size() < 3 || ending.front() != '[' || ending.back() != ']' || control.array_size < 2)
        return std::nullopt;
    const auto index = read_whole<std::size_t>(ending.substr(1, ending.size() - 2));
    if (!index || *index >= static_cast<std::size_t>(control.array_size)) return std::nullopt;
    const auto each = static_cast<std::size_t>(control.components);
    return Selected{each * *index, each};
}

// What `name` means: whole uniforms; else a component or an element of them.
std::vector<Target> targets_of(Controls& controls, const Scene& scene, std::string_view name) {
    std::vector<Target> found;
    for (Control* control : named(controls, scene, name)) found.push_back({control, {0, control->value.size()}});
    const std::size_t ending = name.find_last_of(".[");
    if (!found.empty() || ending == std::string_view::npos) return found;
    for (Control* control : named(controls, scene, name.substr(0, ending)))
        if (const std::optional<Selected> part = part_of(*control, name.substr(ending)))
            found.push_back({control, *part});
    return found;
}

void report_unknown(const Controls& controls, const Scene& scene, std::string_view name, Diagnostics& diagnostics) {
    std::vector<std::string> full;
    for (const Control& control : controls.items) {
        if (control.program < scene.programs.size())
            full.push_back(scene.programs[control.program].name + '.' + control.name);
    }
    std::vector<std::string_view> names;
    for (const Control& control : controls.items) names.push_back(control.name);
    std::string_view near = nearest(name, names);
    if (near.empty() && name.find('.') != std::string_view::npos)
        near = nearest(name, std::vector<std::string_view>(full.begin(), full.end()));
    std::string help = near.empty() ? std::string() : fmt::format("did you mean '{}'?", near);
    for (const Control& control : controls.items)
        if (control.array_size > 1 && name.ends_with(']') && name.find(control.name + "[") != std::string_view::npos)
            help = fmt::format("'{}' has the elements {}[0] to {}[{}]", control.name, control.name, control.name,
                               control.array_size - 1);
    if (help.empty() && names.empty()) help = "the scene has no uniforms to set";
    diagnostics.error("unknown-uniform-name", fmt::format("there is no uniform '{}'", name), std::move(help));
}

// The control's numbers with these in place of a part, converted to its type; returns nullopt and reports an error if
// they do not fit. `name` is what the user calls the part.
std::optional<std::vector<double>> fitted(const Control& control, const Selected& part, std::string_view name,
                                          std::vector<double> given, Diagnostics& diagnostics) {
    if (control.widget == Widget::color && part.count == 4 && given.size() == 3) given.resize(4, 1);
    if (given.size() != part.count) {
        diagnostics.error("uniform-value-count", fmt::format("'{}' takes {} {}, not {}", name, part.count,
                                                             part.count == 1 ? "number" : "numbers", given.size()));
        return std::nullopt;
    }
    std::vector<double> values = control.value;
    std::copy(given.begin(), given.end(), values.begin() + static_cast<std::ptrdiff_t>(part.first));
    const bool real = control.type == ValueType::float_ || control.type == ValueType::matrix;
    for (double& value : values) {
        const double kept = fit_to_type(value, control.type);
        const bool rounded = !real && control.type != ValueType::bool_ && std::round(value) == kept;
        if (rounded && kept != value)
            diagnostics.warning("uniform-value-type",
                                fmt::format("'{}' takes whole numbers: {} is set as {}", control.name, value, kept));
        if (kept != value && control.type != ValueType::bool_ && !rounded) {
            diagnostics.error("uniform-value-range", fmt::format("'{}' cannot have the value {}", control.name, value),
                              fmt::format("the nearest valid value is {}", kept));
            return std::nullopt;
        }
        value = kept;
    }
    return values;
}

void assign(Control& control, std::vector<double> values) {
    for (const double value : values) {
        const Range range =
            limit_range({std::min(control.min, value), value, std::max(control.max, value)}, control.type);
        if (control.widget != Widget::slider) continue;
        control.min = range.min;
        control.max = range.max;
    }
    control.value = std::move(values);
}

// The number of elements of an array whose elements have controls of their own; 0: the name is none's.
std::size_t elements_of(Controls& controls, const Scene& scene, std::string_view name) {
    std::size_t count = 0;
    while (!named(controls, scene, fmt::format("{}[{}]", name, count)).empty()) ++count;
    return count;
}

}  // namespace

bool set_control(Controls& controls, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics) {
    const std::size_t equals = assignment.find('=');
    const std::string_view name = trimmed(assignment.substr(0, equals));
    if (equals == std::string_view::npos || name.empty()) {
        diagnostics.error("bad-assignment", fmt::format("'{}' is not an assignment", assignment),
                          "write uniform=value or Program.uniform=value");
        return false;
    }
    std::string bad;
    const std::optional<std::vector<double>> values = numbers(assignment.substr(equals + 1), bad);
    const std::size_t elements = elements_of(controls, scene, name);
    if (values && elements > 0 && values->size() % elements == 0) {
        const std::size_t each = values->size() / elements;
        for (std::size_t i = 0; i < elements; ++i) {
            const std::span<const double> part = std::span(*values).subspan(i * each, each);
            if (!set_control(controls, scene, fmt::format("{}[{}]={}", name, i, fmt::join(part, ",")), diagnostics))
                return false;
        }
        return true;
    }
    std::vector<Target> targets = targets_of(controls, scene, name);
    if (targets.empty()) {
        report_unknown(controls, scene, name, diagnostics);
        return false;
    }
    // A control that no program uses is set only if no used one has the name.
    if (std::any_of(targets.begin(), targets.end(), [](const Target& t) { return t.control->active; })) {
        std::erase_if(targets, [](const Target& t) { return !t.control->active; });
    } else {
        diagnostics.warning("inactive-uniform", fmt::format("no program uses '{}', so setting it has no effect", name));
    }
    if (!values || values->empty()) {
        diagnostics.error("bad-value", values ? fmt::format("the value of '{}' is missing", name)
                                              : fmt::format("the value '{}' of '{}' is not a number{}", bad, name,
                                                            too_large(bad) ? " that fits" : ""));
        return false;
    }
    std::vector<std::vector<double>> each;
    for (const auto& [control, part] : targets) {
        const std::string_view called = part.count == control->value.size() ? std::string_view(control->name) : name;
        std::optional<std::vector<double>> fit = fitted(*control, part, called, *values, diagnostics);
        if (!fit) return false;
        each.push_back(std::move(*fit));
    }
    for (std::size_t i = 0; i < targets.size(); ++i) assign(*targets[i].control, std::move(each[i]));
    return true;
}

void reset(Control& control) {
    control.value = control.initial;
    control.min = control.initial_min;
    control.max = control.initial_max;
}

// The components share one range, so it keeps its room for those that are not reset.
void reset(Control& control, std::size_t component) {
    control.value[component] = control.initial[component];
    const auto [lowest, highest] = std::minmax_element(control.value.begin(), control.value.end());
    control.min = std::min(control.initial_min, *lowest);
    control.max = std::max(control.initial_max, *highest);
}

}  // namespace snell
