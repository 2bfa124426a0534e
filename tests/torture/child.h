// A program that is run, watched, and ended when it takes too much.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace snell::torture {

struct Bounds {
    double seconds = 60;
    double gigabytes = 4;  // of memory that is its own and resident
};

struct End {
    int status = -1;  // of exit; -1: it did not exit by itself
    int signal = 0;   // that ended it; ours too
    bool too_long = false, too_large = false;
    double seconds = 0, processor = 0, gigabytes = 0;  // that it took; `processor` of all its threads
    std::string errors;                                // what it wrote to standard error
};

// Runs `words` in `folder`, without a display. Its standard error goes through the file `errors`. From any thread.
End run_child(const std::vector<std::string>& words, const std::string& folder, const std::string& errors,
              const Bounds& bounds);

// "", or what of the text a terminal might take as a command, or can't show.
std::string unfit_for_terminals(const std::string& text);

}  // namespace snell::torture
