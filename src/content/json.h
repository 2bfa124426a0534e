// JSON to and from text. nlohmann's templates are slow to compile, so they are instantiated only here.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace snell::content {

// Formats with an indent of two blanks. Bytes that are not UTF-8 are replaced by U+FFFD.
std::string json_text(const nlohmann::ordered_json& json);
// Returns a discarded value if the text is not JSON.
nlohmann::ordered_json parse_json(std::string_view text);

}  // namespace snell::content
