#include "src/ui/kit/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

namespace snell::ui {

namespace {

template <typename... Arguments>
double read_back(double otherwise, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::array<char, 64> text{};
    const auto written = fmt::format_to_n(text.data(), text.size(), format, std::forward<Arguments>(arguments)...);
    double value = otherwise;
    std::from_chars(text.data(), text.data() + std::min(written.size, text.size()), value);
    return value;
}

}  // namespace

double tidy(double value, double min, double max, bool fine) {
    const double range = max - min;
    if (!(range > 0) || !std::isfinite(range) || range > 1e7) return value;
    const int digits = static_cast<int>(std::ceil(std::log10(range) - 1e-9));  // before the decimal point
    const int decimals = (digits <= 0 ? 4 - digits : std::max(5 - digits, 1)) + (fine ? 2 : 0);
    if (decimals > 15) return value;
    return std::clamp(read_back(value, "{:.{}f}", value, decimals), min, max);
}

double tidy_relative(double value, double min, double max, bool fine) {
    return std::clamp(read_back(value, "{:.{}e}", value, fine ? 5 : 3), min, max);
}

double tidy(float value) { return read_back(static_cast<double>(value), "{}", value); }

std::string shown(double value, double min, double max, bool integral) {
    if (integral) return fmt::format("{:.0f}", value);
    const double range = std::max({max - min, 0.0});
    const double size = std::max(std::abs(value), range);
    if (!(size < 1e7)) return fmt::format("{:.6g}", value);
    if (range <= 0) return fmt::format("{:.7g}", value);
    const int digits = static_cast<int>(std::ceil(std::log10(range) - 1e-9));  // before the decimal point
    const int decimals = digits <= 0 ? 4 - digits : 5 - digits;
    if (decimals > 9) return fmt::format("{:.4e}", value);
    return fmt::format("{:.{}f}", value, std::clamp(decimals, 1, 9));
}

std::string exact(double value) { return fmt::format("{}", value); }

std::string counted(std::size_t count, std::string_view noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

std::optional<double> typed(std::string_view text, bool integral) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    if (integral) {
        value = std::round(value);
        if (value < std::numeric_limits<int>::min() || value > std::numeric_limits<int>::max()) return std::nullopt;
    }
    if (std::abs(value) > std::numeric_limits<float>::max()) return std::nullopt;
    return value;
}

}  // namespace snell::ui
