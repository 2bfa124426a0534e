#include "parser/text/real.h"

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace snell {
namespace {

// A finite number is sign, digits and exponent: d.ddd · 10^exponent.
struct Decimal {
    bool negative = false;
    std::string_view digits;  // the fewest that read back to the same bits
    int exponent = 0;
};

// `buffer` holds the digits.
template <class Real>
Decimal shortest(Real value, std::array<char, 64>& buffer) {
    Decimal decimal{std::signbit(value), {}, 0};
    // Without a precision, fmt writes the fewest digits, in one of the forms 0.00123, 123, 12.3 and 1.23e+20.
    // Its format_to would instantiate all of its formatter, which takes the compiler seconds.
    const std::string text = fmt::format("{}", std::abs(value));
    const char* const end = text.data() + text.size();
    std::size_t count = 0;
    bool point = false;
    int places = 0;
    const char* at = text.data();
    for (; at != end && *at != 'e'; ++at) {
        if (*at == '.') {
            point = true;
            continue;
        }
        if (point) ++places;
        if (count > 0 || *at != '0') buffer[count++] = *at;
    }
    int written = 0;
    if (at != end) {
        const bool negative = at[1] == '-';
        std::from_chars(at + 2, end, written);
        if (negative) written = -written;
    }
    decimal.exponent = static_cast<int>(count) - 1 - places + written;
    while (count > 1 && buffer[count - 1] == '0') --count;
    if (count == 0) {
        buffer[count++] = '0';
        decimal.exponent = 0;
    }
    decimal.digits = {buffer.data(), count};
    return decimal;
}

std::string scientific(const Decimal& decimal) {
    const int exponent = std::abs(decimal.exponent);
    std::string text(decimal.digits.substr(0, 1));
    if (decimal.digits.size() > 1) text += '.';
    text += decimal.digits.substr(1);
    text += decimal.exponent < 0 ? "e-" : "e+";
    if (exponent < 10) text += '0';
    return text += std::to_string(exponent);
}

std::string fixed(const Decimal& decimal, double value) {
    const auto count = static_cast<int>(decimal.digits.size());
    if (decimal.exponent < 0)
        return "0." + std::string(static_cast<std::size_t>(-decimal.exponent - 1), '0') + std::string(decimal.digits);
    // Digits beyond the shortest are those of the value itself.
    if (decimal.exponent >= count) return fmt::format("{:.0f}", std::abs(value));
    std::string text(decimal.digits);
    if (decimal.exponent + 1 < count) text.insert(static_cast<std::size_t>(decimal.exponent) + 1, 1, '.');
    return text;
}

template <class Real>
std::string text_of(Real value, bool exponent) {
    if (!std::isfinite(value)) return fmt::format("{}", value);
    std::array<char, 64> buffer{};
    const Decimal decimal = shortest(value, buffer);
    std::string text = fixed(decimal, static_cast<double>(value));
    if (exponent)
        if (std::string other = scientific(decimal); other.size() < text.size()) text = std::move(other);
    return decimal.negative ? "-" + text : text;
}

}  // namespace

std::from_chars_result read_real(const char* first, const char* last, double& value) {
    double read = 0;
    const auto [end, error] = fast_float::from_chars(first, last, read);
    if (error != std::errc()) return {first, error};
    // fast_float reads numbers that are too large or too small as infinity and 0, whose own texts have none of these
    // digits.
    if (std::isinf(read) || read == 0) {
        const std::string_view text(first, static_cast<std::size_t>(end - first));
        if (text.substr(0, text.find_first_of("eE")).find_first_of("123456789") != text.npos)
            return {end, std::errc::result_out_of_range};
    }
    value = read;
    return {end, std::errc()};
}

std::string real_text(double value) { return text_of(value, true); }
std::string real_text(float value) { return text_of(value, true); }
std::string fixed_text(double value) { return text_of(value, false); }

}  // namespace snell
