#include "src/runtime/flags.h"

#include <algorithm>
#include <cmath>

namespace snell {

namespace {

struct Look {
    std::string_view name;
    std::array<std::uint8_t, 3> color;
};

constexpr std::array<Look, flag_count> looks{{{"", {0, 0, 0}},
                                              {"above 1", {255, 106, 0}},
                                              {"negative", {40, 140, 255}},
                                              {"infinite", {255, 232, 0}},
                                              {"NaN", {255, 0, 220}}}};

const Look& look_of(Flag flag) { return looks[static_cast<std::size_t>(flag)]; }

}  // namespace

std::string_view name(Flag flag) { return look_of(flag).name; }
std::array<std::uint8_t, 3> color_of(Flag flag) { return look_of(flag).color; }

Flag flag_of(float value) {
    if (std::isnan(value)) return Flag::nan;
    if (std::isinf(value)) return Flag::infinite;
    return value < 0 ? Flag::negative : value > 1 ? Flag::above_one : Flag::none;
}

Flag flag_of(std::span<const float, 4> rgba) {
    Flag worst = flag_of(rgba[3]);
    if (worst < Flag::infinite) worst = Flag::none;
    for (const float value : rgba.first<3>()) worst = std::max(worst, flag_of(value));
    return worst;
}

FlagCounts count_flags(std::span<const float> rgba) {
    FlagCounts counts;
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4)
        ++counts.pixels[static_cast<std::size_t>(flag_of(rgba.subspan(at).first<4>()))];
    return counts;
}

void paint_flags(std::span<const float> rgba, std::vector<std::byte>& picture) {
    picture.resize(rgba.size() / 4 * 4);
    for (std::size_t at = 0; at + 3 < rgba.size(); at += 4) {
        const Flag flag = flag_of(rgba.subspan(at).first<4>());
        const auto gray = [&] {
            const float light = .2126F * rgba[at] + .7152F * rgba[at + 1] + .0722F * rgba[at + 2];
            return static_cast<std::uint8_t>(110 * std::clamp(light, 0.0F, 1.0F));
        };
        std::array<std::uint8_t, 3> color = color_of(flag);
        if (flag == Flag::none) color.fill(gray());
        for (std::size_t c = 0; c < 3; ++c) picture[at + c] = std::byte{color[c]};
        picture[at + 3] = std::byte{255};
    }
}

}  // namespace snell
