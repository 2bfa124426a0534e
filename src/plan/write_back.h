// Values back into the scene's text, where only the numbers change: comments, blanks and line ends stay as they are.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/source.h"
#include "src/plan/controls.h"

namespace snell {

// The bytes of `span` become `text`.
struct Edit {
    Span span;
    std::string text;
    bool operator==(const Edit&) const = default;
};

// A value that the text has no place for.
struct Unwritten {
    std::string name;    // "Glass.uEta", or a ladder's
    std::string reason;  // with what to write by hand, where that would help
};

struct WriteBack {
    std::vector<Edit> edits;  // by file and place; none overlap
    std::vector<Unwritten> unwritten;
    // As the edited texts read.
    std::vector<Program> programs;
    std::vector<Ladder> ladders;
};

// What to change so that `scene`, read again, has the values and rungs of `controls`. Numbers are as short as reads
// back to the same bits, in the style of those they replace; values that are the scene's own keep their text. A range
// that the value left is widened. Texts that are included twice are changed only if both readings agree.
WriteBack write_back(const Scene& scene, const Controls& controls, const Sources& sources);

// `text` with those of `edits` that are of `file`.
std::string with_edits(std::string_view text, FileId file, std::span<const Edit> edits);

// Whether the edited texts, read as `scene`, say just what was to be written.
bool reads_back(const WriteBack& write_back, const Scene& scene);

// How a Program line would say the control's value: "uEta <0. .5 1.>".
std::string uniform_text(const Control& control);

}  // namespace snell
