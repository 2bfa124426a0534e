// Work that may never end, or end the program, in a process of its own.
#pragma once

#include <functional>
#include <string>

namespace snell::app {

struct Apart {
    int status = -1;  // the exit status; -1: the process was ended from outside, or could not be made
    std::string result;
};

// Calls `work` in a copy of this process. Its return value is the exit status of the copy, and the result that it sets
// arrives here if it returns. There must be neither threads nor a context yet, because they are not copied.
Apart apart(const std::function<int(std::string& result)>& work);

}  // namespace snell::app
