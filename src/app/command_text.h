// What is in the window, as a command.
#pragma once

#include <string>
#include <string_view>

#include "src/app/document.h"
#include "src/plan/view.h"

namespace snell {

struct Picture {
    int width = 0, height = 0, samples = 1;
    double time = 0;
    View view;
    std::string file = {};  // as `snell render -o` takes it; empty: named as the scene
    bool transparent = false;
    int frames = 0;  // at `rate` a second; 0: one picture
    double rate = 25;
};

// A line for a POSIX shell that draws the same picture: values and rungs that are not the scene's, view, time, size.
// Programs of one name can't be told apart there: of these the last value holds.
std::string render_command(const Document& document, const Picture& picture);

// In quotes where a shell would read it otherwise.
std::string shell_word(std::string_view word);

}  // namespace snell
