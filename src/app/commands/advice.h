// The options of `snell accuracy`, and the parts of it that recommend a combination of rungs (--within, --error,
// --save-quality), or list and write found rungs without measuring (--list-found, --apply).
#pragma once

#include <optional>
#include <string>

#include "src/accuracy/found/search.h"
#include "src/accuracy/report/report.h"
#include "src/app/open/complain.h"
#include "src/plan/files.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace snell::app {

struct AccuracyOptions {
    std::vector<std::string> scenes;
    std::vector<std::string> merge;  // reports to compare instead of a measurement
    std::string html, slide, svg, json, csv, markdown;
    std::vector<std::string> ladders, knobs;  // if both are empty: all
    std::string from = "reference";           // or "scene", "lattice"
    bool specialise = true;                   // programs are compiled for the values that they have
    std::vector<std::string> sets, choices;   // uniform=value, ladder=rung
    std::optional<std::pair<int, int>> size;
    int rounds = 31;
    double budget = 120;  // in seconds, for all sweeps together
    double time = 0;
    bool no_found = false;                // measures ladders and knobs only
    bool no_time = false;                 // measures errors only
    std::optional<double> within, error;  // limits of a wanted combination: milliseconds, RMSE
    bool save_quality = false;            // writes presets to a file next to the scene
    std::string apply;  // a found rung by its numbers, such as "3+7", that is written instead of a measurement
    bool list_found = false;
    std::string context;
    Access access;
    double timeout = 120;  // in seconds for reading a scene, or for the few frames of one step
};

// Recommends a combination of rungs.

// Adds the options that ask for one. They exclude `untimed`.
void add_advice(CLI::App& command, AccuracyOptions& options, CLI::Option& untimed);

// True if the options ask for a combination, rather than for the value of each rung.
bool asks_for_advice(const AccuracyOptions& options);

// Parses a duration above 0, such as "16ms", "16" or "0.016s"; returns milliseconds.
std::optional<double> parse_milliseconds(const std::string& text);

// Measures, prints the combinations found as values and as a command line, writes the presets if requested, and adds
// the measurements to the report. Rungs of ladders are chosen, or knobs if the scene has no ladders; and rungs that
// were found, if `found` is not null. If no limit is met, or there is no result, or a file cannot be written, it prints
// the reason and returns false. asks_for_advice must be true.
bool give_advice(const AccuracyOptions& options, const std::string& path, accuracy::Bench& bench, const Rungs& now,
                 const accuracy::MeasureOptions& measuring, const accuracy::FoundResult* found,
                 accuracy::Report& report);

}  // namespace snell::app

namespace CLI {
class App;
}

namespace snell::app {

void add_found_rungs(CLI::App& command, AccuracyOptions& options);

// True if the options ask for a list or for texts, and for no measurement.
bool only_texts(const AccuracyOptions& options);

// Does so. `command` has the options as they were given.
Exit write_found_rungs(const AccuracyOptions& options, const CLI::App& command);

}  // namespace snell::app
