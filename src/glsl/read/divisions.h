// Where directives can be put into the text of a shader.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace snell::glsl {

// Offsets.
struct Extent {
    std::size_t begin = 0, end = 0;
};

struct Directive {
    Extent extent;
    std::string_view word;
};

struct Divisions {
    std::vector<std::size_t> starts;  // of lines that begin outside of comments, directives and continued lines
    std::vector<Extent> statements;   // up to `;`, `{` or `}`; none contains a directive
    std::vector<Directive> directives;
};

// `text` is clean() and must outlive the result.
Divisions divisions(std::string_view text);

// True if the text has only whole groups of #if … #endif, and no #version, so that it can be within such a group.
bool whole_groups(std::string_view text);

}  // namespace snell::glsl
