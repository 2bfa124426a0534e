// The window's themes.
#pragma once

#include <cstdint>

namespace snell::ui {

enum class Theme : std::uint8_t { light, dark };

}  // namespace snell::ui
