// Expressions that their mean over the picture may replace.
#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy {

namespace {

using glsl::Form;
using glsl::Node;

constexpr int deepest_call = 4, most_work = 1'000'000;
constexpr std::array<std::string_view, 14> transcendental{"sin", "cos",  "tan", "asin", "acos", "atan",        "pow",
                                                          "exp", "exp2", "log", "log2", "sqrt", "inversesqrt", "noise"};

class Averages {
public:
    Averages(const Shader& shader, const std::vector<Change>& changes, Offers& offers)
        : s_(shader), changes_(changes), offers_(offers) {
        for (int n = 0; n < s_.nodes(); ++n) {
            if (s_.at(n).form == Form::call) called_.insert(s_.at(n).text);
            const int f = s_.at(n).first < 0 ? -1 : s_.function_of(s_.at(n).first);
            if (f >= 0) bodies_[s_.function(f).name].push_back(n);
        }
    }

    void run() {
        const std::string output = s_.plan.scene.output == Encoding::raw ? colour_output(s_) : "";
        if (output.empty() || !in_window()) return;
        struct Candidate {
            int node, work;
        };
        std::vector<Candidate> found;
        for (int n = 0; n < s_.nodes(); ++n)
            if (const int work = fits(n) && s_.runs(s_.at(n).first) ? work_of(n) : 0; work > 0)
                found.push_back({n, work});
        // Those that take most work; of equals, the first.
        ranges::stable_sort(found, std::greater<>(), &Candidate::work);
        const auto known = static_cast<std::size_t>(
            ranges::count(changes_, ChangeKind::expression_mean, [](const Change& c) { return c.kind; }));
        found.resize(std::min(found.size(), most_expression_means - std::min(known, most_expression_means)));
        for (const Candidate& candidate : found) offer(candidate.node, output);
    }

private:
    // What is drawn to textures may be read again, and would then be another picture.
    bool in_window() const {
        const Scene& scene = s_.plan.scene;
        return ranges::all_of(scene.passes, [&](const Pass& pass) {
            return pass.kind == Pass::Kind::window || ranges::none_of(pass.items, [&](const Item& item) {
                       return item.kind == Item::Kind::draw && s_.programs.contains(scene.draws[item.index].program);
                   });
        });
    }

    // All that a local variable begins with, an argument of mix, or a factor.
    bool fits(int n) const {
        const Node& node = s_.at(n);
        if (node.first < 0 || node.constant || !real_vector(node.type) || !s_.own(n)) return false;
        const int within = s_.function_of(node.first), around = s_.parent(n);
        if (within < 0 || around < 0 || !s_.ahead_of(within) || s_.in_free_loop(node.first)) return false;
        // main adds up what the probe declares ahead of the function.
        if (s_.function(within).open > s_.function(main_).open) return false;
        if (within != main_ && !called_.contains(s_.function(within).name)) return false;
        const Node& outer = s_.at(around);
        // What a loop declares has another value in each round, or decides on their number.
        const bool initial = outer.form == Form::declarator && outer.type.same(node.type) && s_.loop_around(around) < 0;
        const bool blended = outer.form == Form::built_in && outer.text == "mix";
        const bool factor = outer.form == Form::infix && outer.text == "*" && real_vector(outer.type);
        const bool plain = node.form != Form::name && node.form != Form::choose && node.form != Form::assign;
        return (initial || blended || factor) && plain && !has_mean(n);
    }

    // A texture's mean is known without drawing.
    bool has_mean(int n) const {
        n = s_.bare(n);
        while (s_.at(n).form == Form::select) n = s_.bare(s_.parts(n)[0]);
        if (s_.at(n).form != Form::built_in) return false;
        const Span span = s_.span(n);
        return ranges::any_of(changes_,
                              [&](const Change& c) { return c.kind == ChangeKind::lookup_mean && c.where == span; });
    }

    // About how many operations nodes take, and whether they do more than to give a value.
    struct Cost {
        int work = 0;
        bool effects = false;
    };

    // About how many operations are saved; 0: none that cost anything, or it does more than to give a value.
    int work_of(int n) {
        Cost cost;
        for (int k = s_.at(n).begin; k <= n; ++k) {
            cost.effects = cost.effects || s_.at(k).form == Form::step || s_.at(k).form == Form::assign;
            add_node(k, 0, cost);
        }
        return cost.effects ? 0 : cost.work;
    }

