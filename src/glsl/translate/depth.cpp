// Whether the planes that depth is measured between may be moved without any other change of the picture.
#include <algorithm>
#include <array>
#include <initializer_list>

#include "src/glsl/translate/program.h"

namespace snell::glsl {
namespace {

bool matches(const Unit& u, std::size_t at, std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words)
        if (at >= u.tokens.size() || u.tokens[at++].text != word) return false;
    return true;
}

// Matches the assignments that multiply the unchanged vertex by the unchanged matrices.
bool is_plain_position(const Unit& u, std::size_t at) {
    return matches(u, at, {"gl_Position", "=", "ftransform", "(", ")", ";"}) ||
           matches(u, at, {"gl_Position", "=", "gl_ModelViewProjectionMatrix", "*", "gl_Vertex", ";"}) ||
           matches(u, at,
                   {"gl_Position", "=", "gl_ProjectionMatrix", "*", "gl_ModelViewMatrix", "*", "gl_Vertex", ";"}) ||
           matches(u, at, {"gl_Position", "=", "uModelViewProjectionMatrix", "*", "aVertex", ";"});
}

bool is_across(std::string_view swizzle) {
    constexpr std::array<std::string_view, 8> across = {"x", "y", "xy", "yx", "s", "t", "st", "rg"};
    return std::find(across.begin(), across.end(), swizzle) != across.end();
}

// Depths and the projection depend on the near and far planes.
bool depends(const Unit& u, std::size_t at) {
    const std::string_view word = u.tokens[at].text;
    if (word == "gl_FragCoord")
        return !(matches(u, at + 1, {"."}) && at + 2 < u.tokens.size() && is_across(u.tokens[at + 2].text));
    return word == "gl_FragDepth" || word == "gl_Position" || word == "ftransform" ||
           word.find("Projection") != std::string_view::npos;
}

}  // namespace

bool has_plain_depth(Program& program) {
    if (program.units.size() != 2) return false;
    const Unit* vertex = program.find(Stage::vertex);
    if (!vertex || vertex->legacy_written.contains("gl_Vertex")) return false;
    int positions = 0;
    for (const Unit& u : program.units)
        for (std::size_t at = 0; at < u.tokens.size(); ++at) {
            if (&u == vertex && is_plain_position(u, at)) {
                ++positions;
                while (u.tokens[at].text != ";") ++at;
            } else if (u.tokens[at].kind == Kind::identifier && depends(u, at)) {
                return false;
            }
        }
    return positions == 1;
}

}  // namespace snell::glsl
