#include "src/accuracy/report/axis.h"

#include <algorithm>
#include <cmath>

namespace snell::accuracy {

Axis::Axis(double low, double high, double from, double to) : from_(from), to_(to) {
    if (!(high > low)) {
        low /= 1.5;
        high *= 1.5;
    }
    const double room = .06 * std::log(high / low) + .02;
    low_ = std::log(low) - room;
    high_ = std::log(high) + room;
}

double Axis::at(double value) const {
    return from_ + (std::log(std::max(value, 1e-30)) - low_) / (high_ - low_) * (to_ - from_);
}

bool Axis::shows(double value) const { return value > 0 && std::log(value) >= low_ && std::log(value) <= high_; }

std::vector<double> Axis::ticks() const {
    std::vector<double> all;
    const int first = static_cast<int>(std::floor(low_ / std::log(10))),
              last = static_cast<int>(high_ / std::log(10)) + 1;
    for (int decade = first; decade <= last; ++decade)
        for (double step : {1., 2., 5.})
            if (shows(step * std::pow(10, decade)) && (step == 1 || last - first < 5))
                all.push_back(step * std::pow(10, decade));
    return all.size() >= 3 ? all : even_ticks();
}

// Three to seven even steps of 1, 2 or 5 times a power of ten.
std::vector<double> Axis::even_ticks() const {
    const double low = std::exp(low_), high = std::exp(high_);
    const double power = std::pow(10, std::floor(std::log10((high - low) / 3)));
    const double least = (high - low) / 7;
    const double step = power >= least ? power : 2 * power >= least ? 2 * power : 5 * power;
    std::vector<double> all;
    for (double i = std::ceil(low / step); i * step <= high; ++i) all.push_back(i * step);
    return all;
}

}  // namespace snell::accuracy
