// The values of uniforms that can be changed while a scene runs. They are plain values, made from the scene and its
// linked programs; sliders, command-line flags and tests write the same ones.
// How values are found again in another text: the names of controls, and what a control takes from another one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "parser/text/diagnostic.h"
#include "src/glsl/glsl.h"
#include "src/plan/values/programs.h"
#include "src/plan/values/rungs.h"

namespace snell {

enum class ValueType : std::uint8_t { float_, int_, uint_, bool_, matrix, sampler, double_ };

// An active uniform of a linked program, as the runtime found it.
struct ActiveUniform {
    std::string name;       // without "[0]"
    std::string glsl_type;  // "vec3", "sampler2D", …
    ValueType type = ValueType::float_;
    int components = 1;  // 1 to 4; for a matrix, columns times rows
    int array_size = 1;
    bool system = false;          // set by snell itself, such as matrices and Timer
    std::vector<double> initial;  // the value in the program after linking
};

enum class Widget : std::uint8_t { none, slider, check_box, color };

struct Control {
    Index program = 0;  // index into Scene::programs
    std::string name;
    ValueType type = ValueType::float_;
    int components = 1, array_size = 1;
    Widget widget = Widget::none;
    double min = 0, max = 1;                  // bounds of the slider: finite, min <= max
    double initial_min = 0, initial_max = 1;  // the scene's bounds, which a reset restores
    std::vector<double> value;                // components · array_size numbers
    std::vector<double> initial;              // the scene's values, which a reset restores
    bool active = true;                       // false if the linked program does not use the uniform
    bool varies = false;                      // frames change it, so programs are not made for its value
    bool listed = true;                       // false if the uniform is not on the Program line but was found active
    Index uniform = none;                     // index into Program::uniforms if listed
    Span span;
};

struct Controls {
    std::vector<Control> items;  // sorted by program, then as on the Program line; unlisted ones are last
    Rungs rungs;                 // the chosen rungs; empty: those that the programs were compiled for

    // Finds a control by its uniform's name, with or without "[0]"; returns null if there is none.
    Control* find(Index program, std::string_view name);
    const Control* find(Index program, std::string_view name) const;
};

// What the shaders of each of Scene::programs declare, to say why a uniform is not active.
struct Declared {
    const Sources& sources;
    std::vector<std::vector<glsl::DeclaredUniform>> programs = {};
};

// Makes the controls of all programs. `active[i]` holds the uniforms of Scene::programs[i], and is empty if that
// program failed to link. Reports uniforms that the program does not have, values that do not fit, and ranges that had
// to be corrected.
Controls make_controls(const Scene& scene, const std::vector<std::vector<ActiveUniform>>& active,
                       Diagnostics& diagnostics, const Declared* declared = nullptr);

// Restores the scene's value and range, of all components or of one.
void reset(Control& control);
void reset(Control& control, std::size_t component);

// All of them, in their order.
std::vector<double> values_of(const Controls& controls);
void set_values(Controls& controls, const std::vector<double>& values);

// True if both hold the same uniforms at the same places: an index into the one means the same in the other.
bool same_uniforms(const Controls& a, const Controls& b);

// Assigns the value that a text such as "uEta=1.3", "Glass.uEta=1.3", "uColor=1,.5,0", "uColor.g=.5" or "uOn=true"
// names. Returns false and reports an error, which suggests the nearest name, if there is no such uniform or the value
// does not fit.
bool set_control(Controls& controls, const Scene& scene, std::string_view assignment, Diagnostics& diagnostics);

// Copies the values of `from` to every control that both have (same program, name and type). `to` keeps its own
// value if the scene's text changed it, and its own range unless a value outside of it needs the wider one of `from`.
void carry_over(const Controls& from, const Scene& from_scene, Controls& to, const Scene& to_scene);

// The name without [n] and members: what shaders declare.
inline std::string_view base_name(std::string_view uniform) { return uniform.substr(0, uniform.find_first_of(".[")); }

// "Glass.uEta" for each control, or "Glass#2.uEta" in the second program of that name.
std::vector<std::string> control_names(const Scene& scene, const Controls& controls);

// Whether a value that the text has changed since follows the text.
enum class Follow : bool { memory, text };

// Gives a control the value of another one. Its range stays that of the text, unless the text has not changed it, or
// the value does not follow the text, and the value, outside of it, needs a wider one.
void take_value(const Control& from, Control& control, Follow follow = Follow::text);

}  // namespace snell
