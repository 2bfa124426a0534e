// Found rungs as ladders: a `Ladder` statement in the scene, and an `#if` around the lines of the shaders that change.
// No GL; nothing is written.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/accuracy/found/apply.h"

namespace snell::accuracy {

struct AsLadders {
    std::vector<std::string> statements;  // such as "Ladder FOUND_3 fewer_rounds <as_written>"
    Change change;                        // the edits of all texts, for changed_texts()
    std::string error, help;              // why there can be no such ladders
    std::optional<Span> where;            // the place of the error
};

// One ladder for each of `chosen`. The author's rung is the current one, so that the picture stays; it is the last one,
// the reference, unless the change makes the picture better. Lines that change are there twice, and with them the rest
// of their statements. `scene` is the text that the plan was made of.
AsLadders as_ladders(const Plan& plan, Files& files, const Sources& sources, FileId scene,
                     std::span<const Chosen> chosen);

}  // namespace snell::accuracy
