// Parts of a scene as statements, and the language's names for the values of enumerations.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "parser/scene.h"

namespace snell::text_of {

// Formats parts of a scene as statements.

// Returns the shortest text that reads back to the same bits; with `integral`, without point or exponent.
std::string number(double value, bool integral = false);
// Quotes the name if necessary.
std::string name(std::string_view name);
// Formats any shape, other than a vertex list, as one statement.
std::string shape(const Scene& scene, const Shape& shape, bool wire);
std::string uniform(const UniformValue& uniform);
std::string ladder(const Ladder& ladder);
std::string texture(const Texture& texture);
std::string filter(const Filter& filter);
// Formats as "Perspective …" or "Ortho …".
std::string projection(const Camera& camera);
std::string look_at(const Camera& camera);
std::string numbers(std::string_view command, const double* values, std::size_t count);
// Returns "Vertex", "TessControl", …
std::string_view stage_command(std::size_t stage);

}  // namespace snell::text_of

namespace snell {

// The language's names for the values of enumerations, used for both reading and writing.

// Returns the index of a word among the choices, without regard to case, or -1. For on and off, it also accepts 1, 0,
// true and false.
int find_choice(std::string_view choices, std::string_view word);

std::optional<Topology> topology_named(std::string_view name);  // without regard to case
std::string_view topology_name(Topology topology);
const std::vector<std::string_view>& topology_names();

// In the order of BlendFactor, in the form of a signature's choices.
#define SNELL_BLEND_FACTORS                                                                               \
    "zero/one/src_color/one_minus_src_color/dst_color/one_minus_dst_color/src_alpha/one_minus_src_alpha/" \
    "dst_alpha/one_minus_dst_alpha/src_alpha_saturate"
std::string_view blend_factor_name(BlendFactor factor);
std::string_view cull_face_name(CullFace face);
std::string_view filter_name(Filter::Mode mode);

}  // namespace snell
