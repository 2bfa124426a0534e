// Why the process of a submission ended.
#pragma once

#include <string>

#include "src/app/grade/processes.h"

namespace snell::app {

// What is said of it in the report; "" if it ended by itself, with its work done. `timeout`: seconds for a picture;
// `gigabytes` of memory that it could ask for, 0: no limit.
std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes);

}  // namespace snell::app
