// JSON values, and places in a text as the protocol counts them: lines, and units of an encoding within a line.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "parser/text/source.h"

namespace snell::server {

enum class Encoding : std::uint8_t { utf8, utf16 };

struct Place {
    std::uint32_t line = 0, character = 0;  // from 0
    bool operator==(const Place&) const = default;
};

// The lines of a text, which must outlive it. CR, LF and CRLF end a line, as in Sources.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text), starts_(line_starts(text)) {}

    // Places after the end of a line count as its end, and lines after the last as the end of the text.
    std::uint32_t offset(Place place, Encoding encoding) const;
    // Quick for offsets that increase.
    Place place(std::uint32_t offset, Encoding encoding) const;
    // The end of the line, without its line end.
    std::uint32_t end_of_line(std::uint32_t line) const;
    std::size_t count() const { return starts_.size(); }

private:
    std::string_view text_;
    std::vector<std::uint32_t> starts_;
    // The last answer of place(), from which the next one counts on if it is further on in the same line.
    struct Last {
        std::uint32_t offset = 0;
        Place place;
        Encoding encoding = Encoding::utf16;
    };
    mutable Last last_;
};

using Json = nlohmann::ordered_json;

// Bytes that are not UTF-8 become U+FFFD.
std::string text_of(const Json& json);

Json place_json(Place place);
Json range_json(const Lines& lines, const Span& span, Encoding encoding);

// Of params of any shape: these throw a type_error for a wrong one, which is answered with "invalid params".
Place place_of(const Json& json);
std::string string_at(const Json& json, const char* key);

}  // namespace snell::server
