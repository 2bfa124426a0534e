#include "src/plan/values/declared.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {

namespace {

bool scene_sets(const Program& program, std::string_view name) {
    return ranges::any_of(program.uniforms, [&](const UniformValue& u) { return u.name == name; });
}

bool sampler_of_snell(std::string_view name, std::string_view type) {
    return name == "Noise2" || name == "Noise3" ||
           (type == "sampler2D" && ranges::count(glsl::mesh_samplers, name) > 0);
}

bool names_color(std::string_view name) { return contains(name, "color") || contains(name, "colour"); }

// Widens the range for values that lie outside of the usual one.
void widen(Control& control) {
    for (const double value : control.value) {
        if (value > control.max) control.max = 2 * value;
        if (value < control.min) control.min = 2 * value;
    }
    const Range range = limit_range({control.min, 0, control.max}, control.type);
    control.min = range.min;
    control.max = range.max;
}

}  // namespace

TypeFacts type_facts(std::string_view type) {
    if (type.find("sampler") != std::string_view::npos) return {ValueType::sampler, 1};
    const char last = type.empty() ? '1' : type.back();
    const int digit = last >= '2' && last <= '4' ? last - '0' : 1;
    if (type.starts_with("mat") && type.size() > 3) return {ValueType::matrix, (type[3] - '0') * digit};
    switch (type.empty() ? 'f' : type[0]) {
        case 'i':
            return {ValueType::int_, digit};
        case 'u':
            return {ValueType::uint_, digit};
        case 'b':
            return {ValueType::bool_, digit};
        case 'd':
            return {ValueType::double_, digit};
        default:
            return {ValueType::float_, digit};
    }
}

const glsl::SystemName* find_system(const std::vector<glsl::SystemName>& names, std::string_view name,
                                    std::string_view type, const Program& program) {
    for (const glsl::SystemName& candidate : names)
        if (candidate.name == name && candidate.type == type && (candidate.legacy || !scene_sets(program, name)))
            return &candidate;
    return nullptr;
}

bool set_by_snell(const Program& program, std::string_view name, std::string_view type) {
    if (type_facts(type).type == ValueType::sampler) return sampler_of_snell(name, type) && !scene_sets(program, name);
    return name.starts_with("snell_") || find_system(glsl::system_names(), name, type, program) != nullptr;
}

ActiveUniform described(const Program& program, const glsl::DeclaredUniform& declared) {
    const TypeFacts facts = type_facts(declared.glsl_type);
    ActiveUniform uniform;
    uniform.name = declared.name;
    uniform.glsl_type = declared.glsl_type;
    uniform.type = facts.type;
    uniform.components = facts.components;
    uniform.array_size = std::max(declared.array_size, 1);
    uniform.system = set_by_snell(program, declared.name, declared.glsl_type);
    uniform.initial = declared.initial;
    uniform.initial.resize(static_cast<std::size_t>(uniform.components) * static_cast<std::size_t>(uniform.array_size));
    return uniform;
}

bool has_sliders_of_elements(const Program& program, const ActiveUniform& array) {
    if (array.array_size < 2 || array.type == ValueType::sampler || array.system) return false;
    bool element = false;
    for (const UniformValue& value : program.uniforms) {
        if (value.name == array.name) return false;
        const bool widget = (value.kind == UniformValue::Kind::range && value.values.size() > 2) ||
                            value.kind == UniformValue::Kind::boolean || value.kind == UniformValue::Kind::color;
        element = element || (widget && value.name.starts_with(array.name + "["));
    }
    return element;
}

std::vector<ActiveUniform> elements_of(const ActiveUniform& array) {
    std::vector<ActiveUniform> elements;
    for (int i = 0; i < array.array_size; ++i) {
        ActiveUniform& element = elements.emplace_back(array);
        element.name = fmt::format("{}[{}]", array.name, i);
        element.array_size = 1;
        const auto first = array.initial.begin() + static_cast<std::ptrdiff_t>(i) * array.components;
        element.initial.assign(first, first + array.components);
    }
    return elements;
}

double fit_to_type(double value, ValueType type) {
    if (std::isnan(value)) return 0;
    const auto whole = [&](double low, double high) { return std::clamp(std::round(value), low, high); };
    constexpr double int_max = std::numeric_limits<std::int32_t>::max();
    constexpr double int_min = std::numeric_limits<std::int32_t>::min();
    constexpr double float_max = std::numeric_limits<float>::max();
    switch (type) {
        case ValueType::int_:
            return whole(int_min, int_max);
        case ValueType::uint_:
            return whole(0, std::numeric_limits<std::uint32_t>::max());
        case ValueType::sampler:
            return whole(0, int_max);
        case ValueType::bool_:
            return value != 0 ? 1 : 0;
        case ValueType::double_:
            return std::clamp(value, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
        case ValueType::float_:
        case ValueType::matrix:
            return std::clamp(value, -float_max, float_max);
    }
    return value;
}

Range limit_range(Range range, ValueType type) {
    constexpr double real_limit = 1e38;
    const bool whole = type == ValueType::int_ || type == ValueType::uint_ || type == ValueType::sampler;
    const double high = whole ? fit_to_type(real_limit, type) : real_limit;
    const double low = whole ? fit_to_type(-real_limit, type) : -real_limit;
    if (whole) {
        range.min = std::round(range.min);
        range.max = std::round(range.max);
    }
    range.min = std::clamp(range.min, low, high);
    range.max = std::clamp(range.max, low, high);
    return range;
}

void suggest_widget(Control& control) {
    if (control.array_size > 1) return;
    switch (control.type) {
        case ValueType::matrix:
        case ValueType::sampler:
            return;
        case ValueType::bool_:
            if (control.components == 1) control.widget = Widget::check_box;
            return;
        case ValueType::int_:
        case ValueType::uint_:
            control.max = 10;
            break;
        case ValueType::float_:
        case ValueType::double_:
            if (control.components >= 3 && names_color(control.name)) {
                control.widget = Widget::color;
                return;
            }
            if (control.components > 1) control.min = -1;
            break;
    }
    control.widget = Widget::slider;
    widen(control);
}

}  // namespace snell
