// Fits numbers to the types of uniforms. For use in src/plan only.
#pragma once

#include "src/plan/values/controls.h"

namespace snell {

struct Range {
    double min, current, max;
};

// Returns the nearest value that a uniform of that type can hold: integers are rounded (halves away from zero), bool
// becomes 0 or 1, texture units are not negative, floats stay within float's range. NaN becomes 0.
double fit_to_type(double value, ValueType type);

// Limits min and max to what a slider of that type supports: whole numbers for integers, and at most half of the type's
// range, so that max - min cannot overflow.
Range limit_range(Range range, ValueType type);

// Chooses widget and range for a uniform whose range the scene does not give.
void suggest_widget(Control& control);

}  // namespace snell
