// Uniforms by their types: what values they hold, and whether the scene or snell sets them.
#pragma once

#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "src/glsl/glsl.h"
#include "src/plan/values/controls.h"

namespace snell {

struct TypeFacts {
    ValueType type = ValueType::float_;
    int components = 1;
};
// Of a type of GLSL without array brackets, such as "vec3".
TypeFacts type_facts(std::string_view glsl_type);

// The row of `names` that snell sets as this uniform of the program; null if there is none, or the scene sets the name
// itself.
const glsl::SystemName* find_system(const std::vector<glsl::SystemName>& names, std::string_view name,
                                    std::string_view type, const Program& program);
// True if snell sets a uniform of that name and type, because the scene does not.
bool set_by_snell(const Program& program, std::string_view name, std::string_view type);
// The uniform as a linked program would have it if it is active.
ActiveUniform described(const Program& program, const glsl::DeclaredUniform& declared);

// True if the scene gives elements of the array widgets of their own, as in "uWeights[1] <0. .5 1.>", and names it
// nowhere as a whole: each element is a uniform of its own then, as it is for OpenGL.
bool has_sliders_of_elements(const Program& program, const ActiveUniform& array);
// One uniform for each element, such as "uWeights[1]".
std::vector<ActiveUniform> elements_of(const ActiveUniform& array);

// Fits numbers to the types of uniforms. For use in src/plan only.

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
