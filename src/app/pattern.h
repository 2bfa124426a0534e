// Names of files with placeholders in them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/app/shots.h"

namespace snell::app {

class Pattern {
public:
    // "out/{uEta:.2f}.png" over the names that may stand in braces. Nothing, with the error, for others.
    static std::optional<Pattern> parse(std::string_view text, const std::vector<std::string>& names,
                                        std::string& error);
    // `values` are by the names given to parse. Nothing, with the error, where a format does not suit its value.
    std::optional<std::string> expand(const std::vector<AxisValue>& values, std::string& error) const;

private:
    struct Piece {
        std::string literal;      // before the value
        std::size_t name = 0;     // of the value; past the end of the names: none
        std::string format;       // "{:.2f}"; "": as it is shown
        std::string placeholder;  // as it was written
    };
    std::vector<Piece> pieces_;
};

}  // namespace snell::app
