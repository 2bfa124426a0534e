// Reads the numbers of scenes, and reads and writes doubles: the same on every platform and in every locale.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "parser/text/diagnostic.h"

namespace snell {

// Parses the numbers of scenes. Independent of the locale.

enum class NumberFault : std::uint8_t {
    none,
    second_point,  // "0.1." is read as 0.1
    suffix,        // "1.f", "60x" are read as 1 and 60
    not_a_number,
    hexadecimal,
    d_exponent,
    odd_minus,
    not_finite,
    too_large,  // beyond the range of float, which is the type that reaches the GPU
};

struct Number {
    double value = 0;
    NumberFault fault = NumberFault::none;
    bool usable() const { return fault <= NumberFault::suffix; }
};

// Parses a whole word as a number; `fault` says what is wrong with it.
Number read_number(std::string_view text);

// True if the text begins like a number, whether valid or not.
bool looks_numeric(std::string_view text);
// True if the text can only be meant as a number, unlike "3D" or "1.bmp".
bool plausible_number(std::string_view text);

// True if the text is the question mark of a template, or several.
bool unfilled(std::string_view text);

// True if the number was written without point and exponent.
bool written_integral(std::string_view text);

// Reports the fault of a number: a warning if its value is usable, otherwise an error that says what is used `instead`
// of a word that is not a number.
void report_number(Collector& report, const Number& number, std::string_view text, Span span,
                   std::string_view instead = {});

// Reads and writes doubles: the same on every platform, whatever its standard library offers (from_chars and to_chars
// of doubles are missing in libc++ before version 20), and whatever the locale is.

// As std::from_chars: without blanks, '+' and "0x"; `value` stays as it is after an error.
std::from_chars_result read_real(const char* first, const char* last, double& value);

// The number that the whole text is; nullopt if it is none, or out of the type's range.
template <class Number>
std::optional<Number> read_whole(std::string_view text) {
    Number value{};
    const char* const end = text.data() + text.size();
    std::from_chars_result result;
    if constexpr (std::is_same_v<Number, double>)
        result = read_real(text.data(), end, value);
    else
        result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

// Return the shortest text that reads back to the same bits: with an exponent where that is shorter, such as "1e+05".
std::string real_text(double value);
std::string real_text(float value);
// Returns it without an exponent.
std::string fixed_text(double value);

}  // namespace snell
