// Makes controls from the values on Program lines and the uniforms of linked programs.
#include "src/plan/values/controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "parser/text_of.h"
#include "src/glsl/read/lexer.h"
#include "src/plan/values/declared.h"

namespace snell {
namespace {

using Kind = UniformValue::Kind;

std::string_view without_zero(std::string_view name) {
    return name.ends_with("[0]") ? name.substr(0, name.size() - 3) : name;
}

const ActiveUniform* find_active(const std::vector<ActiveUniform>& active, std::string_view name) {
    const auto found = std::find_if(active.begin(), active.end(), [&](const ActiveUniform& uniform) {
        return without_zero(uniform.name) == without_zero(name);
    });
    return found == active.end() ? nullptr : &*found;
}

// Names that the translator generates are never shown or suggested.
bool is_internal(std::string_view name) { return name.starts_with("snell_") || name.starts_with("gl_"); }

std::string type_name(const ActiveUniform& uniform) {
    return uniform.array_size > 1 ? fmt::format("{}[{}]", uniform.glsl_type, uniform.array_size) : uniform.glsl_type;
}

std::string a_type(const ActiveUniform& uniform) {
    const std::string name = type_name(uniform);
    return fmt::format("{} {}", article(name), name);
}

struct Element {
    const ActiveUniform* array = nullptr;
    std::size_t index = 0;
};

// Finds the element of an array that a name such as "weights[2]" means.
Element find_element(const std::vector<ActiveUniform>& active, std::string_view name) {
    const std::size_t bracket = name.rfind('[');
    if (bracket == std::string_view::npos || name.back() != ']') return {};
    const auto index = read_whole<std::size_t>(name.substr(bracket + 1, name.size() - bracket - 2));
    const ActiveUniform* array = find_active(active, name.substr(0, bracket));
    if (!index || !array || array->array_size < 2 || *index >= static_cast<std::size_t>(array->array_size)) return {};
    return {array, *index};
}

// True for <true>, false for <1>: the first makes a check box, the second is a constant unless the uniform is a bool.
// Only the length of the word tells them apart.
bool is_word(const UniformValue& boolean) {
    if (!boolean.integral || boolean.value_spans.empty()) return false;
    const Span& span = boolean.value_spans[0];
    return span.end - span.begin >= std::string_view("true").size();
}

class Maker {
public:
    Maker(const Scene& scene, Diagnostics& diagnostics, const Declared* declared)
        : scene_(scene), diagnostics_(diagnostics), declared_(declared) {}

    Controls make(const std::vector<std::vector<ActiveUniform>>& active) {
        static const std::vector<ActiveUniform> nothing;
        for (Index program = 0; program < scene_.programs.size(); ++program) {
            const auto& uniforms = program < active.size() ? active[program] : nothing;
            add_listed(program, uniforms);
            add_unlisted(program, uniforms);
        }
        for (Control& control : controls_.items) {
            control.initial_min = control.min;
            control.initial_max = control.max;
        }
        return std::move(controls_);
    }

private:
    void add_listed(Index program, const std::vector<ActiveUniform>& active) {
        const auto& values = scene_.programs[program].uniforms;
        for (Index index = 0; index < values.size(); ++index) {
            const UniformValue& written = values[index];
            if (const Element element = find_element(active, written.name); element.array != nullptr) {
                add_element(program, written, element);
                continue;
            }
            const ActiveUniform* uniform = find_active(active, written.name);
            Control control = control_of(program, written.name, written.span);
            control.uniform = index;
            control.active = uniform != nullptr;
            if (uniform == nullptr) report_unknown(program, written, active);
            fit(control, written, uniform != nullptr ? *uniform : guess(written));
            control.initial = control.value;
            controls_.items.push_back(std::move(control));
        }
    }

    static Control control_of(Index program, std::string_view name, const Span& span) {
        Control control;
        control.program = program;
        control.name = name;
        control.span = span;
        return control;
    }

