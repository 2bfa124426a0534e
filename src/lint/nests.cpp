// Loops whose bounds depend on the counters of the loops around them: their rounds are summed as the counters go.
#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/lint/walker.h"

namespace snell::lint {

using glsl::Base;
using glsl::Form;
using glsl::Node;

// How a loop counts, if it does.
Walker::Counter Walker::counter_of(const Loop& loop, int begins) {
    Counter counter;
    counter.serial = fresh();
    const Node& test = at(loop.condition);
    const std::vector<int> sides = parts(loop.condition);
    if (test.form != Form::infix || !glsl::compares(test.text) || at(sides[0]).form != Form::name) return counter;
    const int variable = at(sides[0]).variable;
    auto updates = variable < 0 ? std::nullopt : updates_of(variable, loop);
    if (!updates || moves(sides[1], loop)) return counter;
    counter.variable = variable;
    if (const Range& from = slot(variable).value.range; from == exactly(from.lo)) counter.from = from.lo;
    const auto defined = defined_.find(variable);
    counter.begin =
        glsl::begin_of(u_, variable, begins).value_or(defined == defined_.end() ? -1 : defined->second.node);
    counter.bound = sides[1];
    counter.op = test.text;
    counter.base = at(sides[0]).type.base;
    counter.updates = std::move(*updates);
    return counter;
}

// Keeps what a variable begins with, if that is the same whenever it is computed in a round of the loops around.
void Walker::define(int variable, int node) {
    defined_.erase(variable);
    for (int k = at(node).begin; k <= node; ++k)
        if (const int other = at(k).variable;
            other >= 0 && stored_.contains(other) && ranges::count(counters_, other, &Counter::variable) == 0)
            return;
    defined_[variable] = {node, fresh()};
}

// The variables that an expression depends on, by what they begin with, too.
void Walker::add_needed(int node, std::set<int>& needed) const {
    for (int k = node < 0 ? 0 : at(node).begin; k <= node; ++k) {
        const int variable = at(k).form == Form::name ? at(k).variable : -1;
        if (variable < 0 || !needed.insert(variable).second) continue;
        if (const auto found = defined_.find(variable); found != defined_.end()) add_needed(found->second.node, needed);
    }
}

// On average, of each time that the loop is reached; null: it is not known.
std::optional<double> Walker::rounds_in(Counter& own, const Loop& loop) {
    std::set<int> needed;
    if (own.variable >= 0) add_needed(own.bound, needed);
    if (own.variable >= 0 && !own.from) add_needed(own.begin, needed);
    const auto depends = [&](const Counter& c) { return needed.contains(c.variable); };
    if (!ranges::any_of(counters_, depends)) {
        own.rounds = rounds_of(loop);
        return own.rounds > 0 ? std::optional(own.rounds) : std::nullopt;
    }
    if (told_rounds_ || leaves(loop.body, true) || calls_discard(loop.body)) return std::nullopt;
    for (const Counter& c : counters_) {
        add_needed(c.bound, needed);
        if (!c.from) add_needed(c.begin, needed);
    }
    const auto low = summed(0, own, needed, false), high = summed(0, own, needed, true);
    if (!low || !high) return std::nullopt;
    const auto slides = [](const Update& update) { return update.amount >= 0; };
    slides_ = slides_ || *low != *high || ranges::any_of(own.updates, slides);
    return weight_ > 0 ? std::max(*low, *high) / weight_ : 0;
}

std::optional<double> Walker::number_of_name(const Node& node, bool high, int serial) {
    if (node.variable < 0) return std::nullopt;
    for (const Counter& c : counters_)
        if (c.variable == node.variable) return c.moved || c.serial > serial ? std::nullopt : std::optional(c.value);
    const Value& known = slot(node.variable).value;
    const Range& range = known.range;
    if (known.uniform >= 0)
        return range.real_lo && range.real_hi ? std::optional(high ? range.hi : range.lo) : std::nullopt;
    if (range == exactly(range.lo)) return range.lo;
    const auto found = defined_.find(node.variable);
    return found == defined_.end() ? std::nullopt : number_at(found->second.node, high, found->second.serial);
}

// What an expression is with the counters' values, and with the sliders at one of their ends.
std::optional<double> Walker::number_at(int node, bool high, int serial) {
    const Node& n = at(node);
    if (--sums_ < 0 || !n.type.scalar()) return std::nullopt;
    if (n.value.size() == 1) return n.value.front();
    const int last = node - 1;  // its last part
    if (n.form == Form::name) return number_of_name(n, high, serial);
    if (n.form == Form::group) return number_at(last, high, serial);
    const bool casts = n.form == Form::construct && last >= n.begin && at(last).begin == n.begin;
    if (casts || (n.form == Form::prefix && n.text == "-")) {
        const auto x = number_at(last, high, serial);
        if (!x) return std::nullopt;
        return casts ? updated(0, {'=', *x}, n.type.base) : updated(0, {'-', *x}, n.type.base);
    }
    const bool least = n.form == Form::built_in && n.text == "min", most = n.form == Form::built_in && n.text == "max";
    if (n.form != Form::infix && !least && !most) return std::nullopt;
    const auto a = number_at(at(last).begin - 1, high, serial), b = number_at(last, high, serial);
    if (!a || !b) return std::nullopt;
    if (least || most) return least ? std::min(*a, *b) : std::max(*a, *b);
    const bool real = n.type.base == Base::real || n.type.base == Base::dreal;
    if (n.text == "%") return *a >= 0 && *b > 0 && !real ? std::optional(std::fmod(*a, *b)) : std::nullopt;
    if (n.text.size() != 1 || std::string_view("+-*/").find(n.text) == std::string_view::npos) return std::nullopt;
    if (n.text == "/" && *b == 0) return std::nullopt;
    return updated(*a, {n.text.front(), *b}, n.type.base);
}

std::optional<double> Walker::first_of(const Counter& counter, bool high) {
    if (counter.from) return counter.from;
    return counter.begin >= 0 ? number_at(counter.begin, high, counter.serial) : std::nullopt;
}

std::optional<double> Walker::rounds_at(const Counter& counter, bool high) {
    if (counter.variable < 0) return std::nullopt;
    const auto first = first_of(counter, high), last = number_at(counter.bound, high, counter.serial);
    if (!first || !last) return std::nullopt;
    if (!holds(*first, counter.op, *last)) return 0;
    const Update by = counter.updates.size() == 1 ? counter.updates.front() : Update{'=', 0};
    const double step = by.op == '+' ? by.by : by.op == '-' ? -by.by : 0;
    const bool up = step > 0 && counter.op.front() == '<', down = step < 0 && counter.op.front() == '>';
    if (counter.base == Base::integer && (up || down) && std::abs(*last) < 1e9 && std::abs(step) < 1e9) {
        const double steps = (*last - *first) / step;
        return counter.op.size() == 1 ? std::ceil(steps) : std::floor(steps) + 1;
    }
    const double rounds = counted_rounds(*first, counter.op, *last, counter.updates, counter.base);
    sums_ -= static_cast<int>(std::min(rounds, very_many));
    return rounds < very_many ? std::optional(rounds) : std::nullopt;
}

// All rounds of a loop, for every value that the counters from that level on take.
std::optional<double> Walker::summed(std::size_t level, const Counter& own, const std::set<int>& needed, bool high) {
    if (level == counters_.size()) return rounds_at(own, high);
    Counter& counter = counters_[level];
    const auto known = rounds_at(counter, high);
    if (!needed.contains(counter.variable)) {
        const auto once = known || counter.rounds > 0 ? summed(level + 1, own, needed, high) : std::nullopt;
        return once ? std::optional(known.value_or(counter.rounds) * *once) : std::nullopt;
    }
    const auto first = first_of(counter, high);
    if (!known || !first) return std::nullopt;
    double sum = 0, value = *first;
    for (double round = 0; round < *known; ++round) {
        counter.value = value;
        const auto within = summed(level + 1, own, needed, high);
        if (!within || sums_ < 0) return std::nullopt;
        sum += *within;
        for (const Update& update : counter.updates) value = updated(value, update, counter.base);
    }
    return sum;
}

}  // namespace snell::lint
