#include "src/lint/walker.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/glsl/translate/program.h"

namespace snell::lint {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// inf - inf and 0 * inf are no bounds.
double bound(double v, double otherwise) { return std::isnan(v) ? otherwise : v; }

template <class T>
void keep_equal(T& a, const T& b) {
    if (!(a == b)) a = T{};
}

}  // namespace

Range sum(const Range& a, const Range& b) {
    return {bound(a.lo + b.lo, -infinity), bound(a.hi + b.hi, infinity), a.real_lo && b.real_lo,
            a.real_hi && b.real_hi};
}

Range negative(const Range& a) { return {-a.hi, -a.lo, a.real_hi, a.real_lo}; }

Range product(const Range& a, const Range& b, bool square) {
    if (square) {
        const double end = std::max(std::abs(a.lo), std::abs(a.hi));
        return {a.lo > 0 ? a.lo * a.lo : a.hi < 0 ? a.hi * a.hi : 0, end * end, false, false};
    }
    const double ends[] = {a.lo * b.lo, a.lo * b.hi, a.hi * b.lo, a.hi * b.hi};
    if (std::any_of(std::begin(ends), std::end(ends), [](double v) { return std::isnan(v); })) {
        if (a.lo >= 0 && b.lo >= 0) return {0, infinity, false, false};
        return {};
    }
    const bool real = a.real_lo && a.real_hi && b.real_lo && b.real_hi;
    return {*std::min_element(std::begin(ends), std::end(ends)), *std::max_element(std::begin(ends), std::end(ends)),
            real, real};
}

Range larger(const Range& a, const Range& b) {
    return {std::max(a.lo, b.lo), std::max(a.hi, b.hi), a.lo > b.lo ? a.real_lo : b.real_lo,
            a.hi > b.hi ? a.real_hi : b.real_hi};
}

Range smaller(const Range& a, const Range& b) { return negative(larger(negative(a), negative(b))); }

Range either(const Range& a, const Range& b) {
    return {std::min(a.lo, b.lo), std::max(a.hi, b.hi), a.real_lo && b.real_lo, a.real_hi && b.real_hi};
}

Varies together(Varies a, Varies b) {
    if (a == Varies::yes || b == Varies::yes) return Varies::yes;
    return a == Varies::no && b == Varies::no ? Varies::no : Varies::unknown;
}

Value either(const Value& a, const Value& b) {
    Value v = a;
    keep_equal(v.id, b.id);
    keep_equal(v.opposite, b.opposite);
    keep_equal(v.name, b.name);
    keep_equal(v.length, b.length);
    keep_equal(v.why, b.why);
    if (v.space == Space::any) v.space = b.space;
    if (b.space != Space::any) keep_equal(v.space, b.space);
    keep_equal(v.point, b.point);
    keep_equal(v.plain, b.plain);
    v.refracted = a.refracted || b.refracted;
    v.from_eye = a.from_eye && b.from_eye;
    keep_equal(v.mirrored, b.mirrored);
    keep_equal(v.mirrored_opposite, b.mirrored_opposite);
    keep_equal(v.from, b.from);
    keep_equal(v.to, b.to);
    v.range = either(a.range, b.range);
    // A condition chose the value, so it is unknown which bound is reached.
    if (a.range != b.range) v.range.real_lo = v.range.real_hi = false;
    keep_equal(v.difference, b.difference);
    if (a.uniform != b.uniform) v.uniform = -1;
    keep_equal(v.cosine, b.cosine);
    keep_equal(v.one_plus, b.one_plus);
    keep_equal(v.eta, b.eta);
    keep_equal(v.bend, b.bend);
    v.varies = a.varies == b.varies ? a.varies : Varies::unknown;
    return v;
}

bool spatial(const Value& v) {
    return v.length != Length::unknown || v.space == Space::object || v.space == Space::world || v.space == Space::eye;
}

// Statements, and the values that variables may have after them.

using glsl::Form;
using glsl::Node;
using glsl::Storage;

Walker::Walker(const glsl::Unit& unit, const Surroundings& around, const Varyings* given, Report report)
    : u_(unit), around_(around), given_(given), report_(std::move(report)) {
    for (const glsl::Type& type : u_.code.variables) state_.slots.emplace_back().value.type = type;
    for (const glsl::Global& g : u_.globals)
        if (g.variable >= 0) slot(g.variable) = {seed(g), g.qualifiers.storage == Storage::constant};
    each_stored(u_, 0, static_cast<int>(u_.tree->size()) - 1, [&](int variable) { stored_.insert(variable); });
    // Initialisers of constants are expressions of constants that stand before them.
    for (const Node& n : *u_.tree) {
        if (n.form != Form::declarator || !slot(n.variable).constant || n.type.dims > 0) continue;
        const int node = static_cast<int>(&n - u_.tree->data());
        for (const int part : parts(node)) slot(n.variable).value = evaluate(part).v;
        slot(n.variable).value.type = n.type;
    }
}

