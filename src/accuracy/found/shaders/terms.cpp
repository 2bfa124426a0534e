// Terms of sums and blends that are left out; texture lookups at coarser levels, or replaced by the mean of the
// texture.
#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/accuracy/found/shaders/shader.h"

namespace snell::accuracy {

namespace {

using glsl::Form;
using glsl::Global;
using glsl::Node;

// ---- sums ---------------------------------------------------------------------------------------------------

bool is_sum(const Node& n) { return n.form == Form::infix && (n.text == "+" || n.text == "-") && real_vector(n.type); }

class Sums {
public:
    Sums(const Shader& shader, Offers& offers) : s_(shader), offers_(offers) {}

    void run() {
        for (int n = 0; n < s_.nodes(); ++n) {
            const Node& node = s_.at(n);
            const std::vector<int> inside = s_.parts(n);
            if (offers_.full()) return;
            if (node.first < 0 || s_.function_of(node.first) < 0 || s_.in_free_loop(node.first)) continue;
            if (node.form == Form::built_in && node.text == "mix" && inside.size() == 3) blend(n, inside);
            if (node.form == Form::evaluated && inside.size() == 1) statement(n, inside[0]);
            const bool holds = node.form == Form::declarator || node.form == Form::returned;
            if (holds && inside.size() == 1 && !in_header(n)) search(inside[0]);
        }
    }

private:
    // Whether it takes work that leaving it out saves.
    bool costs(int node) const {
        if (s_.at(node).constant) return false;
        for (int k = s_.at(node).begin; k <= node; ++k) {
            const Node& n = s_.at(k);
            if (n.form == Form::infix || n.form == Form::call || n.form == Form::built_in) return true;
            if (n.form == Form::name && n.global < 0 && n.variable >= 0 && only_here(k, node)) return true;
        }
        return false;
    }

    // A local that nothing else reads: the work on it is saved, too.
    bool only_here(int name, int node) const {
        return ranges::all_of(s_.uses(s_.at(name).variable),
                              [&](int use) { return s_.written(use) || (s_.at(node).begin <= use && use <= node); });
    }

    // A part of the header of a loop, which must end.
    bool in_header(int node) const {
        if (s_.at(node).form == Form::declarator) node = s_.parent(node);
        const int around = node < 0 ? -1 : s_.parent(node);
        return around >= 0 && s_.at(around).form == Form::loop && s_.parts(around).back() != node;
    }

    // Whether a variable decides on how often a loop around goes round.
    bool counts(int node) const {
        const int first = s_.at(node).begin;
        if (s_.at(first).form != Form::name) return true;
        for (int around = s_.parent(node); around >= 0; around = s_.parent(around)) {
            if (s_.at(around).form != Form::loop) continue;
            int depth = 0;
            for (int k = s_.at(around).first + 1; k <= s_.at(around).last; ++k) {
                depth += s_.token(k).text == "(" ? 1 : s_.token(k).text == ")" ? -1 : 0;
                if (depth == 0) break;
                if (s_.token(k).text == s_.at(first).text) return true;
            }
        }
        return false;
    }

    void statement(int node, int inside) {
        const Node& assigned = s_.at(inside);
        if (assigned.form != Form::assign || counts(inside)) return;
        const std::vector<int> sides = s_.parts(inside);
        if (sides.size() != 2) return;
        if (assigned.text == "=" || assigned.text == "*=" || assigned.text == "/=") return search(sides[1]);
        if ((assigned.text != "+=" && assigned.text != "-=") || !real_vector(assigned.type)) return;
        search(sides[1]);
        if (!costs(sides[1]) || !s_.own(node)) return;
        const int first = s_.at(inside).first;
        if (!can_go(s_.unit, s_.function(s_.function_of(first)), first, true)) return;
        // Where an `if` holds nothing else, its semicolon stays.
        const std::string_view before = s_.token(s_.at(node).first - 1).text;
        const bool alone = before != ";" && before != "{" && before != "}";
        offers_.add(ChangeKind::without_term, s_.span(node), {{s_.span(node), alone ? ";" : ""}});
    }

