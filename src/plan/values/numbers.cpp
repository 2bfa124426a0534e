#include "src/plan/values/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "parser/text/number.h"
#include "src/plan/values/declared.h"

namespace snell {

namespace {

template <typename... Arguments>
double read_back(double otherwise, fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    std::array<char, 64> text{};
    const auto written = fmt::format_to_n(text.data(), text.size(), format, std::forward<Arguments>(arguments)...);
    double value = otherwise;
    read_real(text.data(), text.data() + std::min(written.size, text.size()), value);
    return unsigned_zero(value);
}

bool by_ratio(const Track& track) {
    return track.logarithmic && track.min > 0 && track.max > track.min && std::isfinite(track.max / track.min);
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

double tidy_color(double value) {
    const auto decimals = [&](int count) { return read_back(value, "{:.{}f}", value, count); };
    if (!(value >= 0 && value <= 1)) return decimals(3);
    for (int count = 0; count < 3; ++count)
        if (std::round(255 * decimals(count)) == std::round(255 * value)) return decimals(count);
    return decimals(3);
}

std::string shown(double value, double min, double max, bool integral) {
    value = unsigned_zero(value);
    if (integral) return fmt::format("{:.0f}", value);
    const double range = std::max({max - min, 0.0});
    const double size = std::max(std::abs(value), range);
    if (!(size < 1e7) || !std::isfinite(range)) return fmt::format("{:.6g}", value);
    if (range <= 0) return fmt::format("{:.7g}", value);
    const int digits = static_cast<int>(std::ceil(std::log10(range) - 1e-9));  // before the decimal point
    const int decimals = digits <= 0 ? 4 - digits : 5 - digits;
    if (decimals > 9) return fmt::format("{:.4e}", value);
    std::string text = fmt::format("{:.{}f}", value, std::clamp(decimals, 1, 9));
    const bool two_digits = std::abs(value) * std::pow(10, decimals) >= 10;
    return two_digits || read_whole<double>(text) == value ? text : fmt::format("{:.4g}", value);
}

std::string exact(double value) { return fmt::format("{}", unsigned_zero(value)); }

namespace {

// Reads sums of products of numbers, signs and parentheses. A failure makes the result NaN.
class Evaluator {
public:
    explicit Evaluator(std::string_view text) : rest_(text) {}
    double run() {
        const double value = sum();
        return take_blanks().empty() ? value : failure;
    }

private:
    static constexpr double failure = std::numeric_limits<double>::quiet_NaN();

    std::string_view take_blanks() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t"), rest_.size()));
        return rest_;
    }
    bool take(std::string_view word) {
        if (!take_blanks().starts_with(word)) return false;
        rest_.remove_prefix(word.size());
        return true;
    }
    double sum() {
        double value = product();
        while (true) {
            if (take("+"))
                value += product();
            else if (take("-"))
                value -= product();
            else
                return value;
        }
    }
    double product() {
        double value = factor();
        while (true) {
            if (take("*"))
                value *= factor();
            else if (take("/")) {
                const double by = factor();
                value = by == 0 ? failure : value / by;
            } else
                return value;
        }
    }
    double factor() {
        if (take("-")) return -operand();
        take("+");
        return operand();
    }
    double operand() {
        if (take("pi")) return std::numbers::pi;
        if (!take("(")) return number();
        const double value = sum();
        return take(")") ? value : failure;
    }
    double number() {
        std::array<char, 128> digits{};
        const std::size_t length = take_blanks().copy(digits.data(), digits.size());
        const auto end_of_text = digits.begin() + static_cast<std::ptrdiff_t>(length);
        std::replace(digits.begin(), end_of_text, ',', '.');
        if (length == 0 || !((digits[0] >= '0' && digits[0] <= '9') || digits[0] == '.')) return failure;
        double value = 0;
        const auto [end, error] = read_real(digits.data(), digits.data() + length, value);
        if (error == std::errc::result_out_of_range)
            value = std::numeric_limits<double>::infinity();
        else if (error != std::errc())
            return failure;
        rest_.remove_prefix(static_cast<std::size_t>(end - digits.data()));
        return value;
    }

    std::string_view rest_;
};

}  // namespace

bool is_number(std::string_view text) { return !std::isnan(Evaluator(text).run()); }

std::optional<double> evaluated(std::string_view text) {
    const double value = Evaluator(text).run();
    return std::isfinite(value) ? std::optional(value) : std::nullopt;
}

bool is_whole(ValueType type) {
    return type == ValueType::int_ || type == ValueType::uint_ || type == ValueType::sampler;
}

std::optional<double> fitting(double value, ValueType type) {
    if (is_whole(type)) value = std::round(value);
    value = unsigned_zero(value);
    return std::isfinite(value) && fit_to_type(value, type) == value ? std::optional(value) : std::nullopt;
}

std::optional<double> typed(std::string_view text, ValueType type) {
    const std::optional<double> found = evaluated(text);
    const bool fraction = found && is_whole(type) && *found != std::round(*found);
    return found && !fraction ? fitting(*found, type) : std::nullopt;
}

// The intermediate results cannot overflow, for any range.
double fraction_of(double value, const Track& track) {
    if (by_ratio(track)) return std::clamp(std::log(value / track.min) / std::log(track.max / track.min), 0.0, 1.0);
    const double half = track.max / 2 - track.min / 2;
    if (!(half > 0) || !std::isfinite(value)) return 0;
    return std::clamp((value / 2 - track.min / 2) / half, 0.0, 1.0);
}

double exact_at(double fraction, const Track& track) {
    return by_ratio(track) ? track.min * std::pow(track.max / track.min, fraction)
                           : track.min * (1 - fraction) + track.max * fraction;
}

double value_at(double fraction, const Track& track, bool fine) {
    if (fraction <= 0) return track.min;
    if (fraction >= 1) return track.max;
    const double value = exact_at(fraction, track);
    if (is_whole(track.type)) return std::round(value);
    if (by_ratio(track)) return tidy_relative(value, track.min, track.max, fine);
    return tidy(std::clamp(value, track.min, track.max), track.min, track.max, fine);
}

double stepped(double value, double steps, const Track& track) {
    if (steps == 0 || !(track.min < track.max)) return value;
    if (!is_whole(track.type)) return value_at(fraction_of(value, track) + steps / 100, track, std::abs(steps) < 1);
    const double coarse = std::abs(steps) >= 10 ? std::round((track.max - track.min) / 10) : 1;
    return std::clamp(value + std::copysign(std::max(1., coarse), steps), track.min, track.max);
}

}  // namespace snell
