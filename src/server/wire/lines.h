// Places in a text as the protocol counts them: lines, and units of an encoding within a line.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace snell::server {

enum class Encoding : std::uint8_t { utf8, utf16 };

struct Place {
    std::uint32_t line = 0, character = 0;  // from 0
    bool operator==(const Place&) const = default;
};

// The lines of a text, which must outlive it. CR, LF and CRLF end a line, as in Sources.
class Lines {
public:
    explicit Lines(std::string_view text);

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

}  // namespace snell::server
