#include "src/server/wire/json.h"

#include <algorithm>
#include <limits>

namespace snell::server {

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json place_json(Place place) { return {{"line", place.line}, {"character", place.character}}; }

Json range_json(const Lines& lines, const Span& span, Encoding encoding) {
    const Place begin = lines.place(span.begin, encoding);
    return {{"start", place_json(begin)}, {"end", place_json(lines.place(std::max(span.begin, span.end), encoding))}};
}

namespace {

// Numbers below 0 are 0, and those that are too large the largest.
std::uint32_t natural(const Json& number) {
    const double value = number.get<double>();
    return value > 0 ? static_cast<std::uint32_t>(std::min(value, 2147483647.)) : 0;
}

}  // namespace

Place place_of(const Json& json) { return {natural(json.at("line")), natural(json.at("character"))}; }

std::string string_at(const Json& json, const char* key) { return json.at(key).get<std::string>(); }

}  // namespace snell::server
