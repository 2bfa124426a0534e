// Makes a headless context for a command, or prints why there is none.
#pragma once

#include <memory>
#include <string>

#include "src/platform/headless.h"

namespace snell::app {

// Parses an OpenGL version: "" is the highest available; others are "3.3", "4.5", "es3.2". Returns false if the text is
// not a version.
bool parse_context(const std::string& text, ContextRequest& request);

// Returns null and prints the reason to standard error if there is none.
std::unique_ptr<HeadlessContext> headless_context(const std::string& text);

}  // namespace snell::app
