// How often loops go round, as far as the text tells, and which uniforms that depends on: as long as these are small,
// no picture takes long. For browsers, which would stand still with loops that never end: where nothing shows that the
// loops of a stage are left after few rounds, they count their rounds together, as Mesa's llvmpipe counts those of all
// loops, and are left as soon as there are most_rounds.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

#include "parser/text/number.h"
#include "src/glsl/read/tree.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

constexpr double many = 1024;  // in all loops of a stage
constexpr double few = 512;    // a large picture takes seconds with more, where processors draw it
constexpr double unknown = std::numeric_limits<double>::infinity();

// Least and most of what an expression may be.
struct Range {
    double low = -unknown, high = unknown;

    double magnitude() const { return std::max(std::abs(low), std::abs(high)); }
};

class Rounds {
public:
    // `bounded`: loops count.
    Rounds(Unit& unit, bool bounded) : u_(unit), bounded_(bounded) {}

    std::optional<LongLoops> run() {
        if (mentions(u_, "snell_round")) return LongLoops{};  // translated before
        const double rounds = of_function("main");
        if (counts_ && bounded_)
            u_.header += fmt::format(
                "highp int snell_Rounds = 0;\nhighp int snell_round(highp int n) "
                "{{ return snell_Rounds += snell_Rounds < {} ? n : 0; }}\n",
                most_rounds);
        if (!counts_ && rounds < many) return std::nullopt;
        LongLoops found;
        for (largest_ = few; largest_ >= 1 && found.up_to < 0; largest_ = *largest_ / 2) {
            functions_.clear();
            if (of_function("main") < few) found.up_to = *largest_;
        }
        if (found.up_to > 0) found.bounds.assign(bounds_.begin(), bounds_.end());
        return found;
    }

private:
    const Node& at(int node) const { return (*u_.tree)[static_cast<std::size_t>(node)]; }
    std::vector<int> parts(int node) const { return glsl::parts(*u_.tree, node); }

    // Of its loops that do not count, in one call: of the overload that has most.
    double of_function(std::string_view name) {
        const auto [known, added] = functions_.try_emplace(name, 0);
        if (!added) return known->second;
        double most = 0;
        for (const Function& f : u_.functions)
            if (f.name == name && f.block >= 0) most = std::max(most, of_block(f.block));
        return functions_[name] = most;
    }

    double of_block(int block) {
        const int begin = at(block).begin;
        std::vector<double> rounds(static_cast<std::size_t>(block - begin + 1));
        for (int k = begin; k <= block; ++k) {
            double sum = at(k).form == Form::call ? of_function(at(k).text) : 0;
            for (const int part : parts(k)) sum += rounds[static_cast<std::size_t>(part - begin)];
            rounds[static_cast<std::size_t>(k - begin)] = at(k).form == Form::loop ? of_loop(k, sum) : sum;
        }
        return rounds.back();
    }

    double of_loop(int loop, double inside) {
        const double own = own_rounds(loop), all = own == 0 ? 0 : own * (1 + inside);
        if (all < most_rounds || largest_) return all;
        count(loop, static_cast<int>(std::min(1 + inside, static_cast<double>(most_rounds))));
        return 0;
    }

    // Of numbers of the text, of what a settled uniform or a word of old versions is written as, and of uniforms.
    Range range(int node) {
        const Node& n = at(node);
        if (!n.type.scalar() || n.first < 0) return {};
        const Range found = n.value.size() == 1 ? Range{n.value.front(), n.value.front()} : combined(n, parts(node));
        const bool wraps = n.type.base == Base::uinteger && found.low < 0;
        return wraps ? Range{} : found;
    }

    Range combined(const Node& n, const std::vector<int>& inside) {
        if (const Range number = written(n); std::isfinite(number.high)) return number;
        if (n.form == Form::name) return of_name(n);
        std::vector<Range> of;
        for (const int part : inside) of.push_back(range(part));
        if (of.size() == 1 && (n.form == Form::group || n.form == Form::construct)) return of[0];
        if (n.form == Form::prefix && n.text == "-") return {-of[0].high, -of[0].low};
        const bool built_in = n.form == Form::built_in;
        if (built_in && n.text == "clamp" && of.size() == 3) return {of[1].low, of[2].high};
        if (of.size() != 2 || (n.form != Form::infix && !built_in)) return {};
        const auto& [a, b] = std::tie(of[0], of[1]);
        if (n.text == "min") return {std::min(a.low, b.low), std::min(a.high, b.high)};
        if (n.text == "max") return {std::max(a.low, b.low), std::max(a.high, b.high)};
        if (n.text == "+") return {a.low + b.low, a.high + b.high};
        if (n.text == "-") return {a.low - b.high, a.high - b.low};
        const double most = n.text == "*" ? a.magnitude() * b.magnitude() : unknown;
        const double least = n.text == "*" ? a.low * b.low : 0;
        return {a.low >= 0 && b.low >= 0 ? least : -most, most};
    }

    Range of_name(const Node& n) {
        const bool uniform =
            n.global >= 0 && u_.globals[static_cast<std::size_t>(n.global)].qualifiers.storage == Storage::uniform;
        if (uniform && largest_) {
            bounds_.emplace(u_.globals[static_cast<std::size_t>(n.global)].name);
            return {n.type.base == Base::uinteger ? 0 : -*largest_, *largest_};
        }
        if (const int begin = uniform ? -1 : only_value(n.variable); begin >= 0) return range(begin);
        return {};
    }

