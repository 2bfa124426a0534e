// Messages as bytes, a header with the length, then JSON; and places in a text as JSON.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "parser/text/source.h"

namespace snell::server {

// What arrived: a message's body, or what is wrong with its header.
struct Arrived {
    std::string body;
    std::string wrong;  // a sentence; empty if the body is there
};

// Takes bytes as they come, in pieces of any size. Memory is only taken for bytes that are there, and a message that is
// too long is passed over.
class Inbox {
public:
    explicit Inbox(std::size_t longest = std::size_t{256} << 20) : longest_(longest) {}

    void feed(std::string_view bytes);
    bool empty() const { return arrived_.empty(); }
    Arrived take();

private:
    std::string_view read_header(std::string_view bytes);
    std::string_view read_body(std::string_view bytes);
    void end_line();
    void end_header();

    std::size_t longest_;
    std::deque<Arrived> arrived_;
    std::string line_, body_;
    bool in_body_ = false, skipping_ = false, has_length_ = false, any_line_ = false;
    std::string wrong_;     // with the header that is being read
    std::size_t left_ = 0;  // bytes of the body that are still to come
};

// The message with its header.
std::string framed(std::string_view body);

// JSON values, and places in a text as the protocol counts them: lines, and units of an encoding within a line.

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