    void add_node(int k, int depth, Cost& cost) {
        const Node& n = s_.at(k);
        if (cost.effects) return;
        if (n.form == Form::name && n.global >= 0 && s_.written(k)) cost.effects = true;
        if (n.form == Form::built_in && n.text.starts_with("texture")) cost.work += 8;
        if (n.form == Form::built_in && ranges::find(transcendental, n.text) != transcendental.end()) cost.work += 2;
        if (n.form != Form::call) return;
        const auto gives = [](const glsl::Parameter& p) { return p.storage != glsl::Storage::in; };
        if (n.function < 0 || depth == deepest_call || ranges::any_of(s_.function(n.function).parameters, gives)) {
            cost.effects = true;
            return;
        }
        const Cost called = cost_of_calling(n.text, depth + 1);
        cost.effects = called.effects;
        cost.work = std::min(cost.work + 4 + called.work, most_work);
    }

    // Of all functions of the name. Known ones are not looked at again: there may be very many ways to a function.
    Cost cost_of_calling(std::string_view name, int depth) {
        if (const auto known = costs_.find({name, depth}); known != costs_.end()) return known->second;
        const auto body = bodies_.find(name);
        Cost cost{.effects = body == bodies_.end()};
        if (!cost.effects)
            for (const int k : body->second) add_node(k, depth, cost);
        return costs_[{name, depth}] = cost;
    }

    void offer(int n, const std::string& output) {
        const std::string type(s_.at(n).type.name);
        const Span span = s_.span(n);
        Change change{ChangeKind::expression_mean,
                      span,
                      excerpt(s_.text(n)),
                      type + "(its mean over the picture)",
                      {{span, type + "(0.)"}}};
        for (int channel = 0; channel < s_.at(n).type.rows; channel += 2)
            change.probes.push_back(probe(n, type, output, channel));
        offers_.add(std::move(change));
    }

    // A shader that writes the mean of two components over all times that it computes the expression.
    std::vector<Edit> probe(int n, const std::string& type, const std::string& output, int channel) const {
        const Span span = s_.span(n), ahead = *s_.ahead_of(s_.function_of(s_.at(n).first));
        const int rows = s_.at(n).type.rows;
        const auto component = [&](int c) {
            return rows == 1 ? std::string("snellSum") : fmt::format("snellSum.{}", "xyzw"[std::min(c, rows - 1)]);
        };
        std::vector<Edit> edits{
            {ahead, fmt::format("{0} snellSum = {0}(0.);\nfloat snellCount = 0.;\n{0} snellSeen({0} x) {{ snellSum += "
                                "x; snellCount += 1.; return x; }}\n",
                                type)},
            insertion(span, span.begin, "snellSeen("),
            insertion(span, span.end, ")")};
        add_behind_main(
            s_,
            fmt::format("{} = snellCount > 0. ? vec4({} / snellCount, {} / snellCount, {:.1f}, 1.) : vec4(0.);", output,
                        component(channel), component(channel + 1), probe_mark),
            edits);
        return edits;
    }

    const Shader& s_;
    const std::vector<Change>& changes_;
    Offers& offers_;
    int main_ = s_.main();
    std::set<std::string_view> called_;
    std::map<std::string_view, std::vector<int>> bodies_;     // the nodes of the functions of a name
    std::map<std::pair<std::string_view, int>, Cost> costs_;  // by name and depth
};

}  // namespace

// It can be called by another main, which is then the shader's.
bool has_own_main(const Shader& shader) {
    const int main = shader.main();
    if (main < 0 || !shader.ahead_of(main)) return false;
    const glsl::Function& function = shader.function(main);
    return shader.own(function.name_token, function.name_token) && shader.own(function.close, function.close);
}

std::string colour_output(const Shader& fragment) {
    if (!has_own_main(fragment)) return {};
    std::string name = "gl_FragColor";
    int outputs = 0;
    for (const glsl::Global& global : fragment.unit.globals) {
        if (global.qualifiers.storage != glsl::Storage::out) continue;
        const bool colour = real_vector(global.type) && global.type.rows == 4;
        if (!colour || ++outputs > 1) return {};
        name = global.name;
    }
    return name;
}

void add_behind_main(const Shader& shader, const std::string& statement, std::vector<Edit>& edits) {
    const glsl::Function& main = shader.function(shader.main());
    const Span close = shader.span(main.close, main.close);
    edits.push_back({shader.span(main.name_token, main.name_token), "snellAuthorMain"});
    edits.push_back(
        insertion(close, close.end, fmt::format("\nvoid main() {{\n    snellAuthorMain();\n    {}\n}}\n", statement)));
}

void add_expression_means(const Shader& fragment, const std::vector<Change>& changes, Offers& offers) {
    Averages(fragment, changes, offers).run();
}

}  // namespace snell::accuracy
