#include "src/document/coarseness.h"

#include <algorithm>
#include <limits>

namespace snell {

namespace {

constexpr int coarsest = static_cast<int>(grains.size()) - 1;

// An upper bound of what the next finer grain multiplies the time by.
constexpr double finer_costs = 4;

}  // namespace

int Coarseness::next(bool moved, bool held, double now) {
    if (moved && (held || now - moved_ < again)) until_ = now + rest;
    if (moved) moved_ = now;
    const Cost& cost = costs_[static_cast<std::size_t>(grain_)];
    if (now >= until_)
        grain_ = 0;
    else if (moved && cost.frames > 1 && cost.ms > slow)
        grain_ = grain_ == 0 ? dragged_ : std::min(grain_ + 1, coarsest);
    else if (moved && cost.frames > 1 && grain_ > 0 && cost.ms * finer_costs < slow)
        --grain_;
    if (grain_ > 0) dragged_ = grain_;
    return grain_;
}

void Coarseness::drew(double ms) {
    Cost& cost = costs_[static_cast<std::size_t>(grain_)];
    ++cost.frames;
    cost.ms = ms;
}

double Coarseness::due() const { return grain_ > 0 ? until_ : std::numeric_limits<double>::infinity(); }

}  // namespace snell
