// A buffer for text that is composed again in every frame; short text needs no heap.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "parser/text/diagnostic.h"

namespace snell::ui {

class Text {
public:
    Text() = default;
    explicit Text(std::string_view text) { append(text); }
    template <typename... Arguments>
    explicit Text(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        add(format, std::forward<Arguments>(arguments)...);
    }

    Text& append(std::string_view text) {
        buffer_.append(text.data(), text.data() + text.size());
        return *this;
    }
    template <typename... Arguments>
    Text& add(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        add_all(format, fmt::make_format_args(arguments...));
        return *this;
    }

    bool operator==(std::string_view other) const { return view() == other; }
    bool empty() const { return buffer_.size() == 0; }
    std::string_view view() const { return {buffer_.data(), buffer_.size()}; }
    const char* begin() const { return buffer_.data(); }
    const char* end() const { return buffer_.data() + buffer_.size(); }
    // Valid until the text is changed.
    const char* c_str() const {
        buffer_.push_back('\0');
        buffer_.resize(buffer_.size() - 1);
        return buffer_.data();
    }

private:
    // Compiled once, because the formatter that it instantiates takes the compiler seconds.
    void add_all(fmt::string_view format, fmt::format_args arguments);

    mutable fmt::basic_memory_buffer<char, 320> buffer_;  // mutable for the terminating 0 of c_str()
};

// Cuts a line of source to a given number of columns.

// Cuts the line to at most `columns` characters. The first caret stays visible; dots mark what is left out.
MarkedLine excerpt(const MarkedLine& line, std::size_t columns);

}  // namespace snell::ui
