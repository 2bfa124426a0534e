#include "parser/text/number.h"

#include <array>
#include <cmath>
#include <cstdlib>

#include <fast_float/fast_float.h>
#include <fmt/format.h>

#include "parser/text/words.h"

namespace snell {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }

// Half a unit in the last place above the largest float: what rounds to infinity.
constexpr double float_overflow = 0x1.ffffffp127;

bool names_no_number(std::string_view text) {
    if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
    return same_word(text, "nan") || same_word(text, "inf") || same_word(text, "infinity") || text.starts_with("1.#");
}

// Dashes and minus signs that word processors put in place of '-'.
bool odd_minus(std::string_view text) {
    if (text.empty() || static_cast<unsigned char>(text[0]) < 0x80) return false;
    const utf8::Char c = utf8::decode(text, 0);
    return c.valid &&
           (c.code == 0x2212 || (c.code >= 0x2010 && c.code <= 0x2014) || c.code == 0xFE63 || c.code == 0xFF0D);
}

// A number that read_real finds out of range is either too large or vanishingly small: which of them follows
// from where its first digit that counts stands.
bool vanishes(std::string_view text) {
    std::size_t i = 0;
    long place = 0;
    bool point = false, found = false;
    for (; i < text.size() && (digit(text[i]) || text[i] == '.' || text[i] == '-'); ++i) {
        if (text[i] == '.') point = true;
        if (!digit(text[i])) continue;
        found = found || text[i] != '0';
        if (!point && found) ++place;
        if (point && !found) --place;
    }
    if (i >= text.size() || lower(text[i]) != 'e') return place <= 0;
    const bool negative = i + 1 < text.size() && text[i + 1] == '-';
    if (i + 1 < text.size() && (negative || text[i + 1] == '+')) ++i;
    long exponent = 0;
    for (++i; i < text.size() && digit(text[i]); ++i)
        if (exponent < 1'000'000'000) exponent = exponent * 10 + (text[i] - '0');
    return place + (negative ? -exponent : exponent) <= 0;
}

// What follows a number and is no part of it: read as C's atof would, except where another meaning is likely.
NumberFault fault_of_rest(std::string_view number, std::string_view rest) {
    if (rest.find_first_not_of(".0123456789") == std::string_view::npos && rest[0] == '.')
        return NumberFault::second_point;
    if (lower(rest[0]) == 'x' && (number == "0" || number == "-0")) return NumberFault::hexadecimal;
    if (lower(rest[0]) == 'd' && rest.size() > 1 && (digit(rest[1]) || rest[1] == '-' || rest[1] == '+'))
        return NumberFault::d_exponent;
    return NumberFault::suffix;
}

// Plain decimals of few digits, which nearly all numbers are: a whole number below 2^53 divided by a power of ten
// that a double holds exactly is rounded once, and so is what read_real gives (Clinger 1990). Nothing for others.
std::optional<double> plain_decimal(std::string_view text) {
    constexpr std::array<double, 16> powers{1,   1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                            1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    if (text.size() > 16) return std::nullopt;  // 15 digits and a point
    std::uint64_t digits = 0;
    std::size_t count = 0, places = 0;
    bool point = false;
    for (const char c : text) {
        if (digit(c)) {
            digits = digits * 10 + static_cast<std::uint64_t>(c - '0');
            ++count;
            places += point ? 1 : 0;
        } else if (c == '.' && !point) {
            point = true;
        } else {
            return std::nullopt;
        }
    }
    if (count == 0 || count > 15) return std::nullopt;
    const double value = static_cast<double>(digits) / powers[places];
    return negative ? -value : value;
}

}  // namespace

Number read_number(std::string_view text) {
    if (const std::optional<double> value = plain_decimal(text)) return {*value, NumberFault::none};
    std::string_view digits = text;
    if (!digits.empty() && digits[0] == '+') digits.remove_prefix(1);
    const std::size_t sign = !digits.empty() && digits[0] == '-' && digits.size() == text.size() ? 1 : 0;
    const bool starts =
        digits.size() > sign &&
        (digit(digits[sign]) || (digits[sign] == '.' && digits.size() > sign + 1 && digit(digits[sign + 1])));
    if (!starts) {
        if (names_no_number(text)) return {0, NumberFault::not_finite};
        return {0, odd_minus(text) ? NumberFault::odd_minus : NumberFault::not_a_number};
    }
    Number number;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = read_real(digits.data(), end, number.value);
    const std::string_view read(digits.data(), static_cast<std::size_t>(stop - digits.data()));
    if (error == std::errc::result_out_of_range) {
        number.value = 0;
        if (!vanishes(read)) return {0, NumberFault::too_large};
    }
    if (stop != end) {
        if (names_no_number(text)) return {0, NumberFault::not_finite};
        number.fault = fault_of_rest(read, {stop, static_cast<std::size_t>(end - stop)});
    }
    if (!number.usable()) number.value = 0;
    if (number.usable() && std::abs(number.value) >= float_overflow) return {0, NumberFault::too_large};
    return number;
}

bool looks_numeric(std::string_view text) {
    if (text.empty()) return false;
    std::size_t i = text[0] == '+' || text[0] == '-' ? 1 : 0;
    if (i < text.size() && text[i] == '.') ++i;
    return (i < text.size() && digit(text[i])) || names_no_number(text) || odd_minus(text);
}

bool unfilled(std::string_view text) { return !text.empty() && text.find_first_not_of('?') == text.npos; }

bool plausible_number(std::string_view text) {
    if (!looks_numeric(text)) return false;
    const Number number = read_number(text);
    return number.fault != NumberFault::suffix || text.ends_with('f') || text.ends_with('F');
}

bool written_integral(std::string_view text) {
    for (const char c : text)
        if (c == '.' || c == 'e' || c == 'E') return false;
    return true;
}

void report_number(Collector& report, const Number& number, std::string_view text, Span span,
                   std::string_view instead) {
    const std::string quoted = "'" + std::string(text.substr(0, 60)) + "'";
    switch (number.fault) {
        case NumberFault::none:
            break;
        case NumberFault::second_point:
            report.warning("second-point", span, quoted + " has a second point; only the part before it is read");
            break;
        case NumberFault::suffix:
            report.warning("number-suffix", span, quoted + " has something after the number, which is ignored");
            break;
        case NumberFault::not_a_number:
            report.error("not-a-number", span, quoted + (unfilled(text) ? " was never filled in" : " is not a number"),
                         instead.empty() ? std::string() : "the default, " + std::string(instead) + ", is used");
            break;
        case NumberFault::hexadecimal:
            report.error("hexadecimal-number", span, quoted + " is hexadecimal", "write the number in decimal");
            break;
        case NumberFault::d_exponent:
            report.error("d-exponent", span, quoted + " has an exponent of another language", "write 'e' for 'd': 1e3");
            break;
        case NumberFault::odd_minus:
            report.error(
                "odd-minus", span,
                quoted + " begins with " + utf8::code_point(utf8::decode(text, 0).code) + ", which is not a minus sign",
                "type the minus sign of the keyboard: -");
            break;
        case NumberFault::not_finite:
            report.error("not-finite", span, quoted + " is not a finite number", "write a number in digits");
            break;
        case NumberFault::too_large:
            report.error("number-too-large", span, quoted + " is too large", "numbers go up to 3.4e38");
            break;
    }
}

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
