// Loops that go round less often, or more often.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "src/accuracy/found/shaders/shader.h"
#include "src/glsl/read/lexer.h"
#include "src/glsl/read/words.h"

namespace snell::accuracy {

namespace {

using glsl::Form;
using glsl::Node;

constexpr double most_rounds = 4096;  // that a loop is given: drivers end long ones

// What is changed: the bound of a loop, or the argument that a function takes for one.
struct RoundBound {
    int node = -1;    // nodes
    double base = 0;  // where counting begins, if it is known
    int where = -1;   // what is shown: the comparison or the call
    double step = 1;
    bool includes = false;  // the loop's variable reaches the bound
};

class Rounds {
public:
    Rounds(const Shader& shader, Offers& offers) : s_(shader), offers_(offers) {
        for (std::size_t k = 1; k < s_.unit.tokens.size(); ++k) {
            if (s_.unit.tokens[k - 1].text == "[") sizes_.insert(written(s_.unit.tokens[k]));
        }
    }

    void run() {
        std::vector<int> loops, calls;
        for (int n = 0; n < s_.nodes(); ++n) {
            if (s_.at(n).form == Form::loop) loops.push_back(n);
            if (s_.at(n).form == Form::call) calls.push_back(n);
        }
        for (const int n : loops)
            for (const Counter& c : counters(s_, n))
                if (c.target >= 0 && fills(n, c)) keep(s_.at(s_.bare(c.target)));
        for (const int n : loops)
            for (const Counter& c : counters(s_, n))
                if (!fills(n, c)) loop(c);
        for (const int n : loops) more(n);
        std::size_t known = 0;
        do {  // a function may hand its parameter on
            known = parameters_.size();
            for (const int n : calls)
                if (const int given = argument(n); given >= 0) remember(given);
        } while (parameters_.size() > known);
        for (const int n : calls) call(n);
    }

private:
    // Whether each round writes another element: with fewer rounds, some would have no value.
    bool fills(int loop, const Counter& c) const {
        std::set<int> counting{c.variable};  // variables that differ from round to round, by what they begin with
        const auto counts = [&](int node) {
            for (int k = s_.at(node).begin; k <= node; ++k)
                if (s_.at(k).form == Form::step || counting.contains(s_.at(k).variable)) return true;
            return false;
        };
        for (int n = s_.at(loop).begin; n < loop; ++n) {
            const Node& node = s_.at(n);
            const std::vector<int> inside = s_.parts(n);
            if (node.form == Form::declarator && node.variable >= 0 && inside.size() == 1 && counts(inside[0]))
                counting.insert(node.variable);
            if (node.form != Form::index || inside.size() != 2 || !counts(inside[1])) continue;
            const Node& root = s_.at(node.begin);
            if (root.form != Form::name || s_.written(node.begin)) return true;
        }
        return false;
    }

    // With fewer rounds, a primitive would lack vertices.
    bool emits(int loop) const {
        loop = s_.loop_around(loop);
        if (loop < 0) return false;
        for (int k = s_.at(loop).first; k <= s_.at(loop).last; ++k)
            if (s_.token(k).text == "EmitVertex") return true;
        return false;
    }

    // The value of the name or the macro stays: as many elements are written.
    void keep(const Node& n) {
        if (n.form == Form::name) sizes_.insert(n.text);
        if (n.first >= 0 && s_.token(n.first).macro >= 0) sizes_.insert(written(s_.token(n.first)));
    }

    // The invocation of the macro that gave the token, or the token.
    std::string_view written(const glsl::Token& t) const {
        return t.macro >= 0 ? s_.unit.invocations[at(t.macro)] : t.text;
    }

    void loop(const Counter& c) {
        if (c.target < 0 || emits(s_.parent(c.comparison))) return;
        int target = s_.bare(c.target);
        RoundBound bound{target, 0, c.comparison, c.step, c.includes};
        if (c.base >= 0 && s_.at(c.base).value.size() == 1) {
            bound.base = s_.at(c.base).value.front();
        } else {
            // for( i = first; i < first + N; … )
            const Node& sum = s_.at(target);
            const std::vector<int> sides = s_.parts(target);
            if (c.base < 0 || sum.form != Form::infix || sum.text != "+" || !s_.alike(sides[0], c.base)) return;
            bound.node = s_.bare(sides[1]);
        }
        const Node &test = s_.at(c.comparison), &start = s_.at(target);
        const bool within = test.first <= start.first && start.last <= test.last;
        if (!within) bound.where = s_.parent(c.target);
        if (bound.where < 0) return;
        remember(bound.node);
        for (const double factor : {.5, .25}) change(bound, factor);
    }

