// The rungs that snell finds by itself, in the accuracy panel: a table of changes of the scene's texts, with the errors
// that they make and the time that they take.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/ui/kit/kit.h"

namespace snell::ui {

struct Facts;
struct Requests;

// A place in a file that an editor opens; line and column are 1-based.
struct Place {
    std::string file;  // path on disk; empty if there is no place
    int line = 1, column = 1;
};

// A change of the scene's texts, or several that are made together.
struct FoundRow {
    // better: what the picture lacks, with the error that the scene makes. unused: leaving it out changes no pixel.
    // untried: refused, or there was no time for it.
    // dearer: it was meant to be cheaper, and takes the scene's time or more.
    enum class Group : std::uint8_t { cheaper, dearer, better, unused, untried };
    Group group = Group::cheaper;
    std::string name;           // "3", or "3+7"
    std::string kind, meaning;  // such as "fewer-rounds", and a line about it
    std::string where;          // such as "glass.frag:12"
    Place place;
    std::string before, after;
    std::optional<double> error, of_display, flip;  // RMSE of light and of display values, where it is worst
    std::optional<double> error_here, flip_here;    // as the scene opens
    double ratio = 0;                               // of its time to the scene's; 0: not known
    double low = 0, high = 0;                       // interval of the ratio; 0: it was only estimated
    std::uint64_t bytes = 0;                        // of GPU memory that an unused one takes
    double loading = 0;                             // milliseconds that it takes; 0: not known, or none
    bool front = false;                             // worth its time
    std::string remark;                             // why it was not tried, or what else must be known; may be empty
};

struct FoundFacts {
    std::string note;                // why nothing can be sought; empty if it can
    bool asked = false;              // rungs were sought since the scene was opened
    std::string reduced;             // as in AccuracyFacts
    std::vector<FoundRow> rows;      // by group
    std::optional<double> progress;  // 0..1 while they are sought
    std::string doing;               // what the search is at
    bool waiting = false;            // something moves, so that the search rests
    bool older = false;              // the numbers are of other values or another view than the picture's
    bool stale = false;              // the rungs are of an older text
    std::string remark;              // on the search; may be empty
    std::string shown;               // name of the rung whose picture is in the window; empty: the scene's
};

// The rows under the pointer.
struct FoundMemory {
    bool over = false;           // the pointer was over them in the last frame
    std::vector<FoundRow> rows;  // as they were when it came there
    float top = 0;               // where they begin in the panel, wherever it is scrolled
    bool grown = false;          // what is above them, since then
};

// Draws the button that starts and stops the search, and what was found.
void found_rungs(const Facts& facts, FoundMemory& memory, Requests& requests, Layout& layout);
// Escape shows the scene again if a found rung is shown. Returns true if it did.
bool found_keys(const Facts& facts, Requests& requests);
// The row of the rung that is shown; null if there is none.
const FoundRow* shown_row(const FoundFacts& facts);
// Names the rung that is shown, such as "found rung 3".
std::string found_text(const FoundFacts& facts);
// A change of code as it fits into a width: what both texts begin and end with is left out before what differs is cut.
std::string change_text(std::string_view before, std::string_view after, float width);
// Formats a ratio of times, such as "×.72" or "×1.3".
std::string ratio_text(double ratio);

}  // namespace snell::ui
