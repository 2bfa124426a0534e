// Rows of the programs' sections: a uniform's name, and what changes its value.
#pragma once

#include "src/ui/panels/state.h"

namespace snell::ui {

// What all rows of one program have in common.
struct Section {
    const Facts& facts;
    const Program& program;
    bool linked;
    Memory& memory;
    Layout& layout;
    float name_width = 0, number_width = 0;  // of the sliders' columns
};

// Measures the columns, so that the tracks of all sliders of a program begin and end at the same places.
void measure_columns(const Controls& controls, Index program, Section& section);
void row(Control& control, const Section& section);

}  // namespace snell::ui