    // Adds a value such as "weights[2] 5." to the array's control: the elements of one array share a control.
    void add_element(Index program, const UniformValue& written, const Element& element) {
        const ActiveUniform& array = *element.array;
        Control* control = controls_.find(program, without_zero(array.name));
        if (control == nullptr) {
            controls_.items.push_back(control_of(program, without_zero(array.name), written.span));
            control = &controls_.items.back();
            take_type(*control, array);
        }
        const bool range = written.kind == Kind::range && written.values.size() > 2;
        if (range)
            diagnostics_.warning("element-without-slider", written.span,
                                 fmt::format("'{}' gets no slider, as '{}' has its values in one, too", written.name,
                                             without_zero(array.name)),
                                 "give each element a value of its own instead");
        const std::vector<double> values = range ? std::vector{written.values[1]} : written.values;
        const auto each = static_cast<std::size_t>(control->components);
        const std::size_t first = each * element.index, room = control->value.size() - first;
        if (values.empty() || values.size() > room || values.size() % each != 0)
            report_count(written, array, each, values.size());
        for (std::size_t i = 0; i < std::min(values.size(), room); ++i)
            control->value[first + i] = typed(*control, values[i], written, array);
        control->initial = control->value;
    }

    // Whether another rung may use the name: shaders have it besides its declaration, in comments or elsewhere, or
    // include a file that only another rung reads.
    bool other_rung_may_use(Index program, std::string_view name) const {
        if (scene_.programs[program].ladders == 0) return false;
        if (declared_ == nullptr) return true;
        const Sources& sources = declared_->sources;
        std::size_t named = 0;
        for (FileId file = 0; file < sources.size(); ++file) {
            if (ranges::any_of(scene_.programs, [&](const Program& one) { return one.span.file == file; })) continue;
            const std::string_view text = sources.text(file);
            if (includes_more(text)) return true;
            named += glsl::count_word(text, name);
        }
        return named > (find_declared(program, name) == nullptr ? 0 : 1);
    }

    bool includes_more(std::string_view text) const {
        return ranges::any_of(glsl::included_names(text), [&](const glsl::IncludeName& include) {
            const std::string_view last = include.name.substr(include.name.rfind('/') + 1);
            for (FileId file = 0; file < declared_->sources.size(); ++file)
                if (declared_->sources.name(file).ends_with(last)) return false;
            return true;
        });
    }

    // If another rung may use what this one does not, the name is reported only if it resembles one that is used but
    // not listed, because that suggests a typing error.
    void report_unknown(Index program, const UniformValue& written, const std::vector<ActiveUniform>& active) {
        const std::string_view base = base_name(written.name);
        const bool laddered = other_rung_may_use(program, base);
        if (const auto* whole = find_declared(program, written.name); whole != nullptr && whole->in_block) {
            report_unknown(
                written, fmt::format("'{}' belongs to a uniform block, which no scene can set: it is 0", written.name))
                .help = "declare it as a uniform of its own";
            return;
        }
        const glsl::DeclaredUniform* declared = find_declared(program, base);
        if (declared != nullptr && declared->span.begin == declared->span.end) declared = nullptr;
        if (active.empty() && declared == nullptr) return;  // the program failed
        if (const ActiveUniform* array = find_active(active, base); array != nullptr && !laddered) {
            const bool apart = declared != nullptr && declared->array_size > array->array_size;  // by elements
            const std::string type =
                apart ? fmt::format("{}[{}]", declared->glsl_type, declared->array_size) : type_name(*array);
            report_unknown(written, fmt::format("'{}' is {} {}, which has no '{}'", base, article(type), type,
                                                std::string_view(written.name).substr(base.size())));
            return;
        }
        if (declared != nullptr) {
            if (!laddered) report_unused(written, *declared);
            return;
        }
        std::vector<std::string_view> names;  // a name that is listed would be given twice
        for (const ActiveUniform& uniform : active) {
            const std::string_view name = without_zero(uniform.name);
            if (is_internal(name) || (laddered && uniform.system) || is_listed(program, name)) continue;
            names.push_back(name);
        }
        const std::string_view near = nearest(written.name, names);
        if (laddered && near.empty()) return;
        Diagnostic& said = report_unknown(written, fmt::format("no shader of program '{}' declares '{}'",
                                                               scene_.programs[program].name, written.name));
        if (near.empty()) return;
        said.help = fmt::format("did you mean '{}'?", near);
        said.fixes.push_back({written.name_span, std::string(near)});
    }

    Diagnostic& report_unknown(const UniformValue& written, std::string message) {
        return diagnostics_.warning("unknown-uniform", written.name_span, std::move(message));
    }

