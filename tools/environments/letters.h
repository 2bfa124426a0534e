// The few letters that the signs need.
#pragma once

#include <string_view>

namespace snell::environments {

// Ink at a point of a line of text, x to the right and y up, each letter 5 × 7 units and 1 apart; the text's lower
// left corner is the origin. Letters that the signs don't need are blank.
bool ink(std::string_view text, double x, double y);

}  // namespace snell::environments
