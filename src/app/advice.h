// The part of `snell accuracy` that recommends a combination of rungs: --within, --error, --save-quality.
#pragma once

#include <optional>
#include <string>

#include "src/accuracy/report.h"
#include "src/app/commands.h"

namespace snell::app {

// True if the options ask for a combination, rather than for the value of each rung.
bool asks_for_advice(const AccuracyOptions& options);

// Parses a duration above 0, such as "16ms", "16" or "0.016s"; returns milliseconds.
std::optional<double> parse_milliseconds(const std::string& text);

// Measures, prints the combinations found as values and as a command line, writes the presets if requested, and adds
// the measurements to the report. If there is no result, or a file cannot be written, it prints the reason and returns
// false. asks_for_advice must be true.
bool give_advice(const AccuracyOptions& options, const std::string& path, accuracy::Bench& bench, const Rungs& now,
                 const accuracy::MeasureOptions& measuring, accuracy::Report& report);

}  // namespace snell::app
