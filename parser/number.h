// Numbers as scenes write them. Independent of the locale.
#pragma once

#include <cstdint>
#include <string_view>

#include "parser/report.h"

namespace snell {

enum class NumberFault : std::uint8_t {
    none,
    second_point,  // "0.1." is read as 0.1
    suffix,        // "1.f", "60x" are read as 1 and 60
    not_a_number,
    hexadecimal,
    d_exponent,
    odd_minus,
    not_finite,
    too_large,  // for a float, which is what reaches the GPU
};

struct Number {
    double value = 0;
    NumberFault fault = NumberFault::none;
    bool usable() const { return fault <= NumberFault::suffix; }
};

Number read_number(std::string_view text);

// True for text that begins like a number, right or wrong.
bool looks_numeric(std::string_view text);
// True for text that can only be meant as a number: not "3D" or "1.bmp".
bool plausible_number(std::string_view text);

// True when the number was written without point and exponent.
bool written_integral(std::string_view text);

// Says what is wrong with a number that has a fault: a warning when it is usable, else an error, and what is used
// `instead` of a word that is no number.
void report_number(Report& report, const Number& number, std::string_view text, Span span,
                   std::string_view instead = {});

}  // namespace snell
