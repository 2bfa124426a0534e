// Numbers as sliders show and read them.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace snell::ui {

// As many decimals as a step of a thousandth of the range needs, four at least for what glman shows with four.
std::string shown(double value, double min, double max, bool integral);
// A value that was dragged to, with as many decimals as are shown (two more where `fine`), so that saving it gives a
// short number. Within the range still.
double tidy(double value, double min, double max, bool fine);
// The same by digits that count, for ranges over several decades.
double tidy_relative(double value, double min, double max, bool fine);
// Of a float: the double that its shortest text reads as.
double tidy(float value);
// The shortest text that reads back as the same double.
std::string exact(double value);
// A number as a user types it: "+" and blanks around allowed. None where it is no number, not finite, or no
// float (integral: no 32-bit integer; fractions are rounded).
std::optional<double> typed(std::string_view text, bool integral);

}  // namespace snell::ui
