// Another program from which files are dragged into a window.
#pragma once

#include <string>
#include <vector>

namespace snell::test {

// By the XDND protocol, onto the middle of the window that takes drops. False: there is none, or it did not finish.
bool drop_files(const std::string& display, const std::vector<std::string>& paths);

}  // namespace snell::test
