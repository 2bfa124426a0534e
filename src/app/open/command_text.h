// The window's state as a command line.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "src/document/document.h"
#include "src/plan/view.h"

namespace snell {

struct Picture {
    int width = 0, height = 0, samples = 1;
    double time = 0;
    View view;
    std::string file = {};  // as for `snell render -o`; empty: named after the scene
    bool transparent = false;
    int frames = 0;  // at `rate` per second; 0: one picture
    double rate = 25;
};

// The options of a command for what differs from the scene: --view, --set and --ladder, without quotes.
std::vector<std::string> value_options(const Document& document, const View& view);

// Returns a line for a POSIX shell that draws the same picture: the values and rungs that differ from the scene's, and
// view, time and size.
std::string render_command(const Document& document, const Picture& picture);
// A word of such a line: quoted if a shell would interpret it.
std::string shell_word(std::string_view word);
// A path as a word of such a line, which no command takes for an option.
std::string file_word(const std::string& name);
// The beginning of such a line about found rungs. Their numbers depend on `choices`, the "LADDER=rung" that are chosen.
std::string accuracy_command(const std::string& scene, const std::vector<std::string>& choices);
// One that writes the scene with a found rung, such as "3+7", into the folder.
std::string apply_command(const std::string& scene, const std::vector<std::string>& choices, const std::string& rung,
                          const std::string& folder);

}  // namespace snell
