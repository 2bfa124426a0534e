#include "src/accuracy/found/change.h"

#include <array>
#include <cstdint>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

constexpr std::array<KindFacts, static_cast<std::size_t>(ChangeKind::count)> table{{
    {ChangeKind::fewer_rounds, Aim::cheaper, "fewer-rounds", "a loop goes round less often"},
    {ChangeKind::without_term, Aim::cheaper, "without-term", "a term of a sum or a blend is left out"},
    {ChangeKind::lookup_mean, Aim::cheaper, "lookup-mean", "a texture lookup is replaced by the texture's mean"},
    {ChangeKind::lookup_coarser, Aim::cheaper, "lookup-coarser", "a texture is looked up at a coarser level"},
    {ChangeKind::expression_mean, Aim::cheaper, "expression-mean", "an expression is replaced by its mean"},
    {ChangeKind::polynomial, Aim::cheaper, "polynomial", "a function is replaced by a polynomial with a bound"},
    {ChangeKind::per_vertex, Aim::cheaper, "per-vertex", "work moves from the fragment to the vertex shader"},
    {ChangeKind::per_frame, Aim::cheaper, "per-frame", "work on uniforms alone is done once for each vertex"},
    {ChangeKind::half_precision, Aim::cheaper, "half-precision", "values are rounded as phones with mediump do"},
    {ChangeKind::lower_levels, Aim::cheaper, "lower-levels", "patches are tessellated less"},
    {ChangeKind::smaller_noise, Aim::cheaper, "smaller-noise", "the noise texture has fewer texels"},
    {ChangeKind::fewer_texels, Aim::cheaper, "fewer-texels", "textures that are drawn to have fewer texels"},
    {ChangeKind::fewer_cells, Aim::cheaper, "fewer-cells", "a grid of quads has fewer cells"},
    {ChangeKind::fewer_slices, Aim::cheaper, "fewer-slices", "a round shape has fewer slices and stacks"},
    {ChangeKind::culled, Aim::cheaper, "culled", "faces of a solid that face away are culled"},
    {ChangeKind::less_filtered, Aim::cheaper, "less-filtered", "a texture is filtered less"},
    {ChangeKind::unit_length, Aim::better, "unit-length", "a direction gets unit length"},
    {ChangeKind::derivatives_outside, Aim::better, "derivatives-outside",
     "a lookup in a branch gets its level outside"},
    {ChangeKind::more_rounds, Aim::better, "more-rounds", "a loop goes round more often"},
    {ChangeKind::exact_fresnel, Aim::better, "exact-fresnel", "the exact Fresnel equations for Schlick's formula"},
    {ChangeKind::both_interfaces, Aim::better, "both-interfaces", "light is bent where it leaves, too"},
    {ChangeKind::box_projection, Aim::better, "box-projection", "the room of the cube map is near, not infinitely far"},
    {ChangeKind::lint_fix, Aim::better, "lint-fix", "what a lint advises"},
    {ChangeKind::finer_cells, Aim::better, "finer-cells", "a grid of quads has more cells"},
    {ChangeKind::more_slices, Aim::better, "more-slices", "a round shape has more slices and stacks"},
    {ChangeKind::filtered, Aim::better, "filtered", "a texture is filtered instead of nearest"},
    {ChangeKind::decoded, Aim::better, "decoded", "textures are decoded to light before they are used"},
    {ChangeKind::no_draw, Aim::unused, "no-draw", "a draw is left out"},
    {ChangeKind::no_texture, Aim::unused, "no-texture", "a texture is left out"},
    {ChangeKind::no_uniform, Aim::unused, "no-uniform", "a uniform of the Program line is left out"},
    {ChangeKind::no_statement, Aim::unused, "no-statement", "a statement of a shader is left out"},
}};

constexpr bool in_order() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (static_cast<std::size_t>(table[i].kind) != i) return false;
    return true;
}
static_assert(in_order(), "facts() looks the rows up by their kind");

bool touch(const Span& a, const Span& b) {
    if (a.file != b.file) return false;
    // Two insertions at one place, or one at the edge of a replacement, would depend on their order.
    return a.begin <= b.end && b.begin <= a.end;
}

}  // namespace

const KindFacts& facts(ChangeKind kind) { return table[static_cast<std::size_t>(kind)]; }

bool compatible(const Change& a, const Change& b) {
    return ranges::none_of(a.edits, [&](const Edit& one) {
        return ranges::any_of(b.edits, [&](const Edit& other) { return touch(one.span, other.span); });
    });
}

std::map<std::string, std::string> changed_texts(std::span<const Change* const> changes, const Sources& sources) {
    std::map<std::string_view, std::vector<Edit>> by_name;  // a text that was read twice has two numbers
    for (const Change* change : changes)
        for (const Edit& edit : change->edits) by_name[sources.name(edit.span.file)].push_back(edit);
    std::map<std::string, std::string> texts;
    for (auto& [name, edits] : by_name) {
        const FileId file = edits.front().span.file;
        for (Edit& edit : edits) edit.span.file = file;
        ranges::stable_sort(edits, {}, [](const Edit& edit) { return std::pair(edit.span.begin, edit.span.end); });
        texts.emplace(name, with_edits(sources.text(file), file, edits));
    }
    return texts;
}

std::string excerpt(std::string_view text) {
    constexpr std::size_t most = 60;
    std::string line;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\r' || c == '\n';
        if (!blank)
            line += c;
        else if (!line.empty() && line.back() != ' ')
            line += ' ';
    }
    if (!line.empty() && line.back() == ' ') line.pop_back();
    if (line.size() <= most) return line;
    std::size_t head = most / 2 - 1, tail = line.size() - most / 2 + 2;
    const auto inside = [&](std::size_t at) { return (static_cast<unsigned char>(line[at]) & 0xC0u) == 0x80u; };
    while (head > 0 && inside(head)) --head;
    while (tail < line.size() && inside(tail)) ++tail;
    return line.substr(0, head) + "…" + line.substr(tail);
}

}  // namespace snell::accuracy
