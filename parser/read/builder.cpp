#include "parser/read/builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace snell {
namespace {

// The result is false for NaN, too.
bool representable(double v) { return std::abs(v) <= std::numeric_limits<float>::max(); }

}  // namespace

std::string file_name(std::string_view written) {
    std::string name;
    name.reserve(written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
        const bool backslash = written[i] == '\\';
        const bool separator = backslash || written[i] == '/';
        const bool again =
            separator && i > 0 && !name.empty() && name.back() == '/' && (backslash || written[i - 1] == '\\');
        if (!again) name += separator ? '/' : written[i];
    }
    return name;
}

Builder::Builder(Scene& scene, Collector& report, const Limits& limits, std::size_t text_bytes)
    : scene_(scene), report_(report), limits_(limits), text_bytes_(text_bytes) {
    scene_.passes.emplace_back();
}

// Doubling would leave half of the memory of a long list unused, and twice of it in use while it grows.
template <class T>
void Builder::append(std::vector<T>& list, T value) {
    if (list.size() == list.capacity() && list.size() >= 64) {
        const double done = static_cast<double>(read_bytes_ + 1) / static_cast<double>(text_bytes_ + 1);
        const double foretold = static_cast<double>(list.size()) / std::max(done, 1e-9) * 1.02 + 64;
        const auto size = static_cast<double>(list.size());
        list.reserve(static_cast<std::size_t>(std::clamp(foretold, size * 1.25, size * 8)));
    }
    list.push_back(std::move(value));
}

// Equal values are found by comparing with the last one only: a list of a million states must not be searched for each
// draw.
template <class T>
Index Builder::index_of(Current<T>& current, std::vector<T>& list) {
    if (current.index == none) {
        if (list.empty() || list.back() != current.value) append(list, current.value);
        current.index = static_cast<Index>(list.size() - 1);
    }
    return current.index;
}

void Builder::set_background(const Vec4& color) {
    pass().background = color;
    if (pass().kind == Pass::Kind::window) scene_.background = color;
}

bool Builder::transform(const Mat4& by) {
    const Mat4& m = matrix_.value;
    Mat4 product{};
    bool good = true;
    for (std::size_t column = 0; column < 4; ++column) {
        const double* const b = &by[column * 4];
        for (std::size_t row = 0; row < 3; ++row) {
            const double sum = m[row] * b[0] + m[4 + row] * b[1] + m[8 + row] * b[2] + m[12 + row] * b[3];
            good = good && representable(sum);
            product[column * 4 + row] = sum;
        }
        product[column * 4 + 3] = b[3];  // the last row of every transformation of the language is 0 0 0 1
    }
    if (!good) return false;
    matrix_.set(product);
    return true;
}

void Builder::push_matrix(Span span) {
    if (stack_.size() >= limits_.matrix_stack) {
        if (refused_pushes_++ == 0)
            report_.error("matrix-stack-full", span,
                          "more than " + std::to_string(limits_.matrix_stack) + " matrices are pushed",
                          "every PushMatrix needs its PopMatrix; " + limit_help(limits_, &Limits::matrix_stack));
        return;
    }
    stack_.push_back({matrix_, span});
}

void Builder::pop_matrix(Span span) {
    if (refused_pushes_ > 0) {
        --refused_pushes_;
    } else if (stack_.empty()) {
        report_.warning("unbalanced-pop", span, "PopMatrix without a PushMatrix before it: nothing to restore");
    } else {
        matrix_ = stack_.back().entry;
        stack_.pop_back();
    }
}

void Builder::bind(Texture texture) {
    const int unit = texture.unit;
    const TextureTarget target = texture.target;
    const auto index = static_cast<Index>(scene_.textures.size());
    append(scene_.textures, std::move(texture));
    auto& entries = bindings_.value.entries;
    const auto before = [](const Bindings::Entry& a, const Bindings::Entry& b) {
        return a.unit != b.unit ? a.unit < b.unit : a.target < b.target;
    };
    const Bindings::Entry entry{unit, target, index};
    const auto at = std::lower_bound(entries.begin(), entries.end(), entry, before);
    if (at != entries.end() && at->unit == unit && at->target == target) {
        at->texture = index;
    } else {
        entries.insert(at, entry);
    }
    bindings_.index = none;
}