    // The sums that an expression is, or is made of by products, constructors and choices.
    void search(int node, int depth = 0) {
        const Node& n = s_.at(node);
        if (n.constant || depth > 30) return;
        if (is_sum(n)) return shorten(node, depth);
        const bool kept = n.form == Form::built_in && (n.text == "clamp" || n.text == "min" || n.text == "max" ||
                                                       n.text == "mix" || n.text == "normalize");
        const bool through = kept || n.form == Form::group || n.form == Form::construct || n.form == Form::choose ||
                             (n.form == Form::infix && (n.text == "*" || n.text == "/"));
        if (!through) return;
        const std::vector<int> inside = s_.parts(node);
        for (std::size_t k = n.form == Form::choose ? 1 : 0; k < inside.size(); ++k) {
            if (n.text == "/" && k == 1) break;
            search(inside[k], depth + 1);
        }
    }

    // The terms of a sum from the left.
    std::vector<int> terms_of(int node) const {
        std::vector<int> terms;
        while (is_sum(s_.at(node)) && s_.parts(node).size() == 2) {
            terms.push_back(s_.parts(node)[1]);
            node = s_.parts(node)[0];
        }
        terms.push_back(node);
        return {terms.rbegin(), terms.rend()};
    }

    void shorten(int sum, int depth) {
        const std::vector<int> terms = terms_of(sum);
        if (terms.size() > 30 || terms.size() < 2) return;
        for (std::size_t k = 0; k < terms.size(); ++k) {
            const Node& term = s_.at(terms[k]);
            if (!is_sum(s_.at(s_.bare(terms[k])))) search(terms[k], depth + 1);
            const auto typed = [&](int other) { return other != terms[k] && s_.at(other).type.same(s_.at(sum).type); };
            if (!ranges::any_of(terms, typed) || !costs(terms[k]) || !s_.own(sum)) continue;
            Span gone = s_.span(terms[k]);
            if (k > 0) {  // its operator, too
                gone.begin = s_.unit.span(term.first - 2).end;
            } else {
                const int next = s_.at(terms[1]).first;
                gone.end = s_.unit.span(s_.token(next - 1).text == "-" ? next - 1 : next).begin;
            }
            offers_.add(ChangeKind::without_term, s_.span(sum), {{gone, ""}});
        }
    }

    void blend(int node, const std::vector<int>& given) {
        const Node& n = s_.at(node);
        if (!real_vector(n.type) || n.constant || !s_.own(node)) return;
        for (const int stays : {given[0], given[1]}) {
            const Node& kept = s_.at(stays);
            if (!kept.type.same(n.type)) continue;
            const std::string text = s_.text(stays);
            offers_.add(ChangeKind::without_term, s_.span(node),
                        {{s_.span(node), closed(kept) ? text : "(" + text + ")"}});
        }
    }

    const Shader& s_;
    Offers& offers_;
};

// ---- lookups ------------------------------------------------------------------------------------------------

// Every so many texels are enough for four digits.
constexpr std::size_t most_texels = std::size_t{1} << 20;

void sum_texels(const content::Image& image, std::array<double, 4>& sum, std::size_t& count) {
    const std::size_t texels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                               static_cast<std::size_t>(image.depth);
    const std::size_t step = texels / most_texels * 2 + 1;
    for (std::size_t t = 0; t < texels; t += step, ++count)
        for (std::size_t c = 0; c < 4; ++c) sum[c] += static_cast<double>(content::value_at(image, 4 * t + c));
}

class Lookups {
public:
    Lookups(const Shader& shader, Means& means, Offers& offers) : s_(shader), means_(means), offers_(offers) {}

    void run() {
        for (int n = 0; n < s_.nodes() && !offers_.full(); ++n) {
            const Node& call = s_.at(n);
            const std::vector<int> given = s_.parts(n);
            const bool lookup = call.form == Form::built_in && call.text.starts_with("texture") && given.size() > 1 &&
                                call.type.base == glsl::Base::real && call.type.rows == 4 &&
                                !call.text.starts_with("textureGather") && s_.function_of(call.first) >= 0;
            if (!lookup || !s_.own(n)) continue;
            const std::string_view type = s_.at(given[0]).type.name;
            if (type != "sampler2D" && type != "samplerCube") continue;
            const std::set<Index>& textures = textures_of(s_.bare(given[0]));
            if (textures.size() == 1 && !s_.in_free_loop(call.first)) mean(n, *textures.begin());
        }
    }

private:
    // The textures that a sampler reads in the scene's draws; none if they are not known.
    const std::set<Index>& textures_of(int node) {
        static const std::set<Index> unknown;
        const int variable = s_.at(node).variable;
        if (s_.at(node).form != Form::name || variable < 0 || samplers_.size() > 64) return unknown;
        const auto [known, fresh] = samplers_.try_emplace(variable);
        if (fresh && !textures_of(node, known->second, 0)) known->second.clear();
        return known->second;
    }

