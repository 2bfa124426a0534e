// Reads and writes doubles: the same on every platform, whatever its standard library offers (from_chars and to_chars
// of doubles are missing in libc++ before version 20), and whatever the locale is.
#pragma once

#include <charconv>
#include <string>

namespace snell {

// As std::from_chars: without blanks, '+' and "0x"; `value` stays as it is after an error.
std::from_chars_result read_real(const char* first, const char* last, double& value);

// Return the shortest text that reads back to the same bits: with an exponent where that is shorter, such as "1e+05".
std::string real_text(double value);
std::string real_text(float value);
// Returns it without an exponent.
std::string fixed_text(double value);

}  // namespace snell
