// What `snell accuracy` says when it is asked for a combination: --within, --error, --save-quality.
#pragma once

#include <optional>
#include <string>

#include "src/accuracy/report.h"
#include "src/app/commands.h"

namespace snell::app {

// Whether a combination is asked for, rather than what each rung is worth.
bool asks_for_advice(const AccuracyOptions& options);

// "16ms", "16", "0.016s": milliseconds above 0.
std::optional<double> parse_milliseconds(const std::string& text);

// Measures, prints what was found as values and as a command line, writes the presets if they are wanted, and adds
// what was measured to the report. False, with its reason printed: nothing could be told, or not be written.
// Precondition: asks_for_advice.
bool give_advice(const AccuracyOptions& options, const std::string& path, accuracy::Bench& bench, const Rungs& now,
                 const accuracy::MeasureOptions& measuring, accuracy::Report& report);

}  // namespace snell::app