    // Counts from a number up to one, or by a real one.
    void more(int loop) {
        const std::vector<Counter> all = counters(s_, loop);
        if (all.empty() || emits(loop) || indexes(loop)) return;
        const Counter& c = all.front();
        if (c.base < 0 || c.target < 0 || c.comparison < 0 || c.advance < 0) return;
        const Node &test = s_.at(c.comparison), &bound = s_.at(c.target);
        if (s_.at(c.base).value.size() != 1 || bound.first < test.first || bound.last > test.last) return;
        const Node& advance = s_.at(c.advance);
        if (c.step == 1) {
            const RoundBound rounds{s_.bare(c.target), s_.at(c.base).value.front(), c.comparison, 1, c.includes};
            for (const double factor : {2., 4.}) change(rounds, factor);
        } else if (advance.text == "+=") {
            const int step = s_.parts(c.advance)[1];
            const Node& n = s_.at(step);
            if (n.form != Form::number || n.type.base != glsl::Base::real || !s_.own(step)) return;
            for (const double factor : {2., 4.}) offer(c.comparison, {}, step, s_.span(step), c.step / factor, true);
        }
    }

    // Whether an element of an array is read that more rounds may not have: another one in each.
    bool indexes(int loop) const {
        const int begin = s_.at(loop).begin;
        const auto changes = [&](int variable) {
            if (variable < 0) return false;
            const int declared = s_.declarator(variable);
            return (declared >= begin && declared < loop) || ranges::any_of(s_.uses(variable), [&](int use) {
                       return use >= begin && use < loop && s_.written(use);
                   });
        };
        for (int n = begin; n < loop; ++n) {
            if (s_.at(n).form != Form::index) continue;
            const int index = s_.parts(n)[1];
            for (int k = s_.at(index).begin; k <= index; ++k)
                if (s_.at(k).form == Form::name && changes(s_.at(k).variable)) return true;
        }
        return false;
    }

    // The loop's bound is a parameter of the function: calls decide on it.
    void remember(int node) {
        const Node& n = s_.at(node);
        const int function = s_.function_of(n.first);
        if (n.form != Form::name || n.variable < 0 || function < 0) return;
        const std::vector<glsl::Parameter>& parameters = s_.function(function).parameters;
        for (std::size_t p = 0; p < parameters.size(); ++p)
            if (parameters[p].variable == n.variable) parameters_.emplace(function, p);
    }

    // The argument of a call that bounds a loop; -1: there is none.
    int argument(int node) const {
        const Node& n = s_.at(node);
        const std::vector<int> given = s_.parts(node);
        if (n.function < 0) return -1;
        const glsl::Function& called = s_.function(n.function);
        for (const auto& [function, parameter] : parameters_) {
            const glsl::Function& f = s_.function(function);
            const bool same = f.name == called.name && f.parameters.size() == called.parameters.size() &&
                              std::equal(f.parameters.begin(), f.parameters.end(), called.parameters.begin(),
                                         [](const auto& a, const auto& b) { return a.type.same(b.type); });
            if (same && parameter < given.size()) return s_.bare(given[parameter]);
        }
        return -1;
    }

    void call(int node) {
        const int given = argument(node);
        if (given < 0 || s_.library[s_.token(s_.at(node).first).file]) return;
        for (const double factor : {.5, .25}) change({given, 0, node, 1, false}, factor);
    }

    void change(const RoundBound& bound, double factor) {
        const Node& n = s_.at(bound.node);
        if (!n.type.scalar() || !n.type.numeric() || n.type.base == glsl::Base::dreal) return;
        if (of_ladder(n)) return;
        const bool macro = n.first >= 0 && s_.token(n.first).macro >= 0;
        if (macro ? definition_of_macro(bound, factor) : definition_of_name(bound, factor)) return;
        if (!macro && n.form == Form::number) return number(bound, factor);
        if (factor > 1) return;  // how many there are is not known
        const int share = static_cast<int>(1 / factor);
        if (macro)
            use_of_macro(bound, share);
        else if (s_.own(bound.node))
            expression(bound, share);
    }

