// Estimates how often loops repeat, without running the shader.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "parser/text/ranges.h"
#include "src/lint/walker.h"

namespace snell::lint {

namespace {

using glsl::Form;
using glsl::Node;

constexpr std::string_view go_round_text = "the loops of this shader go round ";
constexpr std::string_view may_go_round_text = "the loops of this shader may go round ";  // at the end of a slider

// llvmpipe counts the rounds of all loops of a shader together, and one more each time that a loop is left; the last
// one may be such an end.
constexpr double most_rounds = 65536;

std::string rounds_text(double rounds) {
    if (rounds >= very_many && rounds != endless) return "more than a million times";
    return rounds == endless ? "for ever" : fmt::format("at least {:.0f} times", rounds);
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

// Fragments end in functions, too.
bool Walker::may_discard(std::string_view function, std::set<std::string_view>& seen) const {
    if (!seen.insert(function).second) return false;
    for (const glsl::Function& f : u_.functions)
        for (int k = f.name == function ? f.open : -1; k >= 0 && k < f.close; ++k) {
            const glsl::Token& t = u_.tokens[static_cast<std::size_t>(k)];
            if (t.text == "discard") return true;
            if (ranges::count(u_.functions, t.text, &glsl::Function::name) > 0 && may_discard(t.text, seen))
                return true;
        }
    return false;
}

bool Walker::calls_discard(int node) const {
    std::set<std::string_view> seen;
    for (int k = at(node).begin; k <= node; ++k)
        if (at(k).form == Form::call && may_discard(at(k).text, seen)) return true;
    return false;
}

// What may not run is judged by itself: its rounds are neither added to others nor multiplied by those of loops around.
void Walker::apart(const std::function<void()>& walk) {
    const double rounds = std::exchange(rounds_, 0), weight = std::exchange(weight_, 1);
    std::vector<Counter> counters = std::exchange(counters_, {});
    ++perhaps_;
    walk();
    --perhaps_;
    rounds_ = rounds;
    weight_ = weight;
    counters_ = std::move(counters);
}

bool Walker::stored(int variable, int node) const { return stores(u_, variable, at(node).begin, node); }

// In what each round runs.
bool Walker::stored(int variable, const Loop& loop) const {
    return stores(u_, variable, std::min(at(loop.condition).begin, at(loop.body).begin),
                  std::max(loop.condition, loop.body));
}

std::optional<glsl::Comparison> Walker::comparison(const Loop& loop) const {
    return comparison_of(u_, loop.condition, std::min(at(loop.condition).begin, at(loop.body).begin),
                         std::max(loop.condition, loop.body));
}

// What each round does with the variable, in order, a slider's step where it is shortest; nullopt: it is not known.
std::optional<std::vector<glsl::Update>> Walker::updates_of(int variable, const Loop& loop) {
    if (unstable_.contains(variable)) return std::nullopt;
    std::vector<Update> updates;
    const auto add = [&](int node, int expression) {
        auto update = expression < 0 ? std::nullopt : update_of(u_, variable, expression);
        if (update && update->amount >= 0 && !take_shortest(*update, variable, loop)) update.reset();
        if (!update && stored(variable, node)) return false;
        if (update) updates.push_back(*update);
        return true;
    };
    const std::vector<int> all = at(loop.body).form == Form::block ? parts(loop.body) : std::vector<int>{loop.body};
    for (const int node : all) {
        const std::vector<int> inside = parts(node);
        if (!add(node, at(node).form == Form::evaluated && !inside.empty() ? inside[0] : -1)) return std::nullopt;
    }
    for (int k = at(loop.body).begin; k < loop.body && !updates.empty(); ++k)
        if (at(k).form == Form::jump && at(k).text == "continue") return std::nullopt;
    if (loop.step >= 0 && !add(loop.step, loop.step)) return std::nullopt;
    return updates;
}

// The amount stays one where a slider may set others. False: it is not known.
bool Walker::take_shortest(Update& update, int variable, const Loop& loop) {
    for (int k = at(update.amount).begin; k <= update.amount; ++k)
        if (at(k).variable == variable) return false;
    if (moves(update.amount, loop)) return false;
    const Range step = evaluate(update.amount).v.range;
    if (!step.real_lo || !step.real_hi) return false;
    if (update.op != '+' && update.op != '-' && step != exactly(step.lo)) return true;  // no value of it is shortest
    update.by = step.lo <= 0 && step.hi >= 0 ? 0 : step.lo > 0 ? step.lo : step.hi;
    if (step == exactly(step.lo)) update.amount = -1;
    return true;
}

bool holds(double left, std::string_view op, double right) {
    if (op == "<") return left < right;
    if (op == "<=") return left <= right;
    if (op == ">") return left > right;
    if (op == ">=") return left >= right;
    return (op == "==" && left == right) || (op == "!=" && left != right);
}

// Goes round with the numbers, very_many times at most; it never ends if the variable has a value again that it had
// (Brent's search for cycles).
double Walker::counted_rounds(double value, std::string_view op, double bound, const std::vector<Update>& updates,
                              glsl::Base base) {
    double seen = value, rounds = 0;
    for (double next = 1; holds(value, op, bound) && rounds < very_many; ++rounds) {
        if (rounds == next) seen = value, next *= 2;
        for (const Update& update : updates) value = updated(value, update, base);
        if (value == seen) return endless;
    }
    return rounds;
}

// A bool that is true and that no round changes.
bool Walker::stays_true(const Loop& loop) {
    const Node& test = at(loop.condition);
    if (test.form != Form::name || test.variable < 0 || test.type.base != glsl::Base::boolean) return false;
    const auto updates = updates_of(test.variable, loop);
    return updates && updates->empty() && slot(test.variable).value.range == exactly(1);
}

// Whether a bound may be another one in the next round.
bool Walker::moves(int bound, const Loop& loop) const {
    for (int k = at(bound).begin; k <= bound; ++k)
        if (const Node& n = at(k); n.form == Form::call || (n.variable >= 0 && stored(n.variable, loop))) return true;
    return false;
}

// 0: it is not known. A slider counts as far as it goes.
double Walker::rounds_of(const Loop& loop) {
    const Node& test = at(loop.condition);
    const bool yes = test.type.base == glsl::Base::boolean && test.value.size() == 1 && test.value.front() != 0;
    if (leaves(loop.body, true) || calls_discard(loop.body)) return 0;
    if (test.form == Form::empty || yes || stays_true(loop)) return endless;
    const std::vector<int> sides = parts(loop.condition);
    if (test.form == Form::infix && at(sides[0]).value.size() == 1 && at(sides[1]).value.size() == 1)
        return holds(at(sides[0]).value.front(), test.text, at(sides[1]).value.front()) ? endless : 0;
    const auto compared = comparison(loop);
    if (!compared || moves(compared->bound, loop)) return 0;
    const auto [variable, name, op, limit] = *compared;
    const auto updates = updates_of(variable, loop);
    if (!updates || ranges::any_of(*updates, [](const Update& update) { return std::isnan(update.by); })) return 0;
    const Value bound = evaluate(limit).v;
    const glsl::Base base = slot(variable).value.type.base;
    if (base == glsl::Base::uinteger && op == ">=" && bound.range == exactly(0)) return endless;
    const Range& from = slot(variable).value.range;
    const bool exact = from == exactly(from.lo) && bound.range == exactly(bound.range.lo);
    const bool slides = ranges::any_of(*updates, [](const Update& update) { return update.amount >= 0; });
    slides_ = slides_ || slides;
    const double counted = exact ? counted_rounds(from.lo, op, bound.range.lo, *updates, base) : very_many;
    if (counted != very_many) return counted;
    double step = 0;
    for (const Update& update : *updates) {
        if (update.op != '+' && update.op != '-') return exact ? counted : 0;
        step += update.op == '+' ? update.by : -update.by;
    }
    const bool less = op == "<" || op == "<=", more = op == ">" || op == ">=";
    if (!less && !more) return exact ? counted : 0;
    if (step == 0 || (less && step < 0) || (more && step > 0)) {
        const bool begins = less ? from.real_hi && bound.range.real_lo && from.hi < bound.range.lo
                                 : more && from.real_lo && bound.range.real_hi && from.lo > bound.range.hi;
        return begins ? endless : 0;
    }
    const bool up = step > 0 && from.real_lo && bound.range.real_hi;
    const bool down = step < 0 && from.real_hi && bound.range.real_lo;
    if (!up && !down) return 0;
    slides_ = slides_ || !exact;
    const double first = up ? from.lo : from.hi, last = up ? bound.range.hi : bound.range.lo;
    const double rounds = counted_rounds(first, op, last, *updates, base);
    return rounds < very_many ? rounds : std::ceil(std::abs((last - first) / step));
}

bool never_ends(const Diagnostic& found) {
    return found.code == facts(Rule::many_rounds).code &&
           found.message.starts_with(std::string(go_round_text) + rounds_text(endless));
}

bool may_not_end(const Diagnostics& found) {
    return ranges::count(found.items(), facts(Rule::many_rounds).code, &Diagnostic::code) > 0;
}

void Walker::go_round(std::optional<double> rounds, const Counter& own, int first, int last) {
    if (!rounds || state_.dead || (rounds == endless && (perhaps_ > 0 || state_.returned))) return;
    rounds_ += weight_ * (*rounds + 1);
    if (rounds_ <= most_rounds || told_rounds_) return;
    told_rounds_ = true;
    last = std::min(last, static_cast<int>(u_.tokens.size()) - 1);  // the text may end within the header
    std::vector<Note> notes;
    if (rounds == endless && own.counts && own.updates.empty())
        notes.push_back({span(first, last), fmt::format("no round changes '{}'", own.name)});
    report(Rule::many_rounds, first, last,
           std::string(slides_ || perhaps_ > 0 ? may_go_round_text : go_round_text) + rounds_text(rounds_) +
               ": without a GPU, Mesa's llvmpipe ends them after 65535 (pages: 262143), and the picture is what they "
               "had by then",
           std::move(notes));
}

}  // namespace snell::lint
