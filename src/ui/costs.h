// What the scene pays for and why, and what it does not pay for.
#pragma once

#include "src/ui/state.h"

namespace snell::ui {

// Facts::explanation is needed only while Memory::costs is open.
void costs_section(const Facts& facts, Memory& memory, Layout& layout);

// "1.4 MB"; decimal units.
std::string bytes_text(std::uint64_t bytes);

}  // namespace snell::ui