    // The number that bounds `factor` times as many rounds; nothing if that is none, as many as before, or too many.
    static std::optional<double> other(const RoundBound& bound, double value, double factor) {
        const double last = bound.includes ? bound.step : 0, all = (value - bound.base + last) / bound.step;
        const double rounds = std::floor(all * factor);
        if (!(rounds >= 1) || !(all < 1e7) || rounds == all || (factor > 1 && rounds > most_rounds))
            return std::nullopt;
        return bound.base + rounds * bound.step - last;
    }

    void number(const RoundBound& bound, double factor) {
        const Node& n = s_.at(bound.node);
        const std::optional<double> value = other(bound, n.value.front(), factor);
        if (!value || !s_.own(bound.node) || !s_.own(bound.where)) return;
        offer(bound.where, {}, bound.node, s_.span(bound.node), *value, factor > 1);
    }

    // Offers the value `after` for a number that bounds rounds or is the size of a step, and that stands at `place`.
    // Numbers that follow change with it. `shown`: where the number is defined, if it is not within the loop.
    void offer(int where, std::optional<Span> shown, int number, Span place, double after, bool more) {
        const Node& n = s_.at(number);
        const int loop = s_.loop_around(where);
        std::vector<Edit> edits{{place, literal(after, n.type)}};
        std::vector<Span> places{shown ? *shown : more && loop >= 0 ? head(loop) : s_.span(where)};
        const std::vector<int> follow = loop < 0 ? std::vector<int>() : followers(loop, number, n.value.front());
        for (const int other : follow) {
            edits.push_back({s_.span(other), literal(after, s_.at(other).type)});
            if (more && !shown) places.push_back(edits.back().span);
        }
        offers_.add(more ? ChangeKind::more_rounds : ChangeKind::fewer_rounds, places, std::move(edits));
    }

    // The loop's head, for( … ).
    Span head(int loop) const {
        const int first = s_.at(loop).first;
        int last = first + 1;
        for (int depth = 0; last < s_.at(loop).last; ++last) {
            if (s_.token(last).text == "(") ++depth;
            if (s_.token(last).text == ")" && --depth == 0) break;
        }
        return s_.own(first, last) ? s_.span(first, last) : s_.span(first, first);
    }

    // ---- numbers that follow

    // Numbers of that value which are there because of the number of rounds, or of the size of the loop's step.
    std::vector<int> followers(int loop, int number, double value) {
        loop_ = loop;
        sums_.clear();
        counting_.clear();
        for (const Counter& c : counters(s_, loop)) counting_.insert(c.variable);
        for (int n = s_.at(loop).begin; n < loop; ++n) {
            const Node& node = s_.at(n);
            const std::vector<int> inside = s_.parts(n);
            if (node.form == Form::declarator && inside.size() == 1 && counts(inside[0]))
                counting_.insert(node.variable);
            if (node.form != Form::assign || node.text != "+=") continue;
            const int sum = s_.at(s_.at(inside[0]).begin).variable;
            const int declared = sum < 0 ? -1 : s_.declarator(sum);
            if (sum >= 0 && !counting_.contains(sum) && (declared < s_.at(loop).begin || declared > loop))
                sums_.insert(sum);
        }
        const bool step = s_.at(s_.parent(number)).form == Form::assign && within(number);
        std::vector<int> found;
        for (int k = 0; k < s_.nodes() && !offers_.full(); ++k) {
            const Node& n = s_.at(k);
            if (n.form == Form::number && n.type.numeric() && n.value.size() == 1 && n.value.front() == value &&
                k != number && s_.own(k) && (step ? scales(k) : divides(k)))
                found.push_back(k);
        }
        return found;
    }

    bool within(int node) const { return s_.at(loop_).begin <= node && node < loop_; }
    bool product(int node) const {
        return node >= 0 && s_.at(node).form == Form::infix && (s_.at(node).text == "*" || s_.at(node).text == "/");
    }
    bool assigns(int node, std::string_view a, std::string_view b) const {
        return node >= 0 && s_.at(node).form == Form::assign && (s_.at(node).text == a || s_.at(node).text == b);
    }
    // What the value is in, brackets and constructors aside; -1: nothing.
    int outside(int node) const {
        do node = s_.parent(node);
        while (node >= 0 && (s_.at(node).form == Form::group || s_.at(node).form == Form::construct));
        return node;
    }
    // The value within brackets, and within constructors of nothing else.
    int plain(int node) const {
        while (true) {
            node = s_.bare(node);
            const std::vector<int> inside = s_.parts(node);
            if (s_.at(node).form != Form::construct || inside.size() != 1) return node;
            node = inside.front();
        }
    }

