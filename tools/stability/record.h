// What a test measured for a hard case, as a line of text and as a row of docs/stability.md.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace snell::stability {

struct Record {
    std::string number, what, unit, test;
    std::string context;  // "CPU", "GL 3.3", "ES 3.2"; several, with commas, where tests were merged
    double tolerance = 0, ours = 0;
    std::optional<double> naive;
};

// Fields with tabs between; nothing for a line that is none of these.
std::string to_line(const Record& record);
std::optional<Record> from_line(const std::string& line);

// "| 17 | direction 0 |" and "| < 1e-6 rad | `Suite.Test` |": what is the same whoever measures.
std::string row_begin(const Record& record);
std::string row_end(const Record& record);

// The page: a table for each group of cases. One row for what was measured alike in several contexts, with the
// largest result of any of them.
std::string page(std::vector<Record> records);

// Of the cases 1 to 70, those that no record has.
std::vector<int> missing(const std::vector<Record>& records);

}  // namespace snell::stability
