// The window's themes.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace snell::ui {

enum class Theme : std::uint8_t { light, dark, contrast };
inline constexpr std::array<std::string_view, 3> theme_names{"light", "dark", "contrast"};

}  // namespace snell::ui
