// The files that a command was asked to write, looked at before the work that they are to hold.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "src/app/open/exit_status.h"
#include "src/plan/files.h"

namespace snell::app {

// Returns true if writing these would replace at least one file.
bool replace_a_file(std::span<const std::string> outputs);

// The scenes, and, only if an output would replace a file, all that they may read: what outputs must not overwrite.
// `grade`: as for access_to().
std::vector<std::string> read_by(std::span<const std::string> scenes, std::span<const std::string> outputs,
                                 const Access& access, bool grade = false);

// Whether some of them are one file, under whatever names, or one of `read`, which is not to be overwritten; says so.
// Empty names, pipes and devices lose nothing.
bool distinct_outputs(std::span<const std::string> outputs, std::span<const std::string> read);

// What this ends with: exit_usage where they are not distinct, exit_input where one can't be written, both said.
Exit check_outputs(std::span<const std::string> outputs, std::span<const std::string> read);

}  // namespace snell::app
