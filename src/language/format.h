// The layout of a scene's text: indentation, and the alignment of lines that continue a statement. Nothing else
// changes: only blanks and tabs at the beginning of lines, and before backslashes that stand below each other.
//
// Statements between RenderToTexture or RenderToCube and the end of the pass, PushMatrix and PopMatrix, glBegin and
// glEnd are indented by four blanks each, if the block ends in the same text. A line that continues a statement begins
// below its first argument, or below what follows an open bracket; backslashes that stand below each other stay so.
// Comments are indented like what surrounds them. Lines of blanks, and statements that are not commands, stay as they
// are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "src/plan/values/write_back.h"

namespace snell::language {

// Returns what changes, in order and without overlap, each within a line, in the statements and comments that touch the
// bytes begin … end. Any bytes are accepted; nothing changes in UTF-16, and in texts that are too large to be scenes.
std::vector<Edit> layout_edits(std::string_view text, FileId file = 0, std::uint32_t begin = 0,
                               std::uint32_t end = UINT32_MAX);

// The text after all of these. Formatting it again changes nothing, and it reads to the same scene.
std::string formatted(std::string_view text);

}  // namespace snell::language
