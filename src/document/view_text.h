// The view that the user has set, as a command-line option.
#pragma once

#include <string>
#include <string_view>

#include "src/plan/view.h"

namespace snell {

// Formats the values that differ from their initial state, such as "rotate_x=30,rotate_y=-12.5,scale=1.2,x=.1". Names
// of other transformations begin with "eye.", "texture." and "object3."; further values are "projection=ortho" and
// "background=.3". "" if nothing differs. The text reads back to the same bits. Axes and mouse are not included.
std::string view_text(const View& view);

// Returns "" or the error.
std::string parse_view(std::string_view text, View& view);

}  // namespace snell
