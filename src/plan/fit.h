// Numbers in the types of uniforms. For src/plan alone.
#pragma once

#include "src/plan/controls.h"

namespace snell {

struct Range {
    double min, current, max;
};

// The nearest value that a uniform of that type can hold: integers rounded (halves away from zero), bool 0 or
// 1, texture units not negative, floats within float's range. NaN becomes 0.
double fit_to_type(double value, ValueType type);

// min and max as a slider of that type can have them: integers that are whole, and widths that overflow in no
// arithmetic on the way (half of the type's range, which is what user interfaces take).
Range limit_range(Range range, ValueType type);

// Widget and range for a uniform that the scene says nothing about.
void suggest_widget(Control& control);

}  // namespace snell
