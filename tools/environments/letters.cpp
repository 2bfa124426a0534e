#include "tools/environments/letters.h"

#include <array>
#include <cmath>

namespace snell::environments {
namespace {

struct Glyph {
    char letter;
    std::array<std::string_view, 7> rows;  // top first
};
constexpr Glyph glyphs[] = {
    {'+', {"     ", "  #  ", "  #  ", "#####", "  #  ", "  #  ", "     "}},
    {'-', {"     ", "     ", "     ", "#####", "     ", "     ", "     "}},
    {'X', {"#   #", "#   #", " # # ", "  #  ", " # # ", "#   #", "#   #"}},
    {'Y', {"#   #", "#   #", " # # ", "  #  ", "  #  ", "  #  ", "  #  "}},
    {'Z', {"#####", "    #", "   # ", "  #  ", " #   ", "#    ", "#####"}},
};

}  // namespace

bool ink(std::string_view text, double x, double y) {
    const double column = std::floor(x), row = std::floor(y);
    if (column < 0.0 || row < 0.0 || row >= 7.0) return false;
    const auto index = static_cast<std::size_t>(column) / 6, within = static_cast<std::size_t>(column) % 6;
    if (index >= text.size() || within == 5) return false;
    for (const Glyph& glyph : glyphs)
        if (glyph.letter == text[index]) return glyph.rows[6 - static_cast<std::size_t>(row)][within] == '#';
    return false;
}

}  // namespace snell::environments
