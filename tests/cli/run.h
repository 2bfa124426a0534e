// The program, as a shell calls it.
#pragma once

#include <string>
#include <string_view>

#include "tests/scratch.h"

namespace snell::test {

struct Outcome {
    int status = -1;
    std::string output;  // both streams
    bool says(std::string_view text) const { return output.find(text) != std::string::npos; }
};

// What a shell makes of a command.
Outcome run(const std::string& command);

// The same of `snell ARGUMENTS` in a folder, with assignments before it, and without a display. A line of plain or
// quoted words and redirections is run in a copy of a process that has loaded the driver, which takes a fifth of the
// time that a program takes to start; all others, and those with variables of drivers, by a shell.
Outcome snell(const std::string& arguments, const std::string& environment = "", const std::string& folder = ".");

// Seconds that processors spent on the processes that were run and have ended: unlike the wall's time, it does not
// depend on what else the machine does.
double processor_seconds();

// The least of three runs, in processor time, whatever the driver's cache holds.
double cost_of(const std::string& arguments);

}  // namespace snell::test
