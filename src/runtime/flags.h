// Colours that a picture of bytes can't show: of one kind or none, by what is worst about them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace snell {

enum class Flag : std::uint8_t { none, above_one, negative, infinite, nan };
inline constexpr std::size_t flag_count = 5;

// "NaN"; of none "".
std::string_view name(Flag flag);
// RGB bytes that pixels are painted with, told apart by who sees fewer colours, too.
std::array<std::uint8_t, 3> color_of(Flag flag);

// Of one channel.
Flag flag_of(float value);
// Of RGBA: alpha only where it is no number, since what is beyond 0 to 1 there shows nowhere.
Flag flag_of(std::span<const float, 4> rgba);

// Pixels by Flag; each counts once.
struct FlagCounts {
    std::array<std::size_t, flag_count> pixels{};
    std::size_t operator[](Flag flag) const { return pixels[static_cast<std::size_t>(flag)]; }
};
FlagCounts count_flags(std::span<const float> rgba);

// RGBA bytes of as many pixels: flagged ones in their colours, the others in dim greys.
void paint_flags(std::span<const float> rgba, std::vector<std::byte>& picture);

}  // namespace snell
