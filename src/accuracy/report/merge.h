// Reports of several machines side by side: which conclusions hold on all of them.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace snell::accuracy {

struct NamedReport {
    std::string name;  // of its file
    std::string json;  // as json_text() wrote it
};

// For each ladder that at least two reports have, a table of the rungs' costs on each machine. Scenes are matched by
// their files' names, or by their paths if one report has several scenes of that name. Marks each rung whose standing
// or saving differs between machines whose measurements are trusted; those of pictures of different sizes are only
// listed. The text is printable. Returns nullopt and sets `error` if a report cannot be read, or no ladder is in two of
// them.
std::optional<std::string> merged_text(std::span<const NamedReport> reports, std::string& error);

}  // namespace snell::accuracy
