#include "parser/names.h"

#include <algorithm>
#include <array>

namespace snell {
namespace {

constexpr std::array<std::string_view, 12> topologies{"gl_points",
                                                      "gl_lines",
                                                      "gl_line_strip",
                                                      "gl_line_loop",
                                                      "gl_triangles",
                                                      "gl_triangle_strip",
                                                      "gl_triangle_fan",
                                                      "gl_lines_adjacency",
                                                      "gl_line_strip_adjacency",
                                                      "gl_triangles_adjacency",
                                                      "gl_triangle_strip_adjacency",
                                                      "gl_patches"};

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

// The word at a place of a list of choices.
std::string_view choice(std::string_view choices, std::size_t place) {
    for (; place > 0; --place) choices.remove_prefix(choices.find('/') + 1);
    return choices.substr(0, choices.find('/'));
}

}  // namespace

std::optional<Topology> topology_named(std::string_view name) {
    for (std::size_t i = 0; i < topologies.size(); ++i) {
        const bool same = std::equal(name.begin(), name.end(), topologies[i].begin(), topologies[i].end(),
                                     [](char a, char b) { return lower(a) == b; });
        if (same) return static_cast<Topology>(i);
    }
    return std::nullopt;
}

std::string_view topology_name(Topology topology) { return topologies[static_cast<std::size_t>(topology)]; }

const std::vector<std::string_view>& topology_names() {
    static const std::vector<std::string_view> names(topologies.begin(), topologies.end());
    return names;
}

std::string_view blend_factor_name(BlendFactor factor) {
    return choice(SNELL_BLEND_FACTORS, static_cast<std::size_t>(factor));
}

std::string_view cull_face_name(CullFace face) { return choice("none/back/front", static_cast<std::size_t>(face)); }

std::string_view filter_name(Filter::Mode mode) {
    return choice("nearest/linear/mipmap/anisotropic", static_cast<std::size_t>(mode));
}

}  // namespace snell