    void report_unused(const UniformValue& written, const glsl::DeclaredUniform& declared) {
        const bool never = declared.functions.empty() && !declared.used;
        const std::string_view path = declared_->sources.name(declared.span.file);
        const std::string_view rest = std::string_view(written.name).substr(declared.name.size());
        Diagnostic& said = report_unknown(
            written, fmt::format("'{}' is declared in {}:{} {}", declared.name, path.substr(path.rfind('/') + 1),
                                 declared_->sources.position(declared.span.file, declared.span.begin).line,
                                 never          ? "and never used"
                                 : rest.empty() ? "but changes nothing that is drawn"
                                                : fmt::format("but no '{}' of it changes what is drawn", rest)));
        said.help = "use it in the shader, or remove it from the Program line";
        said.notes.push_back({declared.span, "declared here"});
    }

    const glsl::DeclaredUniform* find_declared(Index program, std::string_view name) const {
        if (declared_ == nullptr || program >= declared_->programs.size()) return nullptr;
        const auto found = ranges::find(declared_->programs[program], name, &glsl::DeclaredUniform::name);
        return found == declared_->programs[program].end() ? nullptr : &*found;
    }

    bool is_listed(Index program, std::string_view name) const {
        return ranges::any_of(scene_.programs[program].uniforms,
                              [&](const UniformValue& value) { return without_zero(value.name) == name; });
    }

    // Guesses the type of a value in a program whose uniforms are unknown.
    static ActiveUniform guess(const UniformValue& written) {
        ActiveUniform uniform;
        uniform.name = written.name;
        uniform.glsl_type = "float";
        const int count = static_cast<int>(written.values.size());
        if (written.kind == Kind::boolean) {
            uniform.type = ValueType::bool_;
            uniform.glsl_type = "bool";
        } else if (written.kind == Kind::color || written.kind == Kind::array) {
            uniform.components = std::clamp(count, 1, 4);
            if (count > 4) {
                uniform.components = 1;
                uniform.array_size = count;
            }
        }
        return uniform;
    }

    // Takes over the type, and the value that the uniform has after linking.
    static void take_type(Control& control, const ActiveUniform& uniform) {
        control.type = uniform.type;
        control.components = std::max(uniform.components, 1);
        control.array_size = std::max(uniform.array_size, 1);
        const auto total = static_cast<std::size_t>(control.components) * static_cast<std::size_t>(control.array_size);
        control.value = uniform.initial;
        control.value.resize(total, 0.);
        for (double& value : control.value) value = fit_to_type(value, control.type);
    }

    void fit(Control& control, const UniformValue& written, const ActiveUniform& uniform) {
        take_type(control, uniform);
        switch (written.kind) {
            case Kind::range:
                fit_range(control, written, uniform);
                break;
            case Kind::boolean:
                fit_boolean(control, written, uniform);
                break;
            case Kind::color:
                fit_color(control, written, uniform);
                break;
            case Kind::scalar:
            case Kind::array:
                fit_values(control, written.values, written, uniform);
                break;
        }
    }

    // Copies as many of `values` as the control has room for, converted to the uniform's type.
    void fit_values(Control& control, const std::vector<double>& values, const UniformValue& written,
                    const ActiveUniform& uniform) {
        if (values.size() != control.value.size()) report_count(written, uniform, control.value.size(), values.size());
        for (std::size_t i = 0; i < std::min(values.size(), control.value.size()); ++i)
            control.value[i] = typed(control, values[i], written, uniform);
    }

    void report_count(const UniformValue& written, const ActiveUniform& uniform, std::size_t takes, std::size_t given) {
        diagnostics_.warning("uniform-value-count", written.span,
                             fmt::format("'{}' is {} and takes {} {}, not {}", written.name, a_type(uniform), takes,
                                         takes == 1 ? "number" : "numbers", given),
                             "the given numbers are used");
    }

    double typed(const Control& control, double value, const UniformValue& written, const ActiveUniform& uniform) {
        const double fitted = fit_to_type(value, control.type);
        if (fitted != value) {
            const std::string becomes = control.type == ValueType::bool_ ? "true" : fmt::format("{}", fitted);
            diagnostics_.warning(
                "uniform-value-type", written.span,
                fmt::format("'{}' is {}: {} is converted to {}", written.name, a_type(uniform), value, becomes));
        }
        return fitted;
    }

