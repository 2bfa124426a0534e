#include "src/content/json.h"

#include <nlohmann/json.hpp>

namespace snell::content {

using Json = nlohmann::ordered_json;

std::string json_text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace); }
Json parse_json(std::string_view text) { return Json::parse(text, nullptr, false); }

}  // namespace snell::content
