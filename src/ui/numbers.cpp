#include "src/ui/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace snell::ui {

std::string shown(double value, double min, double max, bool integral) {
    if (integral) return fmt::format("{:.0f}", value);
    const double range = std::max({max - min, 0.0});
    const double size = std::max(std::abs(value), range);
    if (!(size < 1e7)) return fmt::format("{:.6g}", value);
    if (range <= 0) return fmt::format("{:.7g}", value);
    const int digits = static_cast<int>(std::ceil(std::log10(range) - 1e-9));  // before the point
    const int decimals = digits <= 0 ? 4 - digits : 5 - digits;
    if (decimals > 9) return fmt::format("{:.4e}", value);
    return fmt::format("{:.{}f}", value, std::clamp(decimals, 1, 9));
}

std::string exact(double value) { return fmt::format("{}", value); }

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