    bool textures_of(int node, std::set<Index>& textures, int depth) const {
        const Node& n = s_.at(s_.bare(node));
        if (n.form != Form::name || n.variable < 0 || depth > 4) return false;
        if (n.global >= 0) return bound_to(s_.unit.globals[static_cast<std::size_t>(n.global)], textures);
        // A parameter: what all calls hand on.
        const int function = s_.function_of(n.first);
        if (function < 0) return false;
        const auto& parameters = s_.function(function).parameters;
        const auto is_it = [&](const glsl::Parameter& p) { return p.variable == n.variable; };
        const auto which = static_cast<std::size_t>(ranges::find_if(parameters, is_it) - parameters.begin());
        if (which >= parameters.size()) return false;
        const std::string_view name = s_.function(function).name;
        for (int k = 0; k < s_.nodes(); ++k) {
            const Node& call = s_.at(k);
            if (call.form != Form::call || call.text != name) continue;
            const std::vector<int> given = s_.parts(k);
            if (given.size() == parameters.size() && !textures_of(given[which], textures, depth + 1)) return false;
        }
        return true;
    }

    bool bound_to(const Global& sampler, std::set<Index>& textures) const {
        const Scene& scene = s_.plan.scene;
        const auto target = sampler_target(sampler.name, sampler.type.name);
        if (!target || sampler.type.dims > 0 || sampler.name == "Noise2" || sampler.name == "Noise3") return false;
        for (const Draw& draw : scene.draws) {
            if (!s_.programs.contains(draw.program)) continue;
            int unit = std::max(sampler.qualifiers.layout_number("binding"), 0);
            for (const UniformValue& u : scene.programs[draw.program].uniforms)
                if (u.name == sampler.name && !u.values.empty())
                    unit = static_cast<int>(std::clamp(
                        u.values[u.kind == UniformValue::Kind::range && u.values.size() > 1 ? 1 : 0], 0., 1e6));
            const Index texture = find_texture(scene, draw, unit, *target);
            if (texture == none) return false;
            textures.insert(texture);
        }
        return true;
    }

    void mean(int call, Index texture) {
        const auto& mean = means_.of(texture);
        if (!mean) return;
        std::vector<std::string> channels;
        for (const double channel : *mean) channels.push_back(real_literal(channel, 4));
        offers_.add(ChangeKind::lookup_mean, s_.span(call),
                    {{s_.span(call), fmt::format("vec4({})", fmt::join(channels, ", "))}});
    }

    const Shader& s_;
    Means& means_;
    Offers& offers_;
    std::map<int, std::set<Index>> samplers_;  // by Code::variables
};

}  // namespace

const std::optional<std::array<double, 4>>& Means::of(Index index) {
    const auto [known, fresh] = known_.try_emplace(index);
    const Scene& scene = plan_.scene;
    const Texture& texture = scene.textures[index];
    const auto drawn = [&](const Pass& pass) {
        return pass.kind != Pass::Kind::window && ranges::count(pass.textures, index) > 0;
    };
    if (!fresh || texture.files.empty() || texture.computed != Computed::no || ranges::any_of(scene.passes, drawn))
        return known->second;
    Diagnostics problems;
    std::array<double, 4> sum{};
    std::size_t count = 0;
    if (texture.target == TextureTarget::cube)
        for (const content::Image& face : load_cube(scene, index, files_, problems, &cache_))
            sum_texels(face, sum, count);
    else
        sum_texels(load_texture(scene, index, files_, problems, &cache_), sum, count);
    for (double& channel : sum) channel /= static_cast<double>(std::max<std::size_t>(count, 1));
    const bool finite = ranges::all_of(sum, [](double x) { return std::abs(x) < 1e6; });
    if (!problems.has_errors() && count > 0 && finite) known->second = sum;
    return known->second;
}

void add_shorter_sums(const Shader& fragment, Offers& offers) { Sums(fragment, offers).run(); }

void add_lookups(const Shader& fragment, Means& means, Offers& offers) { Lookups(fragment, means, offers).run(); }

}  // namespace snell::accuracy
