// Formats statements of a scene for messages.
#pragma once

#include <string>

#include "parser/text/source.h"

namespace snell {

// The statement's text in one line, cut if it is long.
std::string statement_text(const Span& span, const Sources& sources);
// The statement's place, such as "scene.glib:12".
std::string statement_place(const Span& span, const Sources& sources);

}  // namespace snell
