#include "src/plan/values/fit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include "parser/text/words.h"

namespace snell {

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
    constexpr double whole_limit = 1'073'741'823;  // half of int's range
    constexpr double real_limit = 1e38;
    const bool whole = type == ValueType::int_ || type == ValueType::uint_ || type == ValueType::sampler;
    const double high = whole ? whole_limit : real_limit;
    const double low = type == ValueType::uint_ || type == ValueType::sampler ? 0 : -high;
    if (whole) {
        range.min = std::round(range.min);
        range.max = std::round(range.max);
    }
    range.min = std::clamp(range.min, low, high);
    range.max = std::clamp(range.max, low, high);
    return range;
}

namespace {

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
