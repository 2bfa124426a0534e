// A diagnostic whose places were looked up: the parts that a reader sees, without the sources.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parser/text/diagnostic.h"

namespace snell {

// A line of source with a mark under it. Control characters are escaped, and long lines are cut around the mark.
struct MarkedLine {
    std::string text;
    int begin = 0, end = 0;  // columns of the mark, from 0; an empty mark still has one caret
};

// All texts are printable.
struct Finding {
    Severity severity = Severity::error;
    std::string file;  // name of the source
    std::optional<Position> at;
    std::string message;               // one line, with the code
    std::optional<MarkedLine> source;  // the line of the place, if there is one
    std::string also;                  // further lines with the same defect; may be empty
    std::string help;                  // may be empty
    std::vector<Finding> notes;
};

Finding describe(const Diagnostic& diagnostic, const Sources& sources);
// Returns "file:line:column", or "" without a place.
std::string place_text(const Finding& finding);
// Returns the first line: place, severity and message.
std::string headline(const Finding& finding);
// Returns what precedes the source: the number of the line and a bar.
std::string margin(int line);
// Returns the carets that belong below the text of the line.
std::string carets(const MarkedLine& line);
// Formats as render(Diagnostic) does.
std::string render(const Finding& finding);

}  // namespace snell
