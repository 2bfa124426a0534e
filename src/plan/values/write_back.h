// Writes values back into the scene's text. Only the numbers change; comments, blanks and line ends stay as they are.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "src/plan/values/controls.h"

namespace snell {

// As what a diagnostic proposes: replaces the bytes of `span` by `text`.
using Edit = Fix;

// A value that has no place in the text.
struct Unwritten {
    std::string name;    // such as "Glass.uEta", or the name of a ladder
    std::string reason;  // includes what the user can write instead, if that helps
};

struct WriteBack {
    std::vector<Edit> edits;  // sorted by file and place, without overlaps
    std::vector<Unwritten> unwritten;
    // The programs and ladders that the edited texts must read as.
    std::vector<Program> programs;
    std::vector<Ladder> ladders;
};

// Computes the edits after which `scene`, read again, has the values and rungs of `controls`. Numbers are the shortest
// that read back to the same bits, in the style of those that they replace; values that are the scene's own keep their
// text. A range is widened if its value is outside of it. Texts that are included twice are changed only if both
// readings agree.
WriteBack write_back(const Scene& scene, const Controls& controls, const Sources& sources);

// Applies those of `edits` that belong to `file` to its text. They are in order; one that overlaps another before it,
// or is not within the text, is left out.
std::string with_edits(std::string_view text, FileId file, std::span<const Edit> edits);

// True if the edited texts, which were read as `scene`, have exactly the intended values.
bool reads_back(const WriteBack& write_back, const Scene& scene);

// Formats the control's value as on a Program line, such as "uEta <0. .5 1.>".
std::string uniform_text(const Control& control);

}  // namespace snell
