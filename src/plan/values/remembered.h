// Values and rungs by name, so that they outlive the text that they were set in: a reload, a program that is broken for
// a while, another scene, the end of the program.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "src/plan/values/controls.h"

namespace snell {

struct RememberedValue {
    std::vector<double> value, initial;       // `initial`: what the text said when the value was set
    double min = 0, max = 1;                  // the range of a slider, which may have been widened
    double initial_min = 0, initial_max = 1;  // the range in the text
    bool operator==(const RememberedValue&) const = default;
};

struct RememberedRung {
    std::string rung, initial;  // the chosen one, and the one that the text marked
    bool operator==(const RememberedRung&) const = default;
};

struct Remembered {
    std::map<std::string, RememberedValue> values;  // by control_names()
    std::map<std::string, RememberedRung> rungs;    // by the ladder's name
    bool operator==(const Remembered&) const = default;
};

// "Glass.uEta" for each control, or "Glass#2.uEta" in the second program of that name.
std::vector<std::string> control_names(const Scene& scene, const Controls& controls);

RememberedValue remembered(const Control& control);

// Notes what differs from the scene, and forgets what no longer does. What the scene does not have stays, and so does
// the value of a uniform that the program still uses but its line no longer lists. With `all`, the scene's own values
// are noted too.
void remember(const Scene& scene, const Controls& controls, Remembered& memory, bool all = false);

// Whether a value that the text has changed since follows the text.
enum class Follow : bool { memory, text };

// Sets the control's value. Its range stays that of the text, unless the text has not changed it, or the value does not
// follow the text, and the value, outside of it, needs a wider one.
void take_value(const RememberedValue& from, Control& control, Follow follow = Follow::text);

// Sets the values that are remembered. Returns true if that changed any.
bool recall(const Remembered& memory, const Scene& scene, Controls& controls, Follow follow = Follow::text);
// Sets the rungs, before programs are compiled for them.
bool recall(const Remembered& memory, const Scene& scene, Rungs& rungs, Follow follow = Follow::text);

}  // namespace snell
