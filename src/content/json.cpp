#include "src/content/json.h"

#include <nlohmann/json.hpp>

namespace snell::content {

namespace {

using Json = nlohmann::ordered_json;

std::string text_of(const Json& json, int indent) {
    return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace

std::string json_text(const Json& json) { return text_of(json, 2); }
std::string json_line(const Json& json) { return text_of(json, -1); }
Json parse_json(std::string_view text) { return Json::parse(text, nullptr, false); }

}  // namespace snell::content
