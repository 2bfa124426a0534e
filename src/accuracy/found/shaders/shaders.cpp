// Cheaper changes of the shaders of a scene.
#include <algorithm>
#include <tuple>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/plan/texts.h"

namespace snell::accuracy {

namespace {

using Stages = std::vector<const Shader*>;

// Two stages that are joined, and whose own files nothing else reads.
bool can_share_work(const Reading& reading, const Stages& stages) {
    const Shader *vertex = stage_of(stages, Stage::vertex), *fragment = stage_of(stages, Stage::fragment);
    if (stages.size() != 2 || !vertex || !fragment) return false;
    const FileId a = vertex->files.front(), b = fragment->files.front();
    std::set<Index> readers;
    for (const Shader& shader : reading.shaders)
        for (const FileId file : shader.files)
            if (file == a || file == b) readers.insert(shader.programs.begin(), shader.programs.end());
    return a != b && readers.size() == 1;
}

// Takes from the kinds that have most.
void keep_most(std::vector<Change>& changes) {
    std::map<ChangeKind, std::size_t> counts;
    for (const Change& change : changes) ++counts[change.kind];
    const auto left = [&](std::size_t most) {
        std::size_t sum = 0;
        for (const auto& [kind, count] : counts) sum += std::min(count, most);
        return sum;
    };
    std::size_t most = most_shader_changes;
    while (most > 1 && left(most) > most_shader_changes) --most;
    std::map<ChangeKind, std::size_t> kept;
    std::erase_if(changes, [&](const Change& change) { return ++kept[change.kind] > most; });
}

}  // namespace

void add_shader_changes(const Reading& reading, std::vector<Change>& changes) {
    Means means(reading.plan, reading.files);
    std::vector<Change> found;
    Offers offers(reading.files, reading.sources, found, 10 * most_shader_changes);
    std::set<Index> drawn;  // programs
    for (const Draw& draw : reading.plan.scene.draws) drawn.insert(draw.program);
    const auto small = [](const Shader& shader) { return shader.unit.tokens.size() <= most_tokens; };
    for (const Shader& shader : reading.shaders) {
        const bool in_use = ranges::any_of(shader.programs, [&](Index p) { return drawn.contains(p); });
        if (!in_use || !small(shader)) continue;
        add_rounds(shader, offers);
        if (shader.unit.stage == Stage::tess_control) add_lower_levels(shader, offers);
        if (!shader.fragment()) continue;
        add_shorter_sums(shader, offers);
        add_lookups(shader, means, offers);
        add_polynomials(shader, offers);
        add_expression_means(shader, found, offers);
    }
    for (const Index program : drawn) {
        const Stages stages = reading.stages(program);
        const bool all_small = ranges::all_of(stages, [&](const Shader* s) { return small(*s); });
        if (all_small && can_share_work(reading, stages))
            add_vertex_work(*stage_of(stages, Stage::vertex), *stage_of(stages, Stage::fragment), offers);
    }
    std::stable_sort(found.begin(), found.end(), [](const Change& a, const Change& b) {
        return std::tuple(a.where.file, a.where.begin, a.where.end, a.kind) <
               std::tuple(b.where.file, b.where.begin, b.where.end, b.kind);
    });
    keep_most(found);
    changes.insert(changes.end(), std::make_move_iterator(found.begin()), std::make_move_iterator(found.end()));
}

// Lower levels of tessellation.

namespace {

using glsl::Form;

bool levels(std::string_view name) { return name == "gl_TessLevelOuter" || name == "gl_TessLevelInner"; }

bool is_level(const Shader& shader, int node) {
    return shader.at(node).form == Form::index && levels(shader.at(shader.at(node).begin).text);
}

bool stores_level(const Shader& shader, int node) {
    const glsl::Node& n = shader.at(node);
    return n.form == Form::assign && n.text == "=" && is_level(shader, shader.parts(node)[0]);
}

// The value that the node stores in a level; -1: it does no such thing.
int level(const Shader& shader, int node) {
    if (!stores_level(shader, node)) return -1;
    const int value = shader.parts(node)[1];
    // a = gl_TessLevelOuter[1] = …: the inner one is enough. a = gl_TessLevelOuter[1]: that one is smaller already.
    const int bare = shader.bare(value);
    return shader.at(bare).form == Form::assign || is_level(shader, bare) ? -1 : value;
}

// Whether a value depends on levels in another way than by being one.
bool computes_with_levels(const Shader& shader) {
    for (int n = 0; n < shader.nodes(); ++n) {
        if (shader.at(n).form != Form::name || !levels(shader.at(n).text)) continue;
        int around = shader.parent(n);
        if (around < 0 || !is_level(shader, around)) return true;
        do around = shader.parent(around);
        while (around >= 0 && shader.at(around).form == Form::group);
        if (around < 0 || !stores_level(shader, around)) return true;
    }
    return false;
}

}  // namespace

// All levels together, so that patches still meet.
void add_lower_levels(const Shader& control, Offers& offers) {
    std::vector<int> values;
    for (int n = 0; n < control.nodes(); ++n)
        if (const int value = level(control, n); value >= 0) values.push_back(value);
    if (values.empty() || computes_with_levels(control)) return;
    for (const double share : {.75, .5, .25}) {
        std::vector<Edit> edits;
        for (const int value : values) {
            const glsl::Node& n = control.at(value);
            if (!control.own(value)) return;
            const std::string text = control.text(value);
            edits.push_back({control.span(value), real_literal(share) + "*" + (closed(n) ? text : "(" + text + ")")});
        }
        offers.add(ChangeKind::lower_levels, control.span(control.parent(values.front())), std::move(edits));
    }
}

}  // namespace snell::accuracy
