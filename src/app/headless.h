// A headless context for a command, or the message that says why there is none.
#pragma once

#include <memory>
#include <string>

#include "src/platform/headless.h"

namespace snell::app {

// "" is the best there is; "3.3", "4.5", "es3.2". nullopt-like: false when the text names no version.
bool parse_context(const std::string& text, ContextRequest& request);

// Prints why on standard error when there is none.
std::unique_ptr<HeadlessContext> headless_context(const std::string& text);

}  // namespace snell::app
