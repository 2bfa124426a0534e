#include "src/server/wire/inbox.h"

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

}  // namespace snell::server
