// The plot of error against time, both logarithmic, once for reports, slides and the window.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "src/content/plot/page.h"

namespace snell::content {

struct PlotPoint {
    std::string name;
    double error = 0;                            // 0: equal to the reference; infinite: pixels that are not finite
    double milliseconds = 0, low = 0, high = 0;  // and the interval of the time; infinite if it is not known
    bool front = false, beaten = false;          // filled and large; hollow
    bool own = false;                            // as the scene sets it: a square
    bool chosen = false;                         // has a ring
    std::optional<Ink> ink = {};                 // if it is one of the page's other things, too
    std::optional<int> label = {};               // labels are placed in this order where there is room; none: no label
    std::string tip = {};                        // what is said where it is pointed at

    bool has_interval() const;
};

struct Plot {
    std::vector<PlotPoint> points;
    std::vector<std::pair<std::size_t, std::size_t>> edges = {};  // in red if the more expensive one is worse
    std::string errors, times;                                    // of the axes, with their units
    std::string stamp = {};                                       // what else is to be known
    double floor = 0;                                             // errors below it can't be told apart; 0: unknown
    std::string floor_words = {};
    double decades = 0;  // that axes span at least
};

// Draws it with text of this size. Returns the places of the points, whose errors and times must be known.
std::vector<std::pair<double, double>> draw_plot(Page& page, const Plot& plot, const Area& at, double em);

// A logarithmic axis.

// Maps values to places between `from` and `to`, with margins at both ends. Values from `low` to `high` are shown.
class Axis {
public:
    Axis(double low, double high, double from, double to, double decades = 0);
    double at(double value) const;
    bool shows(double value) const;
    // 1, 2 and 5 in each decade; only 1 if these are too many, even steps if they are too few.
    std::vector<double> ticks() const;

private:
    std::vector<double> even_ticks() const;

    double from_, to_, low_ = 0, high_ = 1;
};

}  // namespace snell::content
