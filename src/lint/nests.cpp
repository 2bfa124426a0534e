// Loops whose bounds depend on the counters of the loops around them: their rounds are summed as the counters go.
#include <algorithm>
#include <array>
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
    const auto compared = comparison(loop);
    if (!compared) return counter;
    const int variable = counter.variable = compared->variable;
    if (const Range& from = slot(variable).value.range; from == exactly(from.lo)) counter.from = from.lo;
    const auto defined = defined_.find(variable);
    counter.begin =
        glsl::begin_of(u_, variable, begins).value_or(defined == defined_.end() ? -1 : defined->second.node);
    counter.bound = compared->bound;
    counter.op = compared->op;
    counter.name = compared->name;
    counter.base = slot(variable).value.type.base;
    auto updates = moves(compared->bound, loop) ? std::nullopt : updates_of(variable, loop);
    counter.counts = updates.has_value();
    if (updates) counter.updates = std::move(*updates);
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
    if (own.counts) add_needed(own.bound, needed);
    if (own.counts && !own.from) add_needed(own.begin, needed);
    const auto depends = [&](const Counter& c) { return needed.contains(c.variable); };
    const bool left = leaves(loop.body, true) || calls_discard(loop.body);
    if (!ranges::any_of(counters_, depends)) {
        own.rounds = rounds_of(loop);
        if (own.rounds != endless && own.counts && !left && never_ends_somewhere(own, std::move(needed)))
            slides_ = true, own.rounds = endless;
        return own.rounds > 0 ? std::optional(own.rounds) : std::nullopt;
    }
    if (told_rounds_ || left) return std::nullopt;
    for (const Counter& c : counters_) {
        add_needed(c.bound, needed);
        if (!c.from) add_needed(c.begin, needed);
    }
    const auto low = summed(0, own, needed, {Place::low}), high = summed(0, own, needed, {Place::high});
    if (!low || !high) return std::nullopt;
    const auto slides = [](const Update& update) { return update.amount >= 0; };
    slides_ = slides_ || *low != *high || ranges::any_of(own.updates, slides);
    const double most = std::max(*low, *high);
    return most == endless ? most : weight_ > 0 ? most / weight_ : 0;
}

// With all sliders at a place of theirs, or with one at an end and the others where they are now.
bool Walker::never_ends_somewhere(const Counter& own, std::set<int> needed) {
    for (const Update& update : own.updates) add_needed(update.amount, needed);
    std::set<int> uniforms;
    for (const int variable : needed)
        if (const int uniform = slot(variable).value.uniform; uniform >= 0) uniforms.insert(uniform);
    if (uniforms.empty()) return false;
    std::vector<Sliders> places{{Place::low}, {Place::current}, {Place::high}};
    for (const int uniform : uniforms)
        for (const Place to : {Place::low, Place::high}) places.push_back({Place::current, uniform, to});
    const auto never_ends = [&](const Sliders& sliders) {
        Counter there = own;
        for (Update& update : there.updates) {
            if (update.amount < 0) continue;
            const auto by = number_at(update.amount, sliders, own.serial);
            if (!by) return false;
            update.by = *by;
        }
        return rounds_at(there, sliders) == endless;
    };
    return ranges::any_of(places, never_ends);
}

// Whether the loop has a round, if it is reached.
bool Walker::enters(const Counter& own) {
    const auto begins = [&](Place place) { return begins_at(own, {place}); };
    constexpr std::array places{Place::low, Place::current, Place::high};
    const bool some = ranges::any_of(places, begins);
    slides_ = slides_ || (some && !ranges::all_of(places, begins));
    return some;
}

std::optional<double> Walker::number_of_name(const Node& node, const Sliders& sliders, int serial) {
    if (node.variable < 0) return std::nullopt;
    for (const Counter& c : counters_)
        if (c.variable == node.variable) return c.moved || c.serial > serial ? std::nullopt : std::optional(c.value);
    const Value& known = slot(node.variable).value;
    const Range& range = known.range;
    if (range == exactly(range.lo)) return range.lo;
    if (known.uniform >= 0) {
        if (!range.real_lo || !range.real_hi) return std::nullopt;
        const Place place = known.uniform == sliders.moved ? sliders.to : sliders.all;
        if (place != Place::current) return place == Place::high ? range.hi : range.lo;
        const auto set = around_.uniforms.find(u_.globals[static_cast<std::size_t>(known.uniform)].name);
        return set == around_.uniforms.end() ? std::nullopt : set->second.current;
    }
    const auto found = defined_.find(node.variable);
    return found == defined_.end() ? std::nullopt : number_at(found->second.node, sliders, found->second.serial);
}