Varyings Walker::run() {
    const glsl::Function* main = glsl::find_main(u_);
    if (!main || main->block < 0) return {};
    for (const glsl::Function& f : u_.functions)
        for (int n = f.block < 0 || &f == main ? 0 : at(f.block).begin; n < f.block && &f != main; ++n)
            if (at(n).form == Form::assign && at(parts(n)[0]).global >= 0) unstable_.insert(at(parts(n)[0]).variable);
    call_user(*main, {});
    if (ended_) state_ = merge(std::move(*ended_), state_);
    Varyings out;
    for (const glsl::Global& g : u_.globals)
        if (g.qualifiers.storage == Storage::out && g.variable >= 0) out.emplace(g.name, slot(g.variable).value);
    finish();
    return out;
}

Walker::State Walker::merge(State a, const State& b) const {
    if (a.dead) return b;
    if (b.dead) return a;
    for (std::size_t i = 0; i < a.slots.size(); ++i)
        if (a.slots[i].value.id != b.slots[i].value.id || a.slots[i].value.id == 0)
            a.slots[i].value = either(a.slots[i].value, b.slots[i].value);
    return a;
}

// The names in a condition, and in what its bools were set to.
std::vector<const Node*> Walker::conditioned(int first, int last) const {
    std::vector<const Node*> names;
    for (int k = first; k <= last; ++k) {
        if (at(k).form != Form::name) continue;
        names.push_back(&at(k));
        if (const auto found = reasons_.find(at(k).variable); found != reasons_.end())
            names.insert(names.end(), found->second.begin(), found->second.end());
    }
    return names;
}

void Walker::note_reasons(int variable, int value) {
    constexpr std::size_t most = 64;
    if (variable < 0 || slot(variable).value.type.base != glsl::Base::boolean) return;
    std::vector<const Node*>& reasons = reasons_[variable];
    for (const Node* name : conditioned(at(value).begin, value))
        if (reasons.size() < most && ranges::count(reasons, name) == 0) reasons.push_back(name);
}

// A number that was compared with something is no longer known to be as small or as large as it may have been, but for
// uniforms and exact numbers that a loop counts to.
void Walker::condition_on(int first, int last, bool counts) {
    for (const Node* name : conditioned(first, last)) {
        conditions_.insert(name->text);
        if (name->variable < 0 || slot(name->variable).constant) continue;
        Value& value = slot(name->variable).value;
        if (counts && (value.uniform >= 0 || value.range == exactly(value.range.lo))) continue;
        value.range = {};
        value.difference = {};
    }
}

void Walker::conditions_end(int node) {
    for (const Node* name : conditioned(at(node).begin, node))
        if (const auto found = conditions_.find(name->text); found != conditions_.end()) conditions_.erase(found);
}

void Walker::branch(int node) {
    const std::vector<int> all = parts(node);
    if (all.size() < 2) return;  // not understood
    const int tested = all[0];
    const bool varies = evaluate(tested).v.varies == Varies::yes;
    condition_on(at(tested).begin, tested);
    nonuniform_ += varies ? 1 : 0;
    const State before = state_;
    apart([&] { statement(all[1]); });
    State taken = std::move(state_);
    state_ = before;
    if (all.size() > 2) apart([&] { statement(all[2]); });
    nonuniform_ -= varies ? 1 : 0;
    const bool ended = taken.dead || state_.dead;
    const bool returned = taken.returned || state_.returned;
    // If a path ended here, the rest runs under the condition, too.
    perhaps_ += ended ? 1 : 0;
    if (ended) rounds_ = 0, weight_ = 1, counters_.clear();
    if (!ended) conditions_end(tested);
    state_ = merge(std::move(taken), state_);
    for (const Node* name : conditioned(at(tested).begin, tested))  // behind it, it may be anything again
        if (name->global >= 0 && name->variable >= 0 && slot(name->variable).value.uniform >= 0 &&
            !conditions_.contains(name->text))
            slot(name->variable).value.range = seed(u_.globals[static_cast<std::size_t>(name->global)]).range;
    if (returned && !state_.dead && varies && calling_.size() == 1) ++nonuniform_;
}

