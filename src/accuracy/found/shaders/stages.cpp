// Work that moves from the fragment to the vertex shader, by a new varying.
#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy {

namespace {

using glsl::Form;
using glsl::Function;
using glsl::Global;
using glsl::Node;
using glsl::Storage;

constexpr std::size_t longest_work = 400;  // characters of an expression with its variables replaced

const Global* global_named(const Shader& s, std::string_view name, Storage storage) {
    const auto found = ranges::find_if(
        s.unit.globals, [&](const Global& g) { return g.name == name && g.qualifiers.storage == storage; });
    return found == s.unit.globals.end() ? nullptr : &*found;
}

// What a subexpression is made of.
struct Work {
    bool moves = false;             // the vertex shader can do it
    bool varies = false;            // it reads a varying
    int calls = 0, operations = 0;  // of its own text
    std::string text;               // with variables of main replaced by what they begin with
};

class Mover {
public:
    Mover(const Shader& vertex, const Shader& fragment, Offers& offers)
        : v_(vertex), f_(fragment), offers_(offers), from_(fragment.main()), to_(vertex.main()) {}

    void run() {
        if (!usable()) return;
        for (const Node& n : v_.tree)
            if (n.form == Form::declarator && v_.function_of(n.first) == to_) locals_.insert(n.text);
        for (const glsl::Token& t : v_.unit.tokens) words_.insert(t.text);
        works_.resize(f_.tree.size());
        std::map<ChangeKind, std::vector<int>> moved;
        for (int n = 0; n < f_.nodes() && !offers_.full(); ++n) works_[at(n)] = work_of(n);
        for (int n = 0; n < f_.nodes() && !offers_.full(); ++n) {
            const int around = f_.parent(n);
            if (!worth(n) || (around >= 0 && worth(around))) continue;
            const ChangeKind kind = works_[at(n)].varies ? ChangeKind::per_vertex : ChangeKind::per_frame;
            offer(kind, {n});
            moved[kind].push_back(n);
        }
        // Changes that declare a varying at one place are not made together, so all of them are one, too.
        for (const auto& [kind, nodes] : moved)
            if (nodes.size() > 1 && nodes.size() <= 4) offer(kind, nodes);
    }

private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
    const Function& main() const { return v_.function(to_); }

    // Both are main functions of the stages' own files, and the vertex shader's runs to its end.
    bool usable() const {
        if (from_ < 0 || to_ < 0 || !f_.ahead_of(from_) || !v_.ahead_of(to_)) return false;
        const int open = main().open, close = main().close;
        if (!v_.own(open, open) || !v_.own(close, close)) return false;
        if (v_.token(open).file != 0 || v_.token(close).file != 0) return false;
        if (f_.token(f_.function(from_).open).file != 0) return false;
        for (int k = open; k < close; ++k)
            if (v_.token(k).text == "return") return false;
        return true;
    }

    Work work_of(int node) const {
        const Node& n = f_.at(node);
        Work work;
        if (n.first < 0 || f_.function_of(n.first) != from_ || !f_.own(node) || f_.token(n.first).file != 0) return {};
        if (n.form == Form::name) return name(node);
        const bool computes = n.form == Form::number || n.form == Form::group || n.form == Form::select ||
                              n.form == Form::prefix || n.form == Form::infix || n.form == Form::construct ||
                              (n.form == Form::built_in && pure(n.text));
        if (!computes || n.type.dims > 0 || !n.type.basic() || n.type.base == glsl::Base::dreal) return {};
        work.calls = n.form == Form::built_in ? 1 : 0;
        work.operations = n.form == Form::infix ? 1 : 0;
        const Span all = f_.span(node);
        std::uint32_t from = all.begin;
        for (const int part : f_.parts(node)) {
            const Work& inside = works_[at(part)];
            if (!inside.moves) return {};
            const Span span = f_.span(part);
            work.text += f_.text({all.file, from, span.begin}) + inside.text;
            from = span.end;
            work.varies = work.varies || inside.varies;
            work.calls += inside.calls;
            work.operations += inside.operations;
            if (work.text.size() > longest_work) return {};
        }
        work.text += f_.text({all.file, from, all.end});
        work.moves = work.text.size() <= longest_work && work.text.find('/' + std::string("/")) == std::string::npos;
        return work;
    }

    static bool pure(std::string_view name) {
        for (const std::string_view start :
             {"te", "dF", "fw", "im", "inte", "noise", "ftransform", "at", "modf", "fre"})
            if (name.starts_with(start) && name != "atan" && name != "atanh") return false;
        return true;
    }

