// JSON as text. Reading and writing are templates that build slowly: they are built once, here.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace snell::content {

// Indented by two blanks. Bytes that are not UTF-8 are replaced by U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);
// The same in one line.
std::string json_line(const nlohmann::ordered_json& json);
// A discarded value where the text is no JSON.
nlohmann::ordered_json parse_json(std::string_view text);

}  // namespace snell::content
