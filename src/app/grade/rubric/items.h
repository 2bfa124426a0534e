// Reads the items of a rubric.
#pragma once

#include "src/app/grade/rubric/rubric.h"
#include "src/app/grade/rubric/toml.h"

namespace snell::app {

// Adds an item, and the pictures that it needs, to the rubric, whose `reference` is known. Reports mistakes.
void read_item(const TomlValue& value, Rubric& rubric, Diagnostics& diagnostics);

}  // namespace snell::app