    // The initialiser of a variable that nothing is stored in later; -1: it has none.
    int only_value(int variable) const {
        if (variable < 0 || stores(u_, variable, 0, static_cast<int>(u_.tree->size()) - 1)) return -1;
        for (int k = 0; k < static_cast<int>(u_.tree->size()); ++k)
            if (at(k).form == Form::declarator && at(k).variable == variable)
                return parts(k).empty() ? -1 : parts(k).back();
        return -1;
    }

    Range written(const Node& n) const {
        const std::string text = render(u_, n.first, n.last);
        const bool decided = text.starts_with(decided_text);
        const char* const end = text.data() + text.size();
        double value = 0;
        const auto [read, wrong] = read_real(text.data() + (decided ? decided_text.size() : 0), end, value);
        return wrong == std::errc() && (decided || read == end) ? Range{value, value} : Range{};
    }

    double own_rounds(int loop) {
        const std::vector<int> all = parts(loop);
        return at(loop).text == "for" && all.size() == 4 ? rounds_while(all[1], all) : unknown;
    }

    // As long as that holds, of a loop that counts from a number to a number by a number. `all`: parts of the loop.
    double rounds_while(int condition, const std::vector<int>& all) {
        const Node& test = at(condition);
        const std::vector<int> sides = parts(condition);
        if (test.form == Form::group) return rounds_while(sides[0], all);
        if (test.form != Form::infix) return unknown;
        if (test.text == "&&") return std::min(rounds_while(sides[0], all), rounds_while(sides[1], all));
        const auto compared = comparison_of(u_, condition, at(condition).begin, all[3]);
        if (!compared || stored(compared->variable, all[3])) return unknown;
        const auto begin = begin_of(u_, compared->variable, all[0]);
        const auto step = update_of(u_, compared->variable, all[2]);
        if (!begin || !step || (step->op != '+' && step->op != '-')) return unknown;
        const Range amount = step->amount < 0 ? Range{step->by, step->by} : range(step->amount);
        // The shortest step that it may make; with 0, or one that vanishes next to the bound, it never ends.
        const double shortest = amount.low > 0 ? amount.low : std::min(amount.high, 0.);
        const double by = step->op == '+' ? shortest : -shortest;
        const auto [from, to] = ends(*begin, compared->bound, all[3]);
        const bool up = by > 0 && compared->op.front() == '<', down = by < 0 && compared->op.front() == '>';
        const double least = up ? from.low : from.high, most = up ? to.high : to.low;
        const Type& type = u_.code.variables[static_cast<std::size_t>(compared->variable)];
        if (type.base == Base::uinteger && (from.low < 0 || to.low < 0)) return unknown;
        const bool whole = type.integral();  // a float may be so large that it stays
        const bool moves = whole || std::abs(by) > std::max(std::abs(least), std::abs(most)) * 0x1p-22;
        return (up || down) && moves && std::isfinite(most - least) ? std::max(0., (most - least) / by + 1) : unknown;
    }

    // What it counts from and to; of `i = first; i < first + 16`, from 0.
    std::pair<Range, Range> ends(int begin, int bound, int body) {
        const std::vector<int> sides = parts(bound);
        const Node& first = at(begin);
        const bool sum = at(bound).form == Form::infix && at(bound).text == "+" && first.type.integral() &&
                         first.form == Form::name && at(sides[0]).form == Form::name &&
                         first.variable == at(sides[0]).variable && !stored(first.variable, body);
        return sum ? std::pair(Range{0, 0}, range(sides[1])) : std::pair(range(begin), range(bound));
    }

    bool stored(int variable, int node) const { return stores(u_, variable, at(node).begin, node); }

    // `weight`: rounds of the loops within that do not count, and its own.
    void count(int loop, int weight) {
        const std::vector<int> all = parts(loop);
        if (all.size() != (at(loop).text == "for" ? 4 : 2)) return;  // not understood
        counts_ = true;
        if (!bounded_) return;
        const Node& test = at(all[at(loop).text == "while" ? 0 : 1]);
        const std::string few = fmt::format("snell_round({}) < {}", weight, most_rounds);
        if (test.form == Form::empty) {
            before(test.first, few);
        } else if (test.form == Form::declaration) {
            before(at(all[1]).first, "{ if (!(" + few + ")) break; ");
            u_.edit(at(all[1]).last).after += " }";
        } else {
            before(test.first, few + " && (");
            u_.edit(test.last).after += ")";
        }
    }

    // Ahead of what was written there for other reasons.
    void before(int token, const std::string& text) { u_.edit(token).before.insert(0, text); }

    Unit& u_;
    bool bounded_, counts_ = false;
    std::map<std::string_view, double> functions_;
    std::optional<double> largest_;  // magnitude of uniforms; none: they are not known, and loops are made to count
    std::set<std::string> bounds_;
};

}  // namespace

std::optional<LongLoops> long_loops(Unit& unit, bool bounded) {
    return unit.tree ? Rounds(unit, bounded).run() : std::nullopt;
}

}  // namespace snell::glsl
