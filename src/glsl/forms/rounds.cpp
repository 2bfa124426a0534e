// How often loops go round, as far as the text tells. For browsers, which would stand still with loops that never end:
// where nothing shows that the loops of a stage are left after few rounds, they count their rounds together, as Mesa's
// llvmpipe counts those of all loops, and are left as soon as there are most_rounds.
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "parser/text/number.h"
#include "src/glsl/read/tree.h"
#include "src/glsl/translate/program.h"

namespace snell::glsl {

namespace {

constexpr double many = 4096;  // in all loops of a stage
constexpr double unknown = std::numeric_limits<double>::infinity();

class Rounds {
public:
    // `bounded`: loops count.
    Rounds(Unit& unit, bool bounded) : u_(unit), bounded_(bounded) {}

    bool run() {
        if (mentions(u_, "snell_round")) return true;  // translated before
        const double rounds = of_function("main");
        if (counts_ && bounded_)
            u_.header += fmt::format(
                "highp int snell_Rounds = 0;\nhighp int snell_round(highp int n) "
                "{{ return snell_Rounds += snell_Rounds < {} ? n : 0; }}\n",
                most_rounds);
        return counts_ || rounds >= many;
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
        const double all = own_rounds(loop) * (1 + inside);
        if (all < most_rounds) return all;
        count(loop, static_cast<int>(std::min(1 + inside, static_cast<double>(most_rounds))));
        return 0;
    }

    // A number of the text, or what a settled uniform or a word of old versions is written as; NaN: it is not known.
    double number(int node) const {
        const Node& n = at(node);
        if (!n.type.scalar() || n.first < 0) return std::nan("");
        if (n.value.size() == 1) return n.value.front();
        const std::string text = render(u_, n.first, n.last);
        const bool decided = text.starts_with(decided_text);
        const char* const end = text.data() + text.size();
        double value = 0;
        const auto [read, wrong] = read_real(text.data() + (decided ? decided_text.size() : 0), end, value);
        return wrong == std::errc() && (decided || read == end) ? value : std::nan("");
    }

    double own_rounds(int loop) const {
        const std::vector<int> all = parts(loop);
        return at(loop).text == "for" && all.size() == 4 ? rounds_while(all[1], all) : unknown;
    }

    // As long as that holds, of a loop that counts from a number to a number by a number. `all`: parts of the loop.
    double rounds_while(int condition, const std::vector<int>& all) const {
        const Node& test = at(condition);
        const std::vector<int> sides = parts(condition);
        if (test.form == Form::group) return rounds_while(sides[0], all);
        if (test.form != Form::infix) return unknown;
        if (test.text == "&&") return std::min(rounds_while(sides[0], all), rounds_while(sides[1], all));
        const int variable = at(sides[0]).form == Form::name ? at(sides[0]).variable : -1;
        if (variable < 0 || stored(variable, all[3])) return unknown;
        const auto begin = begin_of(u_, variable, all[0]);
        const auto step = update_of(u_, variable, all[2]);
        if (!begin || !step || (step->op != '+' && step->op != '-')) return unknown;
        const double by = step->op == '+' ? step->by : -step->by;
        const auto [from, to] = ends(*begin, sides[1], all[3]);
        const bool up = by > 0 && test.text.front() == '<', down = by < 0 && test.text.front() == '>';
        const bool whole = at(sides[0]).type.integral();  // a float may be so large that it stays
        const bool moves = whole || std::abs(by) > std::max(std::abs(from), std::abs(to)) * 0x1p-22;
        return (up || down) && moves && std::isfinite(to - from) ? std::max(0., (to - from) / by + 1) : unknown;
    }

    // What it counts from and to; of `i = first; i < first + 16`, from 0.
    std::pair<double, double> ends(int begin, int bound, int body) const {
        const std::vector<int> sides = parts(bound);
        const Node& first = at(begin);
        const bool sum = at(bound).form == Form::infix && at(bound).text == "+" && first.type.integral() &&
                         first.form == Form::name && at(sides[0]).form == Form::name &&
                         first.variable == at(sides[0]).variable && !stored(first.variable, body);
        return sum ? std::pair(0., number(sides[1])) : std::pair(number(begin), number(bound));
    }

    bool stored(int variable, int node) const {
        bool found = false;
        each_stored(u_, at(node).begin, node, [&](int other) { found = found || other == variable; });
        return found;
    }

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
};

}  // namespace

bool long_loops(Unit& unit, bool bounded) { return unit.tree && Rounds(unit, bounded).run(); }

}  // namespace snell::glsl
