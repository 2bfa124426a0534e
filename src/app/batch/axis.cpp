#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

#include "parser/text/tidy.h"
#include "src/app/batch/shots.h"

namespace snell::app {

namespace {

template <class Number>
std::optional<Number> number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // A number beyond the largest one counts as infinite.
    if (error == std::errc::result_out_of_range) return std::numeric_limits<Number>::infinity();
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

// Splits at commas outside of brackets.
std::vector<std::string_view> elements(std::string_view text) {
    std::vector<std::string_view> parts;
    std::size_t begin = 0, depth = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '[') ++depth;
        if (text[i] == ']' && depth > 0) --depth;
        if (text[i] != ',' || depth > 0) continue;
        parts.push_back(trimmed(text.substr(begin, i - begin)));
        begin = i + 1;
    }
    parts.push_back(trimmed(text.substr(begin)));
    return parts;
}

// Interpolates with more digits than a double has, so that 1:2.5:16 gives 1.2 and not its neighbour.
double between(std::string_view first, std::string_view last, std::size_t k, std::size_t steps) {
    const auto a = number<long double>(first), b = number<long double>(last);
    const auto t = static_cast<long double>(k), n = static_cast<long double>(steps);
    return static_cast<double>((*a * (n - t) + *b * t) / n);
}

// Adds the values of FIRST:LAST:COUNT. Returns "" or the error.
std::string fill_range(Axis& axis, std::string_view text) {
    const std::size_t one = text.find(':'), two = text.find(':', one + 1);
    if (two == std::string_view::npos || text.find(':', two + 1) != std::string_view::npos)
        return fmt::format("'{}' is not a range; write FIRST:LAST:COUNT", text);
    const std::string_view first = trimmed(text.substr(0, one)), last = trimmed(text.substr(one + 1, two - one - 1)),
                           steps = trimmed(text.substr(two + 1));
    const auto a = number<double>(first), b = number<double>(last), count = number<double>(steps);
    if (!a || !b || !count || !std::isfinite(*a) || !std::isfinite(*b))
        return fmt::format("'{}' is not a range of finite numbers; write FIRST:LAST:COUNT", text);
    if (!(*count >= 1) || *count > static_cast<double>(max_pictures) || std::floor(*count) != *count)
        return fmt::format("'{}' is not a number of values from 1 to {}", steps, max_pictures);
    const auto n = static_cast<std::size_t>(*count);
    if (n == 1 && *a != *b) return fmt::format("'{}': one value cannot be at both ends", text);
    for (std::size_t k = 0; k < n; ++k) {
        const double value = k == 0 ? *a : k == n - 1 ? *b : between(first, last, k, n - 1);
        axis.values.push_back({fmt::format("{}", value), value});
    }
    return {};
}

// Adds the values of A,B,C. Returns "" or the error.
std::string fill_list(Axis& axis, std::string_view text) {
    for (const std::string_view part : elements(text)) {
        if (part.empty()) return "a value is empty";
        const auto value = number<double>(part);
        if (value && !std::isfinite(*value)) return fmt::format("'{}' is not finite", part);
        if (axis.values.size() == max_pictures) return fmt::format("there are more than {} values", max_pictures);
        axis.values.push_back({std::string(part), value});
    }
    return {};
}

}  // namespace

std::string AxisValue::shown() const {
    if (number) return fmt::format("{}", *number);
    if (written.size() > 1 && written.front() == '[' && written.back() == ']')
        return written.substr(1, written.size() - 2);
    return written;
}

std::optional<Axis> parse_axis(std::string_view text, std::string& error) {
    const std::size_t equals = text.find('=');
    Axis axis;
    axis.name = trimmed(text.substr(0, equals));
    if (equals == std::string_view::npos || axis.name.empty()) {
        error = fmt::format("'{}' varies nothing: write NAME=FIRST:LAST:COUNT or NAME=A,B,C", text);
        return std::nullopt;
    }
    const std::string_view values = trimmed(text.substr(equals + 1));
    const std::string problem =
        values.find(':') == std::string_view::npos ? fill_list(axis, values) : fill_range(axis, values);
    if (problem.empty()) return axis;
    error = fmt::format("{}: {}", axis.name, problem);
    return std::nullopt;
}

Axis frames_axis(std::size_t count) {
    Axis axis{"frame", {}, true};
    for (std::size_t k = 0; k < count; ++k) axis.values.push_back({std::to_string(k), static_cast<double>(k)});
    return axis;
}

}  // namespace snell::app
