// File names with placeholders.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/app/batch/shots.h"

namespace snell::app {

class Pattern {
public:
    // Parses a pattern such as "out/{uEta:.2f}.png"; `names` are the valid placeholders. Returns nullopt and sets
    // `error` for any other name.
    static std::optional<Pattern> parse(std::string_view text, const std::vector<std::string>& names,
                                        std::string& error);
    // Replaces the placeholders; `values` is in the order of the names given to parse. Returns nullopt and sets `error`
    // if a format does not suit its value.
    std::optional<std::string> expand(const std::vector<AxisValue>& values, std::string& error) const;

private:
    struct Piece {
        std::string literal;      // text before the value
        std::size_t name = 0;     // index of the value's name; past the end of the names: no value
        std::string format;       // such as "{:.2f}"; "": the default format
        std::string placeholder;  // as written in the pattern
    };
    std::vector<Piece> pieces_;
};

}  // namespace snell::app
