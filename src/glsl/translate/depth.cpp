// Whether the planes that depth is measured between may be moved without any other change of the picture, and where
// vertices are known to be.
#include <algorithm>
#include <array>
#include <initializer_list>

#include "parser/text/ranges.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {
namespace {

bool matches(const Unit& u, std::size_t at, std::initializer_list<std::string_view> words) {
    for (const std::string_view word : words)
        if (at >= u.tokens.size() || u.tokens[at++].text != word) return false;
    return true;
}

// Matches the assignments that multiply the unchanged vertex by the unchanged matrices.
bool is_legacy_position(const Unit& u, std::size_t at) {
    return matches(u, at, {"gl_Position", "=", "ftransform", "(", ")", ";"}) ||
           matches(u, at, {"gl_Position", "=", "gl_ModelViewProjectionMatrix", "*", "gl_Vertex", ";"}) ||
           matches(u, at,
                   {"gl_Position", "=", "gl_ProjectionMatrix", "*", "gl_ModelViewMatrix", "*", "gl_Vertex", ";"});
}

bool is_plain_position(const Unit& u, std::size_t at) {
    return is_legacy_position(u, at) ||
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

const Global* used_at(const Unit& u, std::size_t at, Storage storage) {
    for (const Global& g : u.globals)
        if (g.qualifiers.storage == storage && !g.written && g.type.base == Base::real && g.type.dims == 0 &&
            ranges::count(g.uses, static_cast<int>(at)) > 0)
            return &g;
    return nullptr;
}

bool is_position(const Global* input, std::uint8_t rows) {
    return input && input->type.cols == 1 && input->type.rows == rows && attribute_of(*input) == Attribute::vertex;
}

// Returns the name of the matrix where `gl_Position = MATRIX * VERTEX;` or `gl_Position = MATRIX * vec4(VERTEX, 1.);`
// begins, with variables that the shader declares; empty elsewhere.
std::string declared_position(const Unit& u, std::size_t at) {
    if (!matches(u, at, {"gl_Position", "="}) || at + 4 >= u.tokens.size() || !matches(u, at + 3, {"*"})) return {};
    const Global* matrix = used_at(u, at + 2, Storage::uniform);
    if (!matrix || matrix->type.rows != 4 || matrix->type.cols != 4) return {};
    static const std::vector<SystemName> names = system_names();
    if (ranges::none_of(names, [&](const SystemName& name) {
            return name.system == System::model_view_projection && name.name == matrix->name;
        }))
        return {};
    const bool short_vertex = matches(u, at + 4, {"vec4", "("});
    const std::size_t vertex = short_vertex ? at + 6 : at + 4;
    if (!is_position(used_at(u, vertex, Storage::in), short_vertex ? 3 : 4)) return {};
    const bool ends =
        short_vertex ? matches(u, vertex + 1, {",", "1.", ")", ";"}) || matches(u, vertex + 1, {",", "1.0", ")", ";"})
                     : matches(u, vertex + 1, {";"});
    return ends ? std::string(matrix->name) : std::string();
}

bool writes_memory(const Token& token) {
    return token.kind == Kind::identifier &&
           (token.text == "buffer" || token.text.starts_with("image") || token.text.starts_with("atomic"));
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

std::string placed_by(Program& program) {
    const Unit* vertex = program.find(Stage::vertex);
    if (program.units.size() != 2 || !vertex || vertex->legacy_written.contains("gl_Vertex")) return {};
    std::string matrix;
    for (std::size_t at = 0; at < vertex->tokens.size(); ++at) {
        if (writes_memory(vertex->tokens[at])) return {};
        if (vertex->tokens[at].text != "gl_Position") continue;
        if (!matrix.empty()) return {};
        matrix = is_legacy_position(*vertex, at) ? "gl_ModelViewProjectionMatrix" : declared_position(*vertex, at);
        if (matrix.empty()) return {};
    }
    return matrix;
}

}  // namespace snell::glsl
