#include "parser/names.h"

#include <array>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {
namespace {

constexpr std::array<std::string_view, 12> topologies = {"gl_points",
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

// The word at a place of a list of choices.
std::string_view choice(std::string_view choices, std::size_t place) { return split(choices, '/')[place]; }

}  // namespace

int find_choice(std::string_view choices, std::string_view word) {
    if (choices == "on/off") {
        if (word == "1" || same_word(word, "true")) return 0;
        if (word == "0" || same_word(word, "false")) return 1;
    }
    const std::vector<std::string_view> words = split(choices, '/');
    const auto found = ranges::find_if(words, [&](std::string_view w) { return same_word(w, word); });
    return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

std::optional<Topology> topology_named(std::string_view name) {
    for (std::size_t i = 0; i < topologies.size(); ++i) {
        if (same_word(name, topologies[i])) return static_cast<Topology>(i);
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
