// Hard cases: inputs that break naive code. A test declares the one that it covers by what it has measured; the rows
// of docs/stability.md are made from these declarations (./dev stability).
#pragma once

#include <optional>
#include <string_view>

namespace snell::test {

struct HardCase {
    std::string_view number;      // "17"; "A8" for those of the second list
    std::string_view what;        // the input, and what must hold: the row's text
    std::string_view unit;        // of the three that follow
    double tolerance = 0;         // the largest result that passes
    double ours = 0;              // NaN fails
    std::optional<double> naive;  // nothing: naive code has no result that could be shown; else it must fail
};

// Fails the running test where the result is not within its tolerance, where naive code's is too (the case is then
// not hard, or not the case), and where docs/stability.md shows other rows than this one. With SNELL_STABILITY_OUT
// in the environment, a folder, writes its record there and leaves docs/stability.md alone.
void hard_case(const HardCase& measured);

}  // namespace snell::test
