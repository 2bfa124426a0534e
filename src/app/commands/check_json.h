// What `snell check` found, for programs.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "src/document/document.h"

namespace snell::app {

// A scene with its diagnostics.
nlohmann::ordered_json checked_json(const std::string& scene, const Document& document);

// A log of SARIF 2.1.0 without results, and the results of one more scene for it.
nlohmann::ordered_json empty_sarif();
void add_sarif(nlohmann::ordered_json& log, const Document& document);

}  // namespace snell::app