    // Whether the value is a number of the counter: without calls, which may do anything.
    bool counts(int node) const {
        bool counter = false;
        for (int k = s_.at(node).begin; k <= node; ++k) {
            const Form form = s_.at(k).form;
            if (form == Form::call || form == Form::built_in || form == Form::index) return false;
            counter = counter || (form == Form::name && counting_.contains(s_.at(k).variable));
        }
        return counter;
    }

    // The sum that the value is, or a multiple of it; -1: none.
    int sum_of(int node) const {
        node = plain(node);
        const Node& n = s_.at(node);
        const std::vector<int> inside = s_.parts(node);
        if (n.form == Form::name) return sums_.contains(n.variable) ? n.variable : -1;
        if (n.form == Form::select || n.form == Form::index) return sum_of(inside[0]);
        if (!product(node)) return -1;
        const int left = sum_of(inside[0]);
        return left >= 0 || n.text == "/" ? left : sum_of(inside[1]);
    }

    // The products that the node is in, innermost first, and what these are in.
    struct Products {
        std::vector<int> nodes;
        int stored = -1;
    };
    Products products(int node) const {
        Products found;
        for (found.stored = outside(node); product(found.stored); found.stored = outside(found.stored))
            found.nodes.push_back(found.stored);
        return found;
    }

    // Whether a factor of these products multiplies a sum of the loop, behind it, where nothing else was stored in the
    // sum since.
    bool of_sum(const Products& all) const {
        int sum = -1;
        for (const int node : all.nodes)
            if (sum < 0) sum = sum_of(s_.parts(node)[0]);
        for (const int node : all.nodes)
            if (sum < 0 && s_.at(node).text == "*") sum = sum_of(s_.parts(node)[1]);
        if (sum < 0 && assigns(all.stored, "*=", "/=")) sum = sum_of(s_.parts(all.stored)[0]);
        const bool is_stored = all.stored >= 0 && s_.at(all.stored).form == Form::assign;
        if (sum < 0 || (!is_stored && all.nodes.empty())) return false;
        const int first = s_.at(is_stored ? all.stored : all.nodes.back()).first, end = s_.at(loop_).last;
        return first > end && std::none_of(s_.uses(sum).begin(), s_.uses(sum).end(), [&](int use) {
                   return s_.written(use) && s_.at(use).first > end && s_.at(use).first < first;
               });
    }

    // The number of rounds: it divides the counter, what the loop adds up, or the sum behind it.
    bool divides(int number) const {
        const Products all = products(number);
        const int division = all.nodes.empty() ? all.stored : all.nodes.front();
        const bool divisor = product(division) && s_.at(division).text == "/";
        if (!divisor && !assigns(division, "/=", "/=")) return false;
        if (plain(s_.parts(division)[1]) != number) return false;
        if (!within(number)) return of_sum(all);
        if (!divisor) return false;
        for (const int node : all.nodes)
            if (counts(s_.parts(node)[0]) || (s_.at(node).text == "*" && counts(s_.parts(node)[1]))) return true;
        return assigns(all.stored, "+=", "+=") && sum_of(s_.parts(all.stored)[0]) >= 0;
    }

    // The size of a step: a factor of what each round adds, of an exponent of what it multiplies, or of the sum.
    bool scales(int number) const {
        const Products all = products(number);
        for (const int node : all.nodes)
            if (s_.at(node).text == "/" && plain(s_.parts(node)[1]) == number) return false;
        if (!within(number)) return of_sum(all);
        int around = all.stored;
        if (around >= 0 && s_.at(around).form == Form::prefix && s_.at(around).text == "-") around = outside(around);
        const bool exponent = around >= 0 && s_.at(around).form == Form::built_in &&
                              (s_.at(around).text == "exp" || s_.at(around).text == "exp2");
        return exponent || assigns(around, "+=", "-=");
    }

    // ---- where a number is defined

