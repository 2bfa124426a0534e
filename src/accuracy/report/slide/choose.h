// Which rungs a slide shows, and next to which. Internal to the slide.
#pragma once

#include <vector>

#include "src/accuracy/report/slide/slide.h"

namespace snell::accuracy {

// A rung of the report, as a point of the slide.
struct SlideRung {
    const SweepResult* sweep;
    std::size_t rung;
    content::PlotPoint point;

    const RungResult& result() const { return sweep->rungs[rung]; }
    bool timed() const { return point.milliseconds > 0; }
};

inline constexpr std::size_t most_columns = 5;

// A rung in a column, as an index.
struct ColumnChoice {
    std::size_t rung = 0;
    bool equal_time = false, equal_error = false;
};

// Whether a rung of one sweep draws the same as one of another: the same rungs of ladders and knobs, no text changed.
bool same_variant(const SweepResult& a, std::size_t i, const SweepResult& b, std::size_t j);

// The columns from left to right. `own` is the index of the scene's own rung, or the number of rungs if it was not
// drawn.
//   Equal time: that of the scene's own rung, within a quarter; the errors differ.
//   Equal error: within a tenth; the times are told apart.
// Of each, at most two others. Where there are fewer, the best bargain, the first and the last rung of the scene's
// ladder and the cheapest of the front may fill the columns; only pictures that differ from those shown do.
std::vector<ColumnChoice> choose_columns(const std::vector<SlideRung>& rungs, std::size_t own);

// By the index of a rung, whether it is on the front of all of them: on that of its own sweep, and none of another
// sweep is surely cheaper and not worse, or more exact and not surely more expensive.
std::vector<bool> common_front(const std::vector<SlideRung>& rungs);

}  // namespace snell::accuracy
