// Parts of a scene as the statements that make them.
#pragma once

#include <string>
#include <string_view>

#include "parser/scene.h"

namespace snell::text_of {

// Shortest text that reads back to the same bits; `integral`: without point or exponent.
std::string number(double value, bool integral = false);
// In quotes where the name needs them.
std::string name(std::string_view name);
// Every shape but a vertex list: one statement.
std::string shape(const Scene& scene, const Shape& shape, bool wire);
std::string uniform(const UniformValue& uniform);
std::string ladder(const Ladder& ladder);
std::string texture(const Texture& texture);
std::string filter(const Filter& filter);
// "Perspective …" or "Ortho …".
std::string projection(const Camera& camera);
std::string look_at(const Camera& camera);
std::string numbers(std::string_view command, const double* values, std::size_t count);
// "Vertex", "TessControl", …
std::string_view stage_command(std::size_t stage);

}  // namespace snell::text_of
