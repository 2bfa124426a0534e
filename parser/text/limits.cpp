#include "parser/text/limits.h"

#include <algorithm>
#include <array>

#include "parser/text/number.h"

namespace snell {
namespace {

constexpr std::uint64_t million = 1'000'000, gib = std::uint64_t{1} << 30;

// Offsets in a text are 32 bits wide, and so are the indices of vertices: six for each.
constexpr std::array<LimitFacts, 20> table{{
    {"text-bytes", &Limits::text_bytes, "bytes", "of the text of one scene or included scene", 4 * gib - 1},
    {"statements", &Limits::statements, "statements", "of a scene and the files that it includes", 1000 * million},
    {"include-depth", &Limits::include_depth, "files", "that include each other in a chain, of scenes or shaders",
     1000},
    {"includes", &Limits::includes, "files", "that are included, of a scene or a program", 60'000},
    {"expression-depth", &Limits::expression_depth, "operators, brackets and statements",
     "of a shader, each within the one before", 5'000},
    {"matrix-stack", &Limits::matrix_stack, "matrices", "pushed at once", 100 * million},
    {"draws", &Limits::draws, "draws", "of a scene", 1000 * million},
    {"passes", &Limits::passes, "passes", "of a scene", million},
    {"uniforms", &Limits::uniforms, "uniforms", "set by one program", million},
    {"diagnostics", &Limits::diagnostics, "messages", "about one scene", 100 * million},
    {"message-bytes", &Limits::message_bytes, "bytes", "of one message, of a MessageBox or about a scene", gib},
    {"file-bytes", &Limits::file_bytes, "bytes", "of one file that a scene names", 64 * gib},
    {"vertices", &Limits::vertices, "vertices", "of one shape or mesh", 500 * million},
    {"sub-quads", &Limits::sub_quads, "quads", "of one QuadXY, QuadXZ, QuadYZ or QuadBox", 100 * million},
    {"texture-side", &Limits::texture_side, "texels", "along a side of a texture", million},
    {"texture-bytes", &Limits::texture_bytes, "bytes", "of the pixels of a texture, or of a face of a cube map",
     64 * gib},
    {"noise-2d", &Limits::noise_2d, "texels", "along a side of 2D noise", 16'384},
    {"noise-3d", &Limits::noise_3d, "texels", "along a side of 3D noise", 1'024},
    {"output-side", &Limits::output_side, "pixels", "along a side of a picture or a window", 65'536},
    {"output-bytes", &Limits::output_bytes, "bytes",
     "of the part of a picture that is drawn at once, with samples and depth", 256 * gib},
}};
static_assert(sizeof(Limits) == table.size() * sizeof(std::uint64_t), "every limit has its row");

}  // namespace

std::span<const LimitFacts> limit_table() { return table; }

bool set_limit(Limits& limits, std::string_view text, std::string& error) {
    const std::size_t equals = text.find('=');
    const std::string_view name = text.substr(0, equals);
    const auto row = std::find_if(table.begin(), table.end(), [&](const LimitFacts& l) { return l.name == name; });
    if (row == table.end()) {
        error = "there is no limit '" + std::string(name) + "'; available:";
        for (const LimitFacts& limit : table) error += " " + std::string(limit.name);
        return false;
    }
    const auto value = read_whole<std::uint64_t>(equals == text.npos ? "" : text.substr(equals + 1));
    if (!value || *value < 1 || *value > row->most) {
        error = "'" + std::string(text) + "': the limit is a whole number from 1 to " + std::to_string(row->most);
        return false;
    }
    limits.*row->value = *value;
    return true;
}

std::string limit_help(std::uint64_t now, std::uint64_t Limits::*limit) {
    const auto row = std::find_if(table.begin(), table.end(), [&](const LimitFacts& l) { return l.value == limit; });
    if (row == table.end()) return {};
    return "the limit '" + std::string(row->name) + "' is " + std::to_string(now) + " " + std::string(row->unit) +
           "; --limit " + std::string(row->name) + "=N changes it";
}

}  // namespace snell
