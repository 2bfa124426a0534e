// The camera that the user holds, as an option of the command line.
#pragma once

#include <string>
#include <string_view>

#include "src/plan/view.h"

namespace snell {

// "rotate_x=30,rotate_y=-12.5,scale=1.2,x=.1": what is not as it was at first; "eye.", "texture." and "object3." before
// the names of the other transformations; "projection=ortho", "background=.3". "" where all is. Reads back to the same
// bits; axes and mouse are not in it.
std::string view_text(const View& view);

// "" or what is wrong.
std::string parse_view(std::string_view text, View& view);

}  // namespace snell
