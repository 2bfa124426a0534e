// Pages of docs/ that the program has in itself, because an installation may lack docs/.
#pragma once

#include <string_view>

namespace snell::app {

// Returns the text of "diagnostics.md" or "teaching.md", "" for other names.
std::string_view embedded_page(std::string_view name);

}  // namespace snell::app
