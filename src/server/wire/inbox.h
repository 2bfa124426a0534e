// Messages as bytes: a header with the length, then JSON.
#pragma once

#include <cstddef>
#include <deque>
#include <string>
#include <string_view>

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

}  // namespace snell::server