    void fit_boolean(Control& control, const UniformValue& written, const ActiveUniform& uniform) {
        const std::vector<double> values{written.values.empty() || written.values[0] == 0 ? 0. : 1.};
        fit_values(control, values, written, uniform);
        const bool flag = control.type == ValueType::bool_ || (control.type != ValueType::sampler && is_word(written));
        if (flag && control.value.size() == 1) control.widget = Widget::check_box;
    }

    void fit_color(Control& control, const UniformValue& written, const ActiveUniform& uniform) {
        std::vector<double> values = written.values;
        const bool color = control.array_size == 1 && (control.components == 3 || control.components == 4) &&
                           (control.type == ValueType::float_ || control.type == ValueType::double_);
        if (color && control.components == 4 && values.size() == 3) values.resize(4, 1);
        if (color && control.components == 3 && values.size() == 4) values.resize(3);
        fit_values(control, values, written, uniform);
        if (color) control.widget = Widget::color;
    }

    void fit_range(Control& control, const UniformValue& written, const ActiveUniform& uniform) {
        if (written.values.size() < 3) {
            fit_values(control, written.values, written, uniform);
            if (control.type == ValueType::bool_ && control.value.size() == 1) control.widget = Widget::check_box;
            return;
        }
        const Range range = mend_range(control, written, uniform);
        // A range belongs to one number; for a vector it changes all components together.
        const double current = typed(control, range.current, written, uniform);
        if (control.value.size() > 1) {
            diagnostics_.warning("uniform-value-count", written.span,
                                 fmt::format("'{}' is {}, but a range has one number", written.name, a_type(uniform)),
                                 "all components get that number; write [1. 2. 3.] to set each one");
        }
        std::fill(control.value.begin(), control.value.end(), current);
        control.min = range.min;
        control.max = range.max;
        if (control.type == ValueType::matrix || control.type == ValueType::sampler || control.array_size > 1) return;
        control.widget = control.type == ValueType::bool_ ? Widget::check_box : Widget::slider;
        if (control.widget == Widget::slider && range.min == range.max) control.widget = Widget::none;
    }

    // Returns a range with min <= current <= max, finite and of the uniform's type.
    Range mend_range(const Control& control, const UniformValue& written, const ActiveUniform& uniform) {
        std::vector<double> v = written.values;
        for (double& number : v) number = std::isnan(number) ? 0 : number;
        Range range{v[0], v[1], v[2]};
        if (control.type == ValueType::bool_) return {0, range.current, 1};
        const bool reversed = range.min > range.max;
        if (reversed) {
            std::swap(range.min, range.max);
            const UniformValue meant = meant_by(control, written, v);
            warn_range("range-reversed", written, "the minimum is above the maximum; they are swapped")
                .fixes.push_back({written.span, text_of::uniform(meant)});
        }
        if (range.current < range.min || range.current > range.max) {
            if (!reversed) warn_order(meant_by(control, written, v), written, range);
            range.min = std::min(range.min, range.current);
            range.max = std::max(range.max, range.current);
            if (reversed)
                warn_range("range-widened", written,
                           fmt::format("the current value {} is outside; the range is widened", range.current));
        }
        const Range limited = limit_range(range, control.type);
        if (limited.min != range.min || limited.max != range.max) {
            warn_range("range-limited", written,
                       fmt::format("{} has no values {} {}; {} to {} is used", a_type(uniform),
                                   limited.min != range.min ? "below" : "above",
                                   limited.min != range.min ? limited.min : limited.max, limited.min, limited.max));
        }
        if (limited.min == limited.max)
            warn_range("range-empty", written, "minimum and maximum are equal, so there is no slider");
        return {limited.min, range.current, limited.max};
    }

    // What was meant by a range whose numbers are in no order: a value for each component of a vector of three, or the
    // same numbers in order.
    static UniformValue meant_by(const Control& control, UniformValue written, const std::vector<double>& numbers) {
        written.values.assign(numbers.begin(), numbers.begin() + 3);
        const auto in_color = [](double v) { return v >= 0 && v <= 1; };
        if (control.array_size == 1 && control.components == 3)
            written.kind =
                ranges::all_of(written.values, in_color) ? UniformValue::Kind::color : UniformValue::Kind::array;
        else
            ranges::sort(written.values);
        return written;
    }

