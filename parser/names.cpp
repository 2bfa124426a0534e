#include "parser/names.h"

#include <algorithm>
#include <array>

#include "parser/text/words.h"

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

// The word at a place of a list of choices.
std::string_view choice(std::string_view choices, std::size_t place) { return split_choices(choices)[place]; }

}  // namespace

std::vector<std::string_view> split_choices(std::string_view choices) {
    std::vector<std::string_view> words;
    while (!choices.empty()) {
        const std::size_t end = std::min(choices.find('/'), choices.size());
        words.push_back(choices.substr(0, end));
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return words;
}

int find_choice(std::string_view choices, std::string_view word) {
    if (choices == "on/off") {
        if (word == "1" || same_word(word, "true")) return 0;
        if (word == "0" || same_word(word, "false")) return 1;
    }
    for (int i = 0; !choices.empty(); ++i) {
        const std::size_t end = std::min(choices.find('/'), choices.size());
        if (same_word(choices.substr(0, end), word)) return i;
        choices.remove_prefix(std::min(end + 1, choices.size()));
    }
    return -1;
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