    // A constant, or a local that nothing assigns later: where it is declared, so that the size of a step follows the
    // number of steps.
    bool definition_of_name(const RoundBound& bound, double factor) {
        const Node& n = s_.at(bound.node);
        if (n.form != Form::name || n.variable < 0 || sizes_.contains(n.text)) return false;
        const int declared = s_.declarator(n.variable);
        if (declared < 0) return false;
        const std::vector<int> inside = s_.parts(declared);
        if (inside.size() != 1 || !s_.own(declared)) return false;
        if (!s_.at(declared).constant) return local(bound, declared, inside[0], factor);
        const Node& number = s_.at(inside[0]);
        if (number.form != Form::number) return false;
        if (const auto value = other(bound, number.value.front(), factor))
            offer(bound.where, s_.span(declared), inside[0], s_.span(inside[0]), *value, factor > 1);
        return true;
    }

    bool local(const RoundBound& bound, int declared, int begins, double factor) {
        const Node& n = s_.at(begins);
        const std::vector<int>& uses = s_.uses(s_.at(bound.node).variable);
        const bool assigned = std::any_of(uses.begin(), uses.end(), [&](int use) { return s_.written(use); });
        if (assigned || s_.function_of(s_.at(declared).first) < 0 || n.type.base != s_.at(bound.node).type.base)
            return false;
        const double rounds = n.value.size() == 1 ? std::floor(n.value.front() * factor) : 1;
        if (rounds < 1 || rounds > most_rounds) return true;
        const std::string text = closed(n) ? s_.text(begins) : "(" + s_.text(begins) + ")";
        if (n.form == Form::number)
            offer(bound.where, s_.span(declared), begins, s_.span(begins), rounds, factor > 1);
        else if (factor < 1)
            offers_.add(ChangeKind::fewer_rounds, s_.span(declared),
                        {{s_.span(begins), divided(text, n, static_cast<int>(1 / factor))}});
        return true;
    }

    // The macro that gave the node, and nothing else but brackets around it.
    std::string_view macro_of(const Node& n) const {
        const std::int32_t macro = s_.token(n.first).macro;
        int first = n.first, last = n.last;
        const auto gave = [&](int k) {
            return k >= 0 && k < static_cast<int>(s_.unit.tokens.size()) && s_.token(k).macro == macro;
        };
        while (gave(first - 1) && gave(last + 1) && s_.token(first - 1).text == "(" && s_.token(last + 1).text == ")")
            --first, ++last;
        if (gave(first - 1) || gave(last + 1)) return {};
        for (int k = first; k <= last; ++k)
            if (!gave(k)) return {};
        return written(s_.token(n.first));
    }

    bool definition_of_macro(const RoundBound& bound, double factor) {
        const Node& n = s_.at(bound.node);
        const std::string_view name = macro_of(n);
        if (name.empty() || n.form != Form::number || sizes_.contains(name)) return false;
        const auto [known, fresh] = definitions_.try_emplace(s_.token(n.first).text.data());
        if (fresh) known->second = definition(name, s_.token(n.first).text);
        const std::optional<Span>& place = known->second;
        const auto value = other(bound, n.value.front(), factor);
        if (!place) return false;
        if (!value) return true;
        const std::string_view all = s_.sources.text(place->file);
        const std::uint32_t line = static_cast<std::uint32_t>(all.rfind('\n', place->begin) + 1);
        offer(bound.where, Span{place->file, line, place->end}, bound.node, *place, *value, factor > 1);
        return true;
    }

    void use_of_macro(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        const std::string_view name = macro_of(n);
        const glsl::Token& t = s_.token(n.first);
        const bool word = !name.empty() && name.find_first_of("( \t\n") == std::string_view::npos;
        const bool fewer = n.value.size() != 1 || other(bound, n.value.front(), 1. / share);
        if (!word || !closed(n) || s_.library[t.file] || !fewer) return;
        const auto begin = t.offset, end = begin + static_cast<std::uint32_t>(name.size());
        const Span use{s_.files[t.file], begin, end};
        if (s_.text(use) == name)
            offers_.add(ChangeKind::fewer_rounds, use, {{use, divided(std::string(name), n, share)}});
    }

