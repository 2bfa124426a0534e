// Cuts a line of source to a given number of columns.
#pragma once

#include <cstddef>

#include "parser/text/finding.h"

namespace snell::ui {

// Cuts the line to at most `columns` characters. The first caret stays visible; dots mark what is left out.
MarkedLine excerpt(const MarkedLine& line, std::size_t columns);

}  // namespace snell::ui