// What an expression is with the counters' values, and with the sliders at one of their ends.
std::optional<double> Walker::number_at(int node, const Sliders& sliders, int serial) {
    const Node& n = at(node);
    if (--sums_ < 0 || !n.type.scalar()) return std::nullopt;
    if (n.value.size() == 1) return n.value.front();
    const int last = node - 1;  // its last part
    if (n.form == Form::name) return number_of_name(n, sliders, serial);
    if (n.form == Form::group) return number_at(last, sliders, serial);
    const bool casts = n.form == Form::construct && last >= n.begin && at(last).begin == n.begin;
    if (casts || (n.form == Form::prefix && n.text == "-")) {
        const auto x = number_at(last, sliders, serial);
        if (!x) return std::nullopt;
        return casts ? updated(0, {'=', *x}, n.type.base) : updated(0, {'-', *x}, n.type.base);
    }
    const bool least = n.form == Form::built_in && n.text == "min", most = n.form == Form::built_in && n.text == "max";
    if (n.form != Form::infix && !least && !most) return std::nullopt;
    const auto a = number_at(at(last).begin - 1, sliders, serial), b = number_at(last, sliders, serial);
    if (!a || !b) return std::nullopt;
    if (least || most) return least ? std::min(*a, *b) : std::max(*a, *b);
    const bool real = n.type.base == Base::real || n.type.base == Base::dreal;
    if (n.text == "%") return *a >= 0 && *b > 0 && !real ? std::optional(std::fmod(*a, *b)) : std::nullopt;
    if (n.text.size() != 1 || std::string_view("+-*/").find(n.text) == std::string_view::npos) return std::nullopt;
    if (n.text == "/" && *b == 0) return std::nullopt;
    return updated(*a, {n.text.front(), *b}, n.type.base);
}

std::optional<double> Walker::first_of(const Counter& counter, const Sliders& sliders) {
    if (counter.from) return counter.from;
    return counter.begin >= 0 ? number_at(counter.begin, sliders, counter.serial) : std::nullopt;
}

bool Walker::begins_at(const Counter& counter, const Sliders& sliders) {
    if (counter.variable < 0) return false;
    const auto first = first_of(counter, sliders), last = number_at(counter.bound, sliders, counter.serial);
    return first && last && holds(*first, counter.op, *last);
}

std::optional<double> Walker::rounds_at(const Counter& counter, const Sliders& sliders) {
    if (!counter.counts) return std::nullopt;
    const auto first = first_of(counter, sliders), last = number_at(counter.bound, sliders, counter.serial);
    if (!first || !last) return std::nullopt;
    for (const Update& update : counter.updates)
        if (std::isnan(update.by)) return std::nullopt;
    if (!holds(*first, counter.op, *last)) return 0;
    const Update by = counter.updates.size() == 1 ? counter.updates.front() : Update{'=', 0};
    const double step = by.op == '+' ? by.by : by.op == '-' ? -by.by : 0;
    const bool up = step > 0 && counter.op.front() == '<', down = step < 0 && counter.op.front() == '>';
    if (counter.base == Base::integer && (up || down) && std::abs(*last) < 1e9 && std::abs(step) < 1e9) {
        const double steps = (*last - *first) / step;
        return counter.op.size() == 1 ? std::ceil(steps) : std::floor(steps) + 1;
    }
    if (counter.base != Base::uinteger &&
        ((step < 0 && counter.op.front() == '<') || (step > 0 && counter.op.front() == '>')))
        return endless;
    const double rounds = counted_rounds(*first, counter.op, *last, counter.updates, counter.base);
    if (rounds != endless) sums_ -= static_cast<int>(std::min(rounds, very_many));
    return rounds < very_many || rounds == endless ? std::optional(rounds) : std::nullopt;
}

// All rounds of a loop, for every value that the counters from that level on take.
std::optional<double> Walker::summed(std::size_t level, const Counter& own, const std::set<int>& needed,
                                     const Sliders& sliders) {
    if (level == counters_.size()) return rounds_at(own, sliders);
    Counter& counter = counters_[level];
    const auto known = rounds_at(counter, sliders);
    if (known == 0.) return 0;
    if (!needed.contains(counter.variable)) {
        const auto once = known || counter.rounds > 0 ? summed(level + 1, own, needed, sliders) : std::nullopt;
        return once ? std::optional(known.value_or(counter.rounds) * *once) : std::nullopt;
    }
    const auto first = first_of(counter, sliders);
    if (!known || known == endless || !first) return std::nullopt;
    double sum = 0, value = *first;
    for (double round = 0; round < *known; ++round) {
        counter.value = value;
        const auto within = summed(level + 1, own, needed, sliders);
        if (within == endless) return endless;
        if (!within || sums_ < 0) return std::nullopt;
        sum += *within;
        for (const Update& update : counter.updates) value = updated(value, update, counter.base);
    }
    return sum;
}

}  // namespace snell::lint
