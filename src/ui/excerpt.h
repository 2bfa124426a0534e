// A line of source and the carets under it, in as many columns as there are.
#pragma once

#include <string>
#include <string_view>

namespace snell::ui {

// "   10 |     uSc <0. .5 1.>": a diagnostic shows source so.
bool is_source(std::string_view line);

struct Excerpt {
    std::string source, carets;
};
// Both lines as diagnostics print them; at most `columns` characters of each stay, with the first caret among them and
// dots where something is missing.
Excerpt excerpt(std::string_view source, std::string_view carets, std::size_t columns);

}  // namespace snell::ui
