// The values of uniforms that may be changed while a scene runs. Plain values, made from the scene and the
// linked programs; sliders, command-line flags and tests write the same ones.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "parser/scene.h"
#include "src/plan/rungs.h"

namespace snell {

enum class ValueType : std::uint8_t { float_, int_, uint_, bool_, matrix, sampler, double_ };

// An active uniform of a linked program, as the runtime found it.
struct ActiveUniform {
    std::string name;       // without "[0]"
    std::string glsl_type;  // "vec3", "sampler2D", …
    ValueType type = ValueType::float_;
    int components = 1;  // 1..4; columns·rows of a matrix
    int array_size = 1;
    int location = -1;
    bool system = false;          // set by the runtime (matrices, Timer …)
    std::vector<double> initial;  // what the program has after linking
};

enum class Widget : std::uint8_t { none, slider, check_box, color };

struct Control {
    Index program = 0;  // Scene::programs
    std::string name;
    ValueType type = ValueType::float_;
    int components = 1, array_size = 1;
    Widget widget = Widget::none;
    double min = 0, max = 1;      // sliders; finite, min <= max
    std::vector<double> value;    // components · array_size
    std::vector<double> initial;  // the scene's (reset)
    bool active = true;           // false: the linked program does not have it
    bool listed = true;           // false: not on the Program line, found active
    Index uniform = none;         // Program::uniforms, when listed
    Span span;
};

struct Controls {
    std::vector<Control> items;  // by program, then in the order of the Program line; unlisted ones last
    Rungs rungs;                 // none: those that the programs were compiled for

    Control* find(Index program, std::string_view name);
    const Control* find(Index program, std::string_view name) const;
};

// `active[i]` are the uniforms of Scene::programs[i] (empty when it failed to link). Reports uniforms that
// the program does not have, values that don't fit, ranges that had to be mended.
Controls make_controls(const Scene& scene, const std::vector<std::vector<ActiveUniform>>& active,
                       Diagnostics& diagnostics);

// "uEta=1.3", "Glass.uEta=1.3", "uColor=1,.5,0", "uColor.g=.5", "uOn=true". False, with an error that suggests the
// nearest name, when there is no such uniform or the value does not fit.
bool set_control(Controls& controls, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics);

// The values of `from` for every control that both have (same program name, name and type); `to` keeps its
// own where the scene's text changed the value.
void carry_over(const Controls& from, const Scene& from_scene, Controls& to, const Scene& to_scene);

}  // namespace snell
