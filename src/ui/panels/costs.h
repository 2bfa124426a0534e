// The costs panel: what the scene pays for and why, and what it does not pay for.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// Draws the section. Facts::explanation is needed only while Memory::costs is true.
void costs_section(const Facts& facts, Memory& memory, Layout& layout);

// Formats a size, such as "1.4 MB", in decimal units.
std::string bytes_text(std::uint64_t bytes);

}  // namespace snell::ui
