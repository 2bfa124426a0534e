// What `snell check` finds.
#pragma once

#include <memory>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "src/document/document.h"

namespace snell::app {

// Opens a scene and finds its errors and warnings, those of the driver too. With `lint`, also what is valid but
// probably not meant; finding sliders without effect takes about a tenth of `seconds`, as long as it needs if 0.
std::unique_ptr<Document> checked_document(const std::string& path, const gl::Caps& caps, bool lint, double seconds,
                                           const RuntimeOptions& options, const Access& access);

// What `snell check` found, for programs.

// A scene with its diagnostics.
nlohmann::ordered_json checked_json(const std::string& scene, const Document& document);

// A log of SARIF 2.1.0 without results, and the results of one more scene for it.
nlohmann::ordered_json empty_sarif();
void add_sarif(nlohmann::ordered_json& log, const Document& document);

}  // namespace snell::app
