// What `snell check` finds.
#pragma once

#include <memory>
#include <string>

#include "src/document/document.h"

namespace snell::app {

// Opens a scene and finds its errors and warnings, those of the driver too. With `lint`, also what is valid but
// probably not meant; finding sliders without effect takes about a tenth of `seconds`, as long as it needs if 0.
std::unique_ptr<Document> checked_document(const std::string& path, const gl::Caps& caps, bool lint, double seconds,
                                           const RuntimeOptions& options, const Access& access);

}  // namespace snell::app
