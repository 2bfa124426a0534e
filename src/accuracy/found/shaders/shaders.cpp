// Cheaper changes of the shaders of a scene.
#include <algorithm>
#include <memory>
#include <tuple>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"
#include "src/plan/texts.h"

namespace snell::accuracy {

namespace {

using Stages = std::vector<std::unique_ptr<Shader>>;

// The shaders of every program, in the scene's order; none for those that are not drawn.
class ShaderReader {
public:
    ShaderReader(const Plan& plan, Files& files, Sources& sources) : plan_(plan), sources_(sources) {
        include_ = shader_includes(files);
        for (const PlannedProgram& planned : plan.programs) {
            const auto draws = [&](const Draw& draw) { return draw.program == planned.program; };
            programs.emplace_back();
            if (planned.readable && ranges::any_of(plan.scene.draws, draws)) read(planned);
        }
    }

    std::vector<Stages> programs;
    // The programs that read a file.
    std::map<FileId, std::set<Index>> readers;

private:
    void read(const PlannedProgram& planned) {
        for (const glsl::StageInput& stage : planned.stages) {
            auto shader = std::make_unique<Shader>(plan_, planned.program, stage, sources_, include_);
            for (const FileId file : shader->files) readers[file].insert(planned.program);
            programs.back().push_back(std::move(shader));
        }
    }

    const Plan& plan_;
    Sources& sources_;
    glsl::IncludeReader include_;
};

const Shader* stage_of(const Stages& stages, Stage stage) {
    const auto found = ranges::find_if(stages, [&](const auto& s) { return s->unit.stage == stage; });
    return found == stages.end() ? nullptr : found->get();
}

// Two stages that are joined, and whose own files nothing else reads.
bool can_share_work(const ShaderReader& reader, const Stages& stages) {
    const Shader *vertex = stage_of(stages, Stage::vertex), *fragment = stage_of(stages, Stage::fragment);
    if (stages.size() != 2 || !vertex || !fragment) return false;
    const FileId a = vertex->files.front(), b = fragment->files.front();
    return a != b && reader.readers.at(a).size() == 1 && reader.readers.at(b).size() == 1;
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

void add_shader_changes(const Plan& plan, Files& files, Sources& sources, std::vector<Change>& changes) {
    const ShaderReader reader(plan, files, sources);
    Means means(plan, files);
    std::vector<Change> found;
    Offers offers(sources, found);
    for (const Stages& stages : reader.programs) {
        const auto large = [](const auto& shader) { return shader->unit.tokens.size() > most_tokens; };
        if (ranges::any_of(stages, large)) continue;
        for (const auto& shader : stages) {
            add_rounds(*shader, offers);
            if (shader->unit.stage == Stage::tess_control) add_lower_levels(*shader, offers);
            if (!shader->fragment()) continue;
            add_shorter_sums(*shader, offers);
            add_lookups(*shader, means, offers);
            add_polynomials(*shader, offers);
            add_expression_means(*shader, found, offers);
        }
        if (can_share_work(reader, stages))
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
            const glsl::Type real{.base = glsl::Base::real};
            const std::string text = control.text(value);
            edits.push_back({control.span(value), literal(share, real) + "*" + (closed(n) ? text : "(" + text + ")")});
        }
        offers.add(ChangeKind::lower_levels, control.span(control.parent(values.front())), std::move(edits));
    }
}

}  // namespace snell::accuracy