    static std::string divided(const std::string& text, const Node& n, int share) {
        if (n.type.base == glsl::Base::real) return fmt::format("{}*{}", share == 2 ? ".5" : ".25", text);
        const std::string_view suffix = n.type.base == glsl::Base::uinteger ? "u" : "";
        if (n.value.size() == 1) return fmt::format("{}/{}{}", text, share, suffix);
        // Rounded up: a slider at 1 leaves one round, and no division by 0 where the number divides something.
        return fmt::format("({}+{}{})/{}{}", text, share - 1, suffix, share, suffix);
    }

    void expression(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        if (!s_.own(bound.where)) return;
        const std::string text = closed(n) ? s_.text(bound.node) : "(" + s_.text(bound.node) + ")";
        std::vector<Edit> edits{{s_.span(bound.node), divided(text, n, share)}};
        for (const int use : other_uses(bound.node))
            edits.push_back({s_.span(use), "(" + divided(text, n, share) + ")"});
        offers_.add(ChangeKind::fewer_rounds, s_.span(bound.where), std::move(edits));
    }

    // Other places of the function where a uniform or a parameter stands that nothing assigns: the size of a step
    // shrinks with the number of steps.
    std::vector<int> other_uses(int node) const {
        const Node& n = s_.at(node);
        const int function = s_.function_of(n.first);
        std::vector<int> uses;
        if (n.form != Form::name || n.variable < 0 || function < 0) return uses;
        const int declared = s_.declarator(n.variable);
        if (declared >= 0 && s_.at(declared).begin < declared) return {};  // a local whose value shrinks with it
        for (const int use : s_.uses(n.variable)) {
            if (s_.function_of(s_.at(use).first) != function) continue;
            if (s_.written(use) || !s_.own(use) || sizes_.contains(n.text)) return {};
            if (use != node) uses.push_back(use);
        }
        return uses;
    }

    // Ladders choose among such numbers already.
    bool of_ladder(const Node& n) const {
        if (n.first < 0 || s_.token(n.first).macro < 0) return false;
        const std::string_view name = written(s_.token(n.first));
        return std::any_of(s_.defines.begin(), s_.defines.end(), [&](const auto& d) { return d.name == name; });
    }

    // Where the author defines the macro as a number: the token's text is a view of that place.
    std::optional<Span> definition(std::string_view name, std::string_view number) const {
        for (const std::string& text : s_.unit.arena) {
            const bool within = std::less_equal<>()(text.data(), number.data()) &&
                                std::less_equal<>()(number.data() + number.size(), text.data() + text.size());
            if (!within) continue;
            const auto begin = static_cast<std::size_t>(number.data() - text.data());
            for (std::size_t f = 0; f < s_.files.size(); ++f) {
                const std::string_view all = s_.sources.text(s_.files[f]);
                if (s_.library[f] || all.size() != text.size() || all.substr(begin, number.size()) != number) continue;
                const std::size_t line = all.rfind('\n', begin) + 1;
                const Span found{s_.files[f], static_cast<std::uint32_t>(begin),
                                 static_cast<std::uint32_t>(begin + number.size())};
                if (defines(all.substr(line, begin - line), name)) return found;
            }
        }
        return std::nullopt;
    }

    // Whether a line begins with "#define NAME", and nothing else.
    static bool defines(std::string_view line, std::string_view name) {
        std::size_t end = 0;
        for (const std::string_view word : {std::string_view("#"), std::string_view("define"), name}) {
            end = glsl::skip_trivia(line, end).end;
            const std::string_view there = end < line.size() ? glsl::lex(line, end).text : std::string_view();
            if (there != word) return false;
            end += there.size();
        }
        return glsl::skip_trivia(line, end).end == line.size();
    }

    static std::size_t at(int i) { return static_cast<std::size_t>(i); }

    const Shader& s_;
    Offers& offers_;
    std::set<std::pair<int, std::size_t>> parameters_;        // of functions: they bound loops
    std::set<std::string_view> sizes_;                        // of arrays: the text has, or writes, as many values
    std::map<const char*, std::optional<Span>> definitions_;  // of macros, by their numbers
    int loop_ = -1;                                           // whose numbers follow
    std::set<int> sums_,
        counting_;  // variables: that the loop adds to from outside; its counter, and what is made of it
};

}  // namespace

void add_rounds(const Shader& shader, Offers& offers) { Rounds(shader, offers).run(); }

}  // namespace snell::accuracy
