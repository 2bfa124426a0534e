// Cuts a line of source and the carets under it to a given number of columns.
#pragma once

#include <string>
#include <string_view>

namespace snell::ui {

// Whether a line of a diagnostic shows source, such as "   10 |     uSc <0. .5 1.>".
bool is_source(std::string_view line);

struct Excerpt {
    std::string source, carets;
};
// Cuts both lines, given as a diagnostic prints them, to at most `columns` characters each. The first caret stays
// visible; dots mark what is left out.
Excerpt excerpt(std::string_view source, std::string_view carets, std::size_t columns);

}  // namespace snell::ui