    Work name(int node) const {
        const Node& n = f_.at(node);
        Work work;
        if (n.variable < 0 || f_.written(node)) return {};
        work.text = n.text;
        if (n.global < 0) return variable(node);
        const Global& g = f_.unit.globals[at(n.global)];
        const glsl::Qualifiers& q = g.qualifiers;
        if (g.type.dims > 0 || !g.type.basic() || locals_.contains(n.text)) return {};
        const bool varying = q.storage == Storage::in && q.interpolation.empty() && q.auxiliary.empty();
        if (varying) {
            const Global* out = global_named(v_, n.text, Storage::out);
            const bool same =
                out && out->type.same(g.type) && out->qualifiers.interpolation.empty() && q.layout.empty();
            if (!same || !real_vector(g.type)) return {};
            work.varies = true;
        } else if (q.storage == Storage::uniform) {
            const Global* there = global_named(v_, n.text, Storage::uniform);
            if (there ? !there->type.same(g.type) : words_.contains(n.text)) return {};
        } else {
            return {};
        }
        work.moves = true;
        return work;
    }

    // A variable of main that keeps what it begins with.
    Work variable(int node) const {
        const Node& n = f_.at(node);
        const int declared = f_.declarator(n.variable);
        if (declared < 0 || declared > node) return {};
        const std::vector<int> inside = f_.parts(declared);
        if (inside.size() != 1 || !f_.at(inside[0]).type.same(n.type)) return {};
        if (f_.changes(n.variable)) return {};
        Work work = works_[at(inside[0])];
        work.calls = work.operations = 0;  // they move with the variable
        if (work.moves && !closed(f_.at(inside[0]))) work.text = "(" + work.text + ")";
        return work;
    }

    bool worth(int node) const {
        const Work& work = works_[at(node)];
        const Node& n = f_.at(node);
        if (!work.moves || n.constant || !real_vector(n.type) || n.form == Form::name || n.form == Form::group)
            return false;
        return work.varies ? work.calls > 0 || work.operations > 2 : work.calls > 0;
    }

    void offer(ChangeKind kind, const std::vector<int>& nodes) {
        std::vector<Edit> edits;
        std::set<std::string_view> uniforms;
        const Span reads = *f_.ahead_of(from_), writes = *v_.ahead_of(to_), end = v_.span(main().close, main().close);
        std::string inputs, outputs, statements;
        std::vector<Span> shown;
        for (const int n : nodes) {
            const std::string name = fmt::format("vFound_{}", f_.span(n).begin);
            const std::string_view type = f_.at(n).type.name;
            edits.push_back({f_.span(n), name});
            shown.push_back(f_.span(n));
            inputs += fmt::format("{} {} {};\n", varying_word(f_, "in"), type, name);
            outputs += fmt::format("{} {} {};\n", varying_word(v_, "out"), type, name);
            statements += fmt::format("    {} = {};\n", name, works_[at(n)].text);
            uniforms_of(n, uniforms);
        }
        for (const std::string_view name : uniforms) {
            const Global* g = global_named(f_, name, Storage::uniform);
            if (g && !global_named(v_, name, Storage::uniform))
                outputs += fmt::format("uniform {} {};\n", g->type.name, name);
        }
        edits.push_back(insertion(reads, reads.begin, inputs));
        edits.push_back(insertion(writes, writes.begin, outputs));
        edits.push_back(insertion(end, end.begin, statements));
        offers_.add(kind, shown, std::move(edits));
    }

    void uniforms_of(int node, std::set<std::string_view>& names) const {
        for (int k = f_.at(node).begin; k <= node; ++k) {
            const Node& n = f_.at(k);
            if (n.form != Form::name) continue;
            if (n.global < 0) {
                const int declared = n.variable < 0 ? -1 : f_.declarator(n.variable);
                if (declared >= 0 && declared < k && f_.parts(declared).size() == 1)
                    uniforms_of(f_.parts(declared).front(), names);
            } else if (f_.unit.globals[at(n.global)].qualifiers.storage == Storage::uniform) {
                names.insert(n.text);
            }
        }
    }

    const Shader &v_, &f_;
    Offers& offers_;
    int from_, to_;  // the functions main
    std::vector<Work> works_;
    std::set<std::string_view> locals_, words_;  // of the vertex shader: variables of main; all names
};

}  // namespace

void add_vertex_work(const Shader& vertex, const Shader& fragment, Offers& offers) {
    Mover(vertex, fragment, offers).run();
}

}  // namespace snell::accuracy
