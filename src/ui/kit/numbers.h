// Formats and parses the numbers of sliders.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace snell::ui {

// Formats a value with as many decimals as a thousandth of the range needs, but at least the four that glman shows.
std::string shown(double value, double min, double max, bool integral);
// Rounds a value that was dragged to, to as many decimals as are shown (two more if `fine`), so that a saved number is
// short. The result stays within the range.
double tidy(double value, double min, double max, bool fine);
// Does the same with significant digits, for ranges over several decades.
double tidy_relative(double value, double min, double max, bool fine);
// Converts a float to the double that its shortest text reads as.
double tidy(float value);
// Formats a double as the shortest text that reads back to the same value.
std::string exact(double value);
// Formats as "1 error" or "2 errors".
std::string counted(std::size_t count, std::string_view noun);
// Parses a number that a user typed; "+" and surrounding blanks are allowed. Returns nullopt if it is not a number, not
// finite, or does not fit a float (with `integral`, a 32-bit integer, to which fractions are rounded).
std::optional<double> typed(std::string_view text, bool integral);

}  // namespace snell::ui
