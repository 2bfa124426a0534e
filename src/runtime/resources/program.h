// A program of the scene, compiled and linked, and what it asks of the runtime.
// Which sliders change nothing that a program computes, by the code that the driver makes of it.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "parser/text/diagnostic.h"
#include "src/gl/context.h"
#include "src/gl/program.h"
#include "src/glsl/glsl.h"
#include "src/plan/plan.h"
#include "src/plan/values/controls.h"
#include "src/runtime/resources/counters.h"
#include "src/runtime/resources/state.h"
#include "src/runtime/resources/store.h"

namespace snell::runtime {

// A uniform that the runtime sets, with what it was last set to.
struct SystemUniform {
    glsl::System system;
    GLenum kind = GL_FLOAT;  // GL_FLOAT_MAT4 …
    GLint location = -1;
    int size = 1;            // of the array
    std::size_t floats = 1;  // of all its elements
    std::vector<float> last;
};

// A uniform that a Control sets.
struct UserUniform {
    std::string name;
    ValueType type = ValueType::float_;
    GLenum kind = GL_FLOAT;  // GL_FLOAT_VEC3 …
    GLint location = -1;
    int components = 1, size = 1;
    std::vector<double> last;     // what the program holds
    std::vector<double> initial;  // what it holds where nothing sets it
};

// A sampler and the GL texture units that it was given for good; the scene's own units are only names.
struct SamplerUniform {
    std::string name;
    std::string_view type;                // GLSL's; static text
    std::optional<TextureTarget> target;  // none: a kind of sampler that scenes have no textures for
    GLint location = -1;
    int first_unit = 0, size = 1;
    std::vector<int> initial;  // units that the shader names itself, by layout(binding)
};

struct LinkedProgram {
    gl::Program program;
    std::vector<std::shared_ptr<gl::Shader>> shaders;  // for others that have the same stage
    std::vector<ActiveUniform> active;
    std::vector<glsl::DeclaredUniform> declared;
    std::vector<glsl::Settled> settled;  // uniforms that are constants in it
    // As far as anyone asked: the uniforms that are active if none is a constant; by `settled`, if only this one is.
    std::optional<std::vector<std::string>> general;
    std::vector<std::vector<std::string>> alone;
    std::vector<SystemUniform> system;
    std::optional<DrawContext> shown;  // what `system` was set from last
    std::vector<float> scratch;        // kept for its memory
    std::vector<UserUniform> user;
    std::vector<SamplerUniform> samplers;
    gl::Buffer blocks;         // zeros, for the scene's own uniform blocks; empty if there are none
    double load_ms = 0;        // to translate, compile and link
    bool opaque = false;       // writes alpha 1 whatever happens
    bool plain_depth = false;  // as Translation's
    bool in_place = false;     // vertices are where the mesh and the matrices have them
    bool reads_place = false;  // as Translation's
    std::vector<glsl::LongLoops> long_loops;
    bool tessellates = false;
    bool wide = false;          // its lines are triangles
    GLenum geometry_input = 0;  // 0: no geometry shader
    // Where vertex shaders stand for other stages: the programs whose outputs are captured. That of tessellation
    // (patches.cpp) comes first, those that count and capture what is emitted (stages.cpp) come last; where nothing is
    // captured, the program itself runs the stages. `active` and
    // `samplers` have theirs, too.
    std::optional<glsl::EmulatedTessellation> tessellation;
    std::optional<glsl::EmulatedGeometry> geometry;
    std::vector<std::unique_ptr<LinkedProgram>> parts;
    int stage_unit = 0;      // the first of GL's units that the mesh takes: three
    GLint stage_range = -1;  // the location of glsl::stage_range

    bool reads(glsl::System system) const;
    // Calls `each` for the parts and then for the program itself, in which everything is set that way.
    template <class Each>
    void in_turn(const Each& each) {
        for (std::size_t i = 0; i < parts.size(); ++i) each(*parts[i], i);
        each(*this, parts.size());
    }
    // The functions of the shaders that name the uniform, such as "main (fragment)".
    std::vector<std::string> functions_naming(std::string_view uniform) const;
};

// One program may be compiled in several ways.
struct Variant {
    bool flat = false;    // the legacy colours are not interpolated
    bool wide = false;    // lines are widened by a geometry stage of ours
    int outputs = 1;      // textures rendered to at once: gl_FragColor is written to each
    Rungs rungs;          // of the ladders that the program knows
    bool placed = false;  // for parts of pictures
    int settled = 0;      // 0: takes any values; else the number of the values that are constants in it
    int patch = 0;        // vertices of a patch, where the context has no tessellation; else 0
    bool operator==(const Variant&) const = default;
    // Not by <=>, which not every standard library has for vectors yet (libc++ only since version 17).
    bool operator<(const Variant& other) const {
        const auto all = [](const Variant& v) {
            return std::tie(v.flat, v.wide, v.outputs, v.rungs, v.placed, v.settled, v.patch);
        };
        return all(*this) < all(other);
    }
};

struct LinkRequest {
    const Program& program;
    const std::vector<glsl::StageInput>& stages;
    std::span<const Ladder> ladders;  // of Variant::rungs
    const Variant& variant;
    const gl::Caps& caps;
    Files& files;
    Sources& sources;
    Store* store;  // what it has is not compiled again; null: everything is compiled
    Counters& counters;
    glsl::Settler settle = nullptr;
    std::optional<glsl::Settled> constant = {};  // as glsl::Options
    std::string called = {};                     // what messages call the program
};

GLenum gl_stage(Stage stage);
// The texts that link_program compiles.
glsl::Translation translate(const LinkRequest& request, Diagnostics& diagnostics);
// Returns null if the program cannot be made; `diagnostics` says why, at the program's statement or in its shaders.
std::shared_ptr<LinkedProgram> link_program(const LinkRequest& request, Diagnostics& diagnostics);

// Fills `active`, `system`, `user` and `samplers` from the driver's list of active uniforms.
void find_uniforms(LinkedProgram& linked, const Program& program, const glsl::Translation& translation,
                   const gl::Caps& caps);
// Gives each sampler its GL units, for good.
void assign_units(const LinkedProgram& linked);

// Draws the current colour, unlit. Throws when it fails: nothing can be drawn in a context where that is so.
std::shared_ptr<LinkedProgram> link_builtin(const Variant& variant, const gl::Caps& caps, Store* store,
                                            Counters& counters);

// The values of a slider by which its effect is judged, both ends first. Numbers and truth values: all of them.
// Floats: eighths of the range, all numbers that `text` names in it, and the middles between these, so that a
// comparison with such a number is tried on both sides and at the number itself. Empty: more than 64 would be needed.
std::vector<double> telling_values(const Control& slider, std::string_view text);

// The time that a search may take.
struct Patience {
    double seconds;
    Stopwatch watch = {};
    bool ended() const { return watch.milliseconds() > 1000 * seconds; }
};

// Returns those of the sliders for which the driver makes the same code, whichever of these values is a constant in the
// place of the uniform. Nothing is tried once the patience has ended. Empty as well if the driver does not give its
// code, or gives it in a form that tells nothing.
std::vector<const Control*> without_effect(const LinkRequest& request, std::vector<const Control*> sliders,
                                           const Patience& patience);

}  // namespace snell::runtime
