// JSON values, and places of the protocol in them.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "parser/text/source.h"
#include "src/server/wire/lines.h"

namespace snell::server {

using Json = nlohmann::ordered_json;

// Bytes that are not UTF-8 become U+FFFD.
std::string text_of(const Json& json);

Json place_json(Place place);
Json range_json(const Lines& lines, const Span& span, Encoding encoding);

// Of params of any shape: these throw a type_error for a wrong one, which is answered with "invalid params".
Place place_of(const Json& json);
std::string string_at(const Json& json, const char* key);

}  // namespace snell::server
