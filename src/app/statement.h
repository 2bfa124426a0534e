// Statements of a scene, to be read by people.
#pragma once

#include <string>

#include "parser/source.h"

namespace snell {

// Its text in one line, however it is written; long ones are cut.
std::string statement_text(const Span& span, const Sources& sources);
// "scene.glib:12"
std::string statement_place(const Span& span, const Sources& sources);

}  // namespace snell
