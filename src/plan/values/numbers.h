// The numbers of sliders: as text, as a user types them, and where they are on their tracks.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "parser/text/words.h"
#include "src/plan/values/controls.h"

namespace snell {

// 0 for -0, which nobody means.
constexpr double unsigned_zero(double value) { return value + 0.; }
// Formats a value with as many decimals as a thousandth of the range needs, but at least the four that glman shows. A
// value of which these leave less than two digits has its own.
std::string shown(double value, double min, double max, bool integral);
// Rounds a value that was dragged to, to as many decimals as are shown (two more if `fine`), so that a saved number is
// short. The result stays within the range.
double tidy(double value, double min, double max, bool fine);
// Does the same with significant digits, for ranges over several decades.
double tidy_relative(double value, double min, double max, bool fine);
// Formats a double as the shortest text that reads back to the same value.
std::string exact(double value);
// Rounds the component of a colour that was picked to the fewest decimals that give the same byte.
double tidy_color(double value);
// Computes the value of a text such as "1/3", "2*pi", "-(1e3-5)" or "0,7", in doubles. Returns nullopt if it is not a
// number, or not finite.
std::optional<double> evaluated(std::string_view text);
// Whether it is a number at all, if one beyond all doubles.
bool is_number(std::string_view text);
bool is_whole(ValueType type);
// Returns the value that a control of that type can have, fractions rounded where it is whole; nullopt if it has none.
std::optional<double> fitting(double value, ValueType type);
// Does both for a text that a user typed, but refuses a fraction where the value is whole.
std::optional<double> typed(std::string_view text, ValueType type);

struct Track {
    double min = 0, max = 1;
    ValueType type = ValueType::float_;
    bool logarithmic = false;  // equal distances are equal ratios; needs min > 0
};

// Where the value is on the track, from 0 to 1.
double fraction_of(double value, const Track& track);
// The value there, and as short as tidy() makes it, where it is not at an end.
double exact_at(double fraction, const Track& track);
double value_at(double fraction, const Track& track, bool fine);
// The value that keys move to: by a hundredth of the range for a step, whole numbers by one.
double stepped(double value, double steps, const Track& track);

}  // namespace snell