std::optional<Index> Builder::bound(int unit, TextureTarget target) const {
    for (const Bindings::Entry& entry : bindings_.value.entries)
        if (entry.unit == unit && entry.target == target) return entry.texture;
    return std::nullopt;
}

// Each limit is reported once.
void Builder::refuse(std::string_view code, std::uint64_t Limits::*limit, Span span) {
    if (!refused_.insert(code).second) return;
    report_.error(code, span, "only the first " + std::to_string(limits_.*limit) + " are kept",
                  limit_help(limits_, limit));
}

void Builder::begin_pass(Pass pass) {
    if (scene_.passes.size() >= limits_.passes)
        refuse("too-many-passes", &Limits::passes, pass.span);
    else
        append(scene_.passes, std::move(pass));
}

void Builder::begin_program(Program program) {
    program.stages = stages;
    program.geometry_input = geometry_input;
    program.geometry_output = geometry_output;
    program.ladders = scene_.ladders.size();
    program_ = static_cast<Index>(scene_.programs.size());
    append(scene_.programs, std::move(program));
}

Program* Builder::program() { return program_ == none ? nullptr : &scene_.programs[program_]; }

void Builder::draw(const Shape& shape, Span span, bool wire) {
    if (scene_.draws.size() >= limits_.draws) {
        refuse("too-many-draws", &Limits::draws, span);
        return;
    }
    Draw draw;
    draw.shape = shape;
    draw.wire = wire;
    draw.matrix = index_of(matrix_, scene_.matrices);
    draw.camera = index_of(camera_, scene_.cameras);
    draw.raster = index_of(raster_, scene_.rasters);
    draw.bindings = index_of(bindings_, scene_.bindings);
    draw.color = index_of(color_, scene_.colors);
    draw.program = program_;
    draw.span = span;
    append(pass().items, Item{Item::Kind::draw, static_cast<Index>(scene_.draws.size())});
    append(scene_.draws, draw);
}

void Builder::clear(Span span) {
    append(pass().items, Item{Item::Kind::clear, static_cast<Index>(scene_.clears.size())});
    append(scene_.clears, Clear{span});
}

Index Builder::file(std::string_view name, Span span) {
    std::string key = file_name(name);
    const auto [at, added] = files_.try_emplace(from + '\n' + key, static_cast<Index>(scene_.files.size()));
    if (added) append(scene_.files, FileName{std::move(key), span, from});
    return at->second;
}

VertexListData* Builder::open_list() { return open_list_ == none ? nullptr : &scene_.vertex_lists[open_list_]; }

Index Builder::add_list(VertexListData list) {
    append(scene_.vertex_lists, std::move(list));
    return static_cast<Index>(scene_.vertex_lists.size() - 1);
}

// The state of a list's draw is what stands at its glBegin. Without a topology (it was misspelt) the vertices
// that follow have a place to go to, but nothing is drawn.
void Builder::begin_list(std::optional<Topology> topology, Span span) {
    if (in_list_) {
        report_.error("nested-begin", span, "glBegin before the glEnd of another one", "the first list ends here")
            .notes.push_back({list_span_, "the other glBegin"});
    }
    in_list_ = true;
    list_span_ = span;
    list_color_ = color();
    open_list_ = none;
    if (!topology) return;
    VertexListData list;
    list.topology = *topology;
    if (*topology == Topology::patches) list.patch_vertices = patch_vertices;
    open_list_ = add_list(std::move(list));
    draw(VertexList{open_list_}, span);
}

void Builder::end_list(Span span) {
    if (!in_list_) report_.warning("unbalanced-end", span, "glEnd without a glBegin before it");
    in_list_ = false;
    open_list_ = none;
}

void Builder::finish() {
    if (in_list_) report_.warning("unclosed-begin", list_span_, "this glBegin has no glEnd");
    if (!stack_.empty()) {
        Diagnostic& d = report_.warning("unclosed-push", stack_.front().span, "this PushMatrix has no PopMatrix");
        constexpr std::size_t most_notes = 3;
        for (std::size_t i = 1; i < std::min(stack_.size(), most_notes + 1); ++i)
            d.notes.push_back({stack_[i].span, "nor has this one"});
        if (stack_.size() > most_notes + 1)
            d.help = "and " + std::to_string(stack_.size() - most_notes - 1) + " more have none";
    }
}

}  // namespace snell
