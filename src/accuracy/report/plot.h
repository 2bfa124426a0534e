// Plots one ladder: error over time, both logarithmic.
#pragma once

#include <string>
#include <vector>

#include "src/accuracy/measure.h"

namespace snell::accuracy {

// Returns an <svg> element of 640 by 400, whose parts have classes. `style` is included in it, for use as a file of its
// own.
std::string plot_svg(const SweepResult& sweep, std::string_view style = {});

// A logarithmic axis of a plot.

// Maps values to places between `from` and `to`, with margins at both ends. Values from `low` to `high` are shown.
class Axis {
public:
    Axis(double low, double high, double from, double to);
    double at(double value) const;
    bool shows(double value) const;
    // 1, 2 and 5 in each decade; only 1 if these are too many, even steps if they are too few.
    std::vector<double> ticks() const;

private:
    std::vector<double> even_ticks() const;

    double from_, to_, low_ = 0, high_ = 1;
};

}  // namespace snell::accuracy
