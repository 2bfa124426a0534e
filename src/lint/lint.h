// What compiles and runs, and yet is probably not meant: warnings for `snell check` and the window. No GL; nothing here
// runs before a scene's picture is drawn, but for loops where llvmpipe draws (src/app/open/warnings.h).
//
// The shaders of each program are walked as they would run, from main() through the functions it calls, with facts
// instead of numbers: whether a vector has unit length, in which space it is, between which bounds a number lies. A
// fact that is not known for certain is unknown, and nothing is said about it.
#pragma once

#include <span>
#include <string_view>

#include "parser/text/diagnostic.h"
#include "parser/text/source.h"
#include "src/glsl/glsl.h"
#include "src/plan/plan.h"

namespace snell::lint {

enum class Rule : std::uint8_t {
    unnormalised_direction,
    eye_space_lookup,
    index_as_ratio,
    program_not_drawn,
    shadowed_uniform,
    sampler_kind,
    samplers_share_unit,
    pow_of_negative,
    schlick_sign,
    dispersion_order,
    never_read,
    viewer_not_at_origin,
    lookup_in_branch,
    many_rounds,
    far_from_origin,
    smoothstep_without_width,
    encoded_light,
    position_not_written,
    point_size_unused,
    rung_number,
    slider_without_effect,  // found by the driver's code of the programs: Runtime::without_effect
};

struct RuleFacts {
    Rule rule;
    Severity severity;
    std::string_view code;     // of the diagnostic
    std::string_view anchor;   // of its section in docs/teaching.md
    std::string_view finds;    // what it finds, for the reference
    std::string_view instead;  // what to write instead; the diagnostic's help
};

// One row for each Rule, in the order of the enumeration. docs/lints.md is written from it.
std::span<const RuleFacts> rules();
const RuleFacts& facts(Rule rule);

// Where a reader finds more about it: "snell help CODE".
std::string more(const RuleFacts& rule);

// All that is found in the scene and its shaders, as the plan's rungs choose them, in source order. Included texts
// are added to `sources`; what is found in those that `include` gives for angle brackets is not reported, for they
// are not the user's.
Diagnostics check(const Plan& plan, Sources& sources, const glsl::IncludeReader& include);

// Whether the finding is of a shader that certainly never ends.
bool never_ends(const Diagnostic& found);
// Whether a shader has so many rounds that a picture of it may take for ever, or be ended by the driver: what it shows
// tells nothing.
bool may_not_end(const Diagnostics& found);

}  // namespace snell::lint
