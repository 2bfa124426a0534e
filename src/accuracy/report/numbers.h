// Numbers and errors as JSON.
#pragma once

#include <cmath>
#include <nlohmann/json.hpp>

#include "src/accuracy/metrics.h"
#include "src/accuracy/statistics.h"

namespace snell::accuracy {

// JSON has no infinity; null stands for it.
inline nlohmann::ordered_json number(double value) {
    return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

inline nlohmann::ordered_json interval_json(const Interval& interval) {
    const double low = interval.known() ? interval.low : std::nan("");
    return {{"median", number(interval.middle)}, {"lo95", number(low)}, {"hi95", number(interval.high)}};
}

inline nlohmann::ordered_json figures_json(const Figures& figures) {
    return {{"rmse", number(figures.rmse)},
            {"psnr_db", number(figures.psnr)},
            {"max_abs", number(figures.max)},
            {"mean_abs", number(figures.mean)}};
}

// An RMSE of null with pixels that are not finite is infinite, unless something else tells why nothing is known.
inline nlohmann::ordered_json error_json(const Error& error) {
    return {{"light", figures_json(error.light)},
            {"display", figures_json(error.display)},
            {"correlation", number(error.correlation)},
            {"pixels", error.pixels},
            {"nonfinite", error.nonfinite}};
}

}  // namespace snell::accuracy