    // <min max current> or <current min max>, most likely. What is written is kept: the second number is the current
    // one.
    void warn_order(const UniformValue& meant, const UniformValue& written, const Range& range) {
        Diagnostic& said = diagnostics_.warning(
            "range-order", written.span,
            fmt::format("range of '{}': its numbers are <min current max>, and the current one, {}, is {}",
                        written.name, range.current,
                        range.current > range.max ? "above the maximum" : "below the minimum"),
            fmt::format("did you mean '{}'? as written, the value is {}, and the range is extended to it",
                        text_of::uniform(meant), range.current));
        said.fixes.push_back({written.span, text_of::uniform(meant)});
    }

    Diagnostic& warn_range(std::string_view code, const UniformValue& written, const std::string& what) {
        return diagnostics_.warning(code, written.span, fmt::format("range of '{}': {}", written.name, what));
    }

    void add_unlisted(Index program, const std::vector<ActiveUniform>& active) {
        for (const ActiveUniform& uniform : active) {
            const std::string_view name = without_zero(uniform.name);
            if (uniform.system || is_internal(name) || controls_.find(program, name) != nullptr) continue;
            Control control = control_of(program, name, scene_.programs[program].span);
            control.listed = false;
            take_type(control, uniform);
            control.initial = control.value;
            suggest_widget(control);
            unlisted_.push_back(std::move(control));
        }
        for (Control& control : unlisted_) controls_.items.push_back(std::move(control));
        unlisted_.clear();
    }

    const Scene& scene_;
    Diagnostics& diagnostics_;
    const Declared* declared_;
    Controls controls_;
    std::vector<Control> unlisted_;
};

}  // namespace

const Control* Controls::find(Index program, std::string_view name) const {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Control& control) {
        return control.program == program && without_zero(control.name) == without_zero(name);
    });
    return found == items.end() ? nullptr : &*found;
}

Control* Controls::find(Index program, std::string_view name) {
    return const_cast<Control*>(static_cast<const Controls*>(this)->find(program, name));
}

Controls make_controls(const Scene& scene, const std::vector<std::vector<ActiveUniform>>& active,
                       Diagnostics& diagnostics, const Declared* declared) {
    Controls controls = Maker(scene, diagnostics, declared).make(active);
    controls.rungs = marked_rungs(scene);
    return controls;
}

std::vector<double> values_of(const Controls& controls) {
    std::vector<double> values;
    for (const Control& control : controls.items)
        values.insert(values.end(), control.value.begin(), control.value.end());
    return values;
}

void set_values(Controls& controls, const std::vector<double>& values) {
    auto next = values.begin();
    for (Control& control : controls.items)
        for (double& value : control.value)
            if (next != values.end()) value = *next++;
}

bool same_uniforms(const Controls& a, const Controls& b) {
    return ranges::equal(a.items, b.items, [](const Control& x, const Control& y) {
        return x.program == y.program && x.name == y.name && x.active == y.active && x.value.size() == y.value.size();
    });
}

std::vector<std::string> control_names(const Scene& scene, const Controls& controls) {
    const std::vector<std::string> programs = program_names(program_ids(scene));
    std::vector<std::string> names;
    names.reserve(controls.items.size());
    for (const Control& control : controls.items) names.push_back(programs[control.program] + "." + control.name);
    return names;
}

void take_value(const Control& from, Control& control, Follow follow) {
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

void carry_over(const Controls& from, const Scene& from_scene, Controls& to, const Scene& to_scene) {
    carry_over(from.rungs, from_scene, to.rungs, to_scene);
    std::map<std::pair<Index, std::string_view>, std::size_t> places;  // by their programs in the new scene
    const std::vector<Index> programs = carried_programs(program_ids(from_scene), program_ids(to_scene));
    for (std::size_t i = 0; i < from.items.size(); ++i)
        places.emplace(std::pair(programs[from.items[i].program], std::string_view(from.items[i].name)), i);
    for (std::size_t i = 0; i < to.items.size(); ++i) {
        const auto found = places.find({to.items[i].program, to.items[i].name});
        if (found == places.end()) continue;
        const Control& old = from.items[found->second];
        Control& control = to.items[i];
        if (old.type != control.type || old.components != control.components || old.array_size != control.array_size)
            continue;
        if (old.initial == control.initial) take_value(old, control);
    }
}

}  // namespace snell
