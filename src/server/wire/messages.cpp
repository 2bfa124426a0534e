#include "src/server/wire/messages.h"

#include <algorithm>

#include "parser/text/number.h"
#include "parser/text/words.h"

namespace snell::server {

namespace {

constexpr std::size_t longest_line = 4096;

}  // namespace

void Inbox::feed(std::string_view bytes) {
    while (!bytes.empty()) bytes = in_body_ ? read_body(bytes) : read_header(bytes);
}

Arrived Inbox::take() {
    Arrived first = std::move(arrived_.front());
    arrived_.pop_front();
    return first;
}

std::string_view Inbox::read_header(std::string_view bytes) {
    const std::size_t end = bytes.find('\n');
    const std::string_view part = bytes.substr(0, end);
    if (line_.size() + part.size() <= longest_line)
        line_ += part;
    else
        wrong_ = "a line of the header is too long";
    if (end == std::string_view::npos) return {};
    end_line();
    return bytes.substr(end + 1);
}

void Inbox::end_line() {
    const std::string_view line = trimmed(line_);
    if (line.empty()) {
        if (any_line_ || !wrong_.empty()) end_header();
    } else {
        any_line_ = true;
        const std::size_t colon = line.find(':');
        const std::string_view value = colon == line.npos ? "" : trimmed(line.substr(colon + 1));
        if (same_word(trimmed(line.substr(0, colon)), "Content-Length")) {
            const auto length = read_whole<std::size_t>(value);
            has_length_ = length.has_value();
            wrong_ = has_length_ ? "" : "Content-Length is not a number of bytes";
            left_ = length.value_or(0);
        }
    }
    line_.clear();
}

void Inbox::end_header() {
    if (!has_length_ && wrong_.empty()) wrong_ = "the header has no Content-Length";
    if (has_length_ && left_ > longest_) wrong_ = "the message is too long";
    skipping_ = !wrong_.empty();
    if (skipping_) arrived_.push_back({{}, std::move(wrong_)});
    wrong_.clear();
    body_.clear();
    in_body_ = has_length_ && left_ > 0;
    if (has_length_ && left_ == 0 && !skipping_) arrived_.push_back({});
    has_length_ = any_line_ = false;
}

std::string_view Inbox::read_body(std::string_view bytes) {
    const std::size_t count = std::min(left_, bytes.size());
    if (!skipping_) body_.append(bytes.substr(0, count));
    left_ -= count;
    if (left_ == 0) {
        if (!skipping_) arrived_.push_back({std::move(body_), {}});
        body_ = {};
        in_body_ = skipping_ = false;
    }
    return bytes.substr(count);
}

std::string framed(std::string_view body) {
    std::string message = "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n";
    return message.append(body);
}

namespace {

// How many units of the encoding a character has.
std::uint32_t units(const utf8::Char& c, Encoding encoding) {
    if (encoding == Encoding::utf8) return c.length;
    return c.valid && c.code > 0xFFFF ? 2 : 1;
}

// Numbers below 0 are 0, and those that are too large the largest.
std::uint32_t natural(const Json& number) {
    const double value = number.get<double>();
    return value > 0 ? static_cast<std::uint32_t>(std::min(value, 2147483647.)) : 0;
}

}  // namespace

std::uint32_t Lines::end_of_line(std::uint32_t line) const {
    if (line + std::size_t{1} >= starts_.size()) return static_cast<std::uint32_t>(text_.size());
    const std::uint32_t next = starts_[line + 1];
    return next - (text_.substr(0, next).ends_with("\r\n") && next >= starts_[line] + 2 ? 2 : 1);
}

std::uint32_t Lines::offset(Place place, Encoding encoding) const {
    if (place.line >= starts_.size()) return static_cast<std::uint32_t>(text_.size());
    const std::uint32_t end = end_of_line(place.line);
    std::uint32_t at = starts_[place.line], character = 0;
    while (at < end && character < place.character) {
        const utf8::Char c = utf8::decode(text_, at);
        character += units(c, encoding);
        if (character > place.character) break;  // the middle of a character is its beginning
        at += c.length;
    }
    return std::min(at, end);
}

Place Lines::place(std::uint32_t offset, Encoding encoding) const {
    offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
    const auto next = std::upper_bound(starts_.begin(), starts_.end(), offset);
    const auto line = static_cast<std::uint32_t>(next - starts_.begin() - 1);
    Place place{line, 0};
    std::uint32_t at = starts_[line];
    if (last_.place.line == line && last_.offset <= offset && last_.offset >= at && last_.encoding == encoding) {
        place = last_.place;
        at = last_.offset;
    }
    while (at < offset) {
        const utf8::Char c = utf8::decode(text_, at);
        if (at + c.length > offset) break;
        place.character += units(c, encoding);
        at += c.length;
    }
    last_ = {at, place, encoding};
    return place;
}

std::string text_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json place_json(Place place) { return {{"line", place.line}, {"character", place.character}}; }

Json range_json(const Lines& lines, const Span& span, Encoding encoding) {
    const Place begin = lines.place(span.begin, encoding);
    return {{"start", place_json(begin)}, {"end", place_json(lines.place(std::max(span.begin, span.end), encoding))}};
}

Place place_of(const Json& json) { return {natural(json.at("line")), natural(json.at("character"))}; }

std::string string_at(const Json& json, const char* key) { return json.at(key).get<std::string>(); }

}  // namespace snell::server
