// Estimates how often loops repeat, without running the shader.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "parser/text/ranges.h"
#include "src/lint/walker.h"

namespace snell::lint {

namespace {

using glsl::Form;
using glsl::Node;

constexpr double endless = std::numeric_limits<double>::infinity();

// llvmpipe counts the rounds of all loops of a shader together, and one more each time that a loop is left.
constexpr double most_rounds = 65535;

constexpr std::string_view go_round_text = "the loops of this shader go round ";

std::string rounds_text(double rounds) {
    return rounds == endless ? "for ever" : fmt::format("about {:.0f} times", rounds);
}

}  // namespace

// break, return and discard, but for a break that leaves another loop or a switch within.
bool Walker::leaves(int node, bool breaks) const {
    const Node& n = at(node);
    if (n.form == Form::jump) return n.text == "discard" || (n.text == "break" && breaks);
    if (n.form < Form::declarator || n.form == Form::returned) return n.form == Form::returned;
    const bool within = n.form == Form::loop || n.form == Form::choice;
    return ranges::any_of(parts(node), [&](int part) { return leaves(part, breaks && !within); });
}

bool Walker::stored(int variable, int node) const {
    bool found = false;
    each_stored(at(node).begin, node, [&](int other) { found = found || other == variable; });
    return found;
}

// What i++, ++i, i -= 2 and their like add to the variable; 0: another thing.
double Walker::step_of(int variable, int node) const {
    const Node& n = at(node);
    const std::vector<int> inside = parts(node);
    if (inside.empty() || at(inside[0]).form != Form::name || at(inside[0]).variable != variable) return 0;
    const double sign = n.text.starts_with('-') ? -1 : 1;
    if (n.form == Form::step) return sign;
    if (n.form != Form::assign || (n.text != "+=" && n.text != "-=") || at(inside[1]).value.size() != 1) return 0;
    return sign * at(inside[1]).value.front();
}

// The same of a loop's body, as far as it is done in every round.
double Walker::body_step(int variable, int body) const {
    double step = 0;
    const std::vector<int> all = at(body).form == Form::block ? parts(body) : std::vector<int>{body};
    for (const int node : all) {
        const std::vector<int> inside = parts(node);
        const double here = at(node).form == Form::evaluated && !inside.empty() ? step_of(variable, inside[0]) : 0;
        if (here == 0 && stored(variable, node)) return 0;
        step += here;
    }
    for (int k = at(body).begin; k < body; ++k)
        if (at(k).form == Form::jump && at(k).text == "continue") return 0;
    return step;
}

// Whether the variable has the same value in every round. A function might change a global one.
bool Walker::stays(int variable, const Loop& loop) const {
    for (int k = at(loop.body).begin; k < loop.body; ++k)
        if (at(k).form == Form::call) return false;
    return (loop.step < 0 || !stored(variable, loop.step)) && !stored(variable, loop.body);
}

// 0: it is not known. A slider counts as far as it goes.
double Walker::rounds_of(const Loop& loop) {
    const Node& test = at(loop.condition);
    const bool yes = test.form == Form::number && test.type.base == glsl::Base::boolean && test.value.front() != 0;
    if (leaves(loop.body, true)) return 0;
    if (test.form == Form::empty || yes) return endless;
    const std::vector<int> sides = parts(loop.condition);
    if (test.form != Form::infix || at(sides[0]).form != Form::name || at(sides[0]).variable < 0) return 0;
    const int variable = at(sides[0]).variable;
    const std::string_view op = test.text;
    const bool stepped = loop.step >= 0 && at(loop.step).form != Form::empty;  // by its header
    const double step = stepped ? step_of(variable, loop.step) : body_step(variable, loop.body);
    const bool left_alone = step == 0 && stays(variable, loop);
    if ((step == 0 && !left_alone) || (stepped && stored(variable, loop.body))) return 0;
    Value bound = evaluate(sides[1]).v;
    if (bound.uniform >= 0)
        if (const auto set = around_.uniforms.find(u_.globals[static_cast<std::size_t>(bound.uniform)].name);
            set != around_.uniforms.end())
            bound.range = set->second.range;
    if (at(sides[0]).type.base == glsl::Base::uinteger && op == ">=" && bound.range == exactly(0)) return endless;
    const Range& from = slot(variable).value.range;
    const bool less = op == "<" || op == "<=", more = op == ">" || op == ">=";
    if (left_alone || (less && step < 0) || (more && step > 0)) {
        const bool begins = less ? from.real_hi && bound.range.real_lo && from.hi < bound.range.lo
                                 : more && from.real_lo && bound.range.real_hi && from.lo > bound.range.hi;
        return begins ? endless : 0;
    }
    const bool up = step > 0 && from.real_lo && bound.range.real_hi;
    const bool down = step < 0 && from.real_hi && bound.range.real_lo;
    const double way = up ? bound.range.hi - from.lo : down ? from.hi - bound.range.lo : 0;
    const double rounds = way / std::abs(step);
    if (!std::isfinite(rounds) || rounds <= 0) return 0;
    if ((up && op == "<") || (down && op == ">")) return std::ceil(rounds);
    return (up && op == "<=") || (down && op == ">=") ? std::floor(rounds) + 1 : 0;
}

bool never_ends(const Diagnostic& found) {
    return found.code == facts(Rule::many_rounds).code &&
           found.message.starts_with(std::string(go_round_text) + rounds_text(endless));
}

bool may_not_end(const Diagnostics& found) {
    return ranges::count(found.items(), facts(Rule::many_rounds).code, &Diagnostic::code) > 0;
}

void Walker::go_round(double rounds, int first, int last) {
    if (rounds <= 0 || state_.dead || (rounds == endless && (perhaps_ > 0 || state_.returned))) return;
    rounds_ += weight_ * (rounds + 1);
    if (rounds_ <= most_rounds || told_rounds_) return;
    told_rounds_ = true;
    last = std::min(last, static_cast<int>(u_.tokens.size()) - 1);  // the text may end within the header
    report(Rule::many_rounds, first, last,
           std::string(go_round_text) + rounds_text(rounds_) +
               ": without a GPU, Mesa's llvmpipe ends them after 65535, and the picture is what they had by then");
}

}  // namespace snell::lint