void Walker::forget(int variable) {
    for (Counter& c : counters_) c.moved = c.moved || c.variable == variable;
    defined_.erase(variable);
    Slot& s = slot(variable);
    if (s.constant) return;
    const glsl::Type type = s.value.type;
    s.value = Value{};
    s.value.type = type;
}

void Walker::forget_stored(int first, int last) {
    each_stored(u_, first, last, [&](int variable) { forget(variable); });
}

void Walker::loop(int node) {
    const std::vector<int> all = parts(node);
    const bool counted = at(node).text == "for";
    if (all.size() != (counted ? 4 : 2)) return;  // not understood
    if (counted) statement(all[0]);
    const int condition = all[counted ? 1 : 0], step = counted ? all[2] : -1, body = all.back();
    Counter own = counter_of({condition, step, body}, counted ? all[0] : -1);
    const auto rounds = rounds_in(own, {condition, step, body});
    const double weight = weight_;
    const std::vector<Counter> around = counters_;
    const bool perhaps = !rounds && !enters(own);
    go_round(rounds, own, at(node).first, at(counted ? step : condition).last + 1);
    weight_ *= rounds.value_or(1);
    forget_stored(at(condition).begin, body);
    const State before = state_;
    const bool varies = evaluate(condition).v.varies == Varies::yes;
    condition_on(at(node).begin, at(body).begin - 1, own.counts || !perhaps);
    nonuniform_ += varies ? 1 : 0;
    perhaps_ += perhaps ? 1 : 0;
    if (rounds) counters_.push_back(std::move(own));
    statement(body);
    perhaps_ -= perhaps ? 1 : 0;
    nonuniform_ -= varies ? 1 : 0;
    counters_ = around;
    weight_ = weight;
    state_ = before;
    forget_stored(at(node).begin, body);
}

void Walker::do_loop(int node) {
    const std::vector<int> all = parts(node);
    if (all.size() < 2) return;  // not understood
    const int body = all[0], condition = all.back();
    const double weight = weight_;
    const std::vector<Counter> around = counters_;
    if (at(condition).form != Form::empty) {
        Counter own = counter_of({condition, -1, body}, -1);
        const auto rounds = rounds_in(own, {condition, -1, body});
        go_round(rounds, own, at(condition).first - 2, at(condition).last + 1);
        weight_ *= std::max(rounds.value_or(1), 1.0);
        if (rounds >= 1.) counters_.push_back(std::move(own));
    }
    forget_stored(at(body).begin, body);
    statement(body);
    counters_ = around;
    weight_ = weight;
    state_.dead = false;
}

void Walker::returns(int node) {
    for (const int part : parts(node)) {
        const Value v = evaluate(part).v;
        result_ = result_ ? either(*result_, v) : v;
    }
    if (calling_.size() == 1) ended_ = ended_ ? merge(std::move(*ended_), state_) : state_;
    state_.dead = state_.returned = true;
}

void Walker::local(int node) {
    const Node& n = at(node);
    Value value;
    for (const int part : parts(node)) {  // sizes of arrays come first
        value = evaluate(part).v;
        if (of_interest(at(part).first, at(part).last))
            made_.try_emplace(n.first, Unread{at(part).first, at(part).last});
    }
    if (n.type.dims > 0) value = Value{};
    value.type = n.type;
    slot(n.variable).value = value;
    if (n.type.scalar() && !parts(node).empty()) define(n.variable, parts(node).back());
    for (const int part : parts(node)) note_reasons(n.variable, part);
}

void Walker::statement(int node) {
    if (--budget_ < 0 || depth_ > 100) return;
    ++depth_;
    switch (at(node).form) {
        case Form::block:
        case Form::declaration:
        case Form::evaluated:
            for (const int part : parts(node)) statement(part);
            break;
        case Form::declarator:
            local(node);
            break;
        case Form::branch:
            branch(node);
            break;
        case Form::loop:
            if (at(node).text == "do")
                do_loop(node);
            else
                loop(node);
            break;
        case Form::choice:  // cases may follow one another in any way: nothing is known of what they assign
            forget_stored(at(node).begin, node);
            break;
        case Form::returned:
            returns(node);
            break;
        case Form::jump:
            state_.dead = true;
            break;
        case Form::label:
        case Form::empty:
            break;
        default:
            evaluate(node);
    }
    --depth_;
}

}  // namespace snell::lint
