// The files that `snell accuracy` writes, and what they say of the machine.
#pragma once

#include <CLI/CLI.hpp>

#include "src/accuracy/report/report.h"
#include "src/app/commands/advice.h"
#include "src/app/open/complain.h"

namespace snell::app {

// The load average over one minute; 0 if it is unknown.
double system_load();
// The machine and the options, for reports.
accuracy::Circumstances circumstances(const AccuracyOptions& options, const gl::Caps& caps,
                                      const accuracy::BenchSettings& settings);

// True, with a message, if there is nothing in the report because the budget was too small.
bool note_nothing_drawn(const accuracy::Report& report);

// Adds the options that name these files.
void add_reports(CLI::App& command, AccuracyOptions& options);

// Says whether all can be written, and are none of the files that are `read`, with as many plots as are known before
// the measurement.
Exit check_reports(const AccuracyOptions& options, std::size_t sweeps, std::vector<std::string> read);

// A report that can't be written is an error, and costs no other one. Returns false if there was one.
bool write_reports(const AccuracyOptions& options, const accuracy::Report& report);

// Prints what the JSON reports of several machines say together.
Exit merge_reports(const AccuracyOptions& options);

}  // namespace snell::app
