// Assigns values: those that texts such as "Program.uniform=value" name, and those of the scene again.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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
    double value = 0;
    const auto [end, error] = read_real(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
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

// The component that a name such as "uColor.g" selects, here 1; nullopt for other names.
std::optional<std::size_t> component_of(std::string_view name) {
    if (name.size() < 3 || name[name.size() - 2] != '.') return std::nullopt;
    for (const std::string_view letters : {"xyzw", "rgba"})
        if (const std::size_t at = letters.find(name.back()); at != std::string_view::npos) return at;
    return std::nullopt;
}

// The vectors that have the component that `name` selects.
std::vector<Control*> named_vectors(Controls& controls, const Scene& scene, std::string_view name) {
    std::vector<Control*> found = named(controls, scene, name.substr(0, name.size() - 2));
    const std::size_t component = *component_of(name);
    std::erase_if(found, [&](const Control* control) {
        return control->type == ValueType::matrix || control->array_size > 1 || control->components < 2 ||
               component >= control->value.size();
    });
    return found;
}

void report_unknown(const Controls& controls, const Scene& scene, std::string_view name, Diagnostics& diagnostics) {
    std::vector<std::string> full;
    for (const Control& control : controls.items) {
        if (control.program < scene.programs.size()) {
            full.push_back(scene.programs[control.program].name + '.' + control.name);
        }
    }
    std::vector<std::string_view> names;
    for (const Control& control : controls.items) names.push_back(control.name);
    std::string_view near = nearest(name, names);
    if (near.empty() && name.find('.') != std::string_view::npos) {
        near = nearest(name, std::vector<std::string_view>(full.begin(), full.end()));
    }
    std::string help = near.empty() ? std::string() : fmt::format("did you mean '{}'?", near);
    if (help.empty() && names.empty()) help = "the scene has no uniforms to set";
    diagnostics.error("unknown-uniform-name", fmt::format("there is no uniform '{}'", name), std::move(help));
}

// Converts the numbers to the control's type; returns nullopt and reports an error if they do not fit.
std::optional<std::vector<double>> fitted(const Control& control, std::vector<double> values,
                                          Diagnostics& diagnostics) {
    if (control.widget == Widget::color && control.components == 4 && values.size() == 3) values.resize(4, 1);
    if (values.size() != control.value.size()) {
        diagnostics.error("uniform-value-count",
                          fmt::format("'{}' takes {} {}, not {}", control.name, control.value.size(),
                                      control.value.size() == 1 ? "number" : "numbers", values.size()));
        return std::nullopt;
    }
    const bool real = control.type == ValueType::float_ || control.type == ValueType::matrix;
    for (double& value : values) {
        const double kept = fit_to_type(value, control.type);
        const bool rounded = !real && control.type != ValueType::bool_ && std::round(value) == kept;
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

}  // namespace

bool set_control(Controls& controls, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics) {
    const std::size_t equals = assignment.find('=');
    const std::string_view name = trimmed(assignment.substr(0, equals));
    if (equals == std::string_view::npos || name.empty()) {
        diagnostics.error("bad-assignment", fmt::format("'{}' is not an assignment", assignment),
                          "write uniform=value or Program.uniform=value");
        return false;
    }
    std::vector<Control*> targets = named(controls, scene, name);
    const std::optional<std::size_t> component = targets.empty() ? component_of(name) : std::nullopt;
    if (component) targets = named_vectors(controls, scene, name);
    if (targets.empty()) {
        report_unknown(controls, scene, name, diagnostics);
        return false;
    }
    // A control that no program uses is set only if no used one has the name.
    if (std::any_of(targets.begin(), targets.end(), [](const Control* c) { return c->active; })) {
        std::erase_if(targets, [](const Control* c) { return !c->active; });
    } else {
        diagnostics.warning("inactive-uniform", fmt::format("no program uses '{}', so setting it has no effect", name));
    }
    std::string bad;
    const std::optional<std::vector<double>> values = numbers(assignment.substr(equals + 1), bad);
    if (!values || values->empty()) {
        diagnostics.error("bad-value", values ? fmt::format("the value of '{}' is missing", name)
                                              : fmt::format("the value '{}' of '{}' is not a number{}", bad, name,
                                                            too_large(bad) ? " that fits" : ""));
        return false;
    }
    std::vector<std::vector<double>> each;
    for (const Control* control : targets) {
        std::vector<double> wanted = *values;
        if (component && wanted.size() == 1) {
            wanted = control->value;
            wanted[*component] = values->front();
        } else if (component) {
            diagnostics.error("uniform-value-count", fmt::format("'{}' takes 1 number, not {}", name, values->size()));
            return false;
        }
        std::optional<std::vector<double>> fit = fitted(*control, std::move(wanted), diagnostics);
        if (!fit) return false;
        each.push_back(std::move(*fit));
    }
    for (std::size_t i = 0; i < targets.size(); ++i) assign(*targets[i], std::move(each[i]));
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
