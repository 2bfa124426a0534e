// Formats parts of a scene as statements.
#pragma once

#include <string>
#include <string_view>

#include "parser/scene.h"

namespace snell::text_of {

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
