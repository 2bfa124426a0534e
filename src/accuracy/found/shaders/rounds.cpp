// Loops that go round less often.
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

// What shrinks: the bound of a loop, or the argument that a function takes for one.
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
            const glsl::Token& t = s_.unit.tokens[k];
            if (s_.unit.tokens[k - 1].text == "[")
                sizes_.insert(t.macro >= 0 ? s_.unit.invocations[at(t.macro)].source : t.text);
        }
    }

    void run() {
        for (int n = 0; n < s_.nodes(); ++n)
            if (s_.at(n).form == Form::loop)
                for (const Counter& c : counters(s_, n))
                    if (c.target >= 0 && fills(n, c)) keep(s_.at(s_.bare(c.target)));
        for (int n = 0; n < s_.nodes(); ++n)
            if (s_.at(n).form == Form::loop)
                for (const Counter& c : counters(s_, n))
                    if (!fills(n, c)) loop(c);
        std::size_t known = 0;
        do {  // a function may hand its parameter on
            known = parameters_.size();
            for (int n = 0; n < s_.nodes(); ++n)
                if (s_.at(n).form == Form::call) follow(n);
        } while (parameters_.size() > known);
        for (int n = 0; n < s_.nodes(); ++n)
            if (s_.at(n).form == Form::call) call(n);
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
        while (loop >= 0 && s_.at(loop).form != Form::loop) loop = s_.parent(loop);
        if (loop < 0) return false;
        for (int k = s_.at(loop).first; k <= s_.at(loop).last; ++k)
            if (s_.token(k).text == "EmitVertex") return true;
        return false;
    }

    // The value of the name or the macro stays: as many elements are written.
    void keep(const Node& n) {
        if (n.form == Form::name) sizes_.insert(n.text);
        if (n.first >= 0 && s_.token(n.first).macro >= 0)
            sizes_.insert(s_.unit.invocations[at(s_.token(n.first).macro)].source);
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
        for (const int share : {2, 4}) shrink(bound, share);
    }

    // The loop's bound is a parameter of the function: calls decide on it.
    void remember(int node) {
        const Node& n = s_.at(node);
        const int function = s_.function_of(n.first);
        if (n.form != Form::name || n.variable < 0 || function < 0) return;
        const std::vector<glsl::Parameter>& parameters = s_.unit.functions[at(function)].parameters;
        for (std::size_t p = 0; p < parameters.size(); ++p)
            if (parameters[p].variable == n.variable) parameters_.emplace(function, p);
    }

    // The argument of a call that bounds a loop; -1: there is none.
    int argument(int node) const {
        const Node& n = s_.at(node);
        const std::vector<int> given = s_.parts(node);
        if (n.function < 0) return -1;
        const glsl::Function& called = s_.unit.functions[at(n.function)];
        for (const auto& [function, parameter] : parameters_) {
            const glsl::Function& f = s_.unit.functions[at(function)];
            const bool same = f.name == called.name && f.parameters.size() == called.parameters.size() &&
                              std::equal(f.parameters.begin(), f.parameters.end(), called.parameters.begin(),
                                         [](const auto& a, const auto& b) { return a.type.same(b.type); });
            if (same && parameter < given.size()) return s_.bare(given[parameter]);
        }
        return -1;
    }

    void follow(int node) {
        if (const int given = argument(node); given >= 0) remember(given);
    }

    void call(int node) {
        const int given = argument(node);
        if (given < 0 || s_.library[s_.token(s_.at(node).first).file]) return;
        for (const int share : {2, 4}) shrink({given, 0, node, 1, false}, share);
    }

    void shrink(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        if (!n.type.scalar() || !n.type.numeric() || n.type.base == glsl::Base::dreal) return;
        if (of_ladder(n)) return;
        const bool macro = n.first >= 0 && s_.token(n.first).macro >= 0;
        if (macro ? definition_of_macro(bound, share) : definition_of_name(bound, share)) return;
        if (macro)
            use_of_macro(bound, share);
        else if (n.form == Form::number)
            number(bound, share);
        else if (s_.own(bound.node))
            expression(bound, share);
    }

    // The number that bounds as many rounds as the share leaves; nothing if there is none left, or all.
    static std::optional<double> fewer(const RoundBound& bound, double value, int share) {
        const double more = bound.includes ? bound.step : 0, all = (value - bound.base + more) / bound.step;
        const double left = std::floor(all / share);
        if (!(left >= 1) || !(all < 1e7) || left >= all) return std::nullopt;
        return bound.base + left * bound.step - more;
    }

    void number(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        const std::optional<double> value = fewer(bound, n.value.front(), share);
        if (!value || !s_.own(bound.node) || !s_.own(bound.where)) return;
        offer(bound, s_.span(bound.where), s_.span(bound.node), n, *value);
    }

    // Offers the value `after` for the number `n`, which stands at `number`. A sum that is divided by the number of
    // rounds, written as a number, stays a mean.
    void offer(const RoundBound& bound, Span where, Span number, const Node& n, double after) {
        const double before = n.value.front();
        std::vector<Edit> edits{{number, literal(after, n.type)}};
        int loop = bound.where;
        while (loop >= 0 && s_.at(loop).form != Form::loop) loop = s_.parent(loop);
        const std::set<int> summed = loop < 0 ? std::set<int>() : sums(loop);
        for (int k = 0; k < s_.nodes() && !summed.empty() && before >= 4 && !offers_.full(); ++k) {
            const Node& other = s_.at(k);
            if (other.form == Form::number && other.type.base == glsl::Base::real && other.value.size() == 1 &&
                other.value.front() == before && k != bound.node && s_.own(k) && divides(k, loop, summed))
                edits.push_back({s_.span(k), literal(after, other.type)});
        }
        offers_.add(ChangeKind::fewer_rounds, where, std::move(edits));
    }

    // Variables from outside of the loop that it adds to.
    std::set<int> sums(int loop) const {
        std::set<int> found;
        for (int n = s_.at(loop).begin; n < loop; ++n) {
            if (s_.at(n).form != Form::assign || s_.at(n).text != "+=") continue;
            const Node& root = s_.at(s_.at(s_.parts(n)[0]).begin);
            if (root.form != Form::name || root.variable < 0) continue;
            const int declared = s_.declarator(root.variable);
            if (declared < s_.at(loop).begin || declared > loop) found.insert(root.variable);
        }
        return found;
    }

    // The sum that the value is, or a multiple of it; -1: none.
    int sum_of(int node, const std::set<int>& summed) const {
        const Node& n = s_.at(s_.bare(node));
        const std::vector<int> inside = s_.parts(s_.bare(node));
        if (n.form == Form::name) return summed.contains(n.variable) ? n.variable : -1;
        if (n.form == Form::select || n.form == Form::index) return sum_of(inside[0], summed);
        if (n.form != Form::infix || (n.text != "*" && n.text != "/")) return -1;
        const int left = sum_of(inside[0], summed);
        return left >= 0 || n.text == "/" ? left : sum_of(inside[1], summed);
    }

    // Whether the number divides a sum of the loop: behind it, where nothing else was stored in the sum since, or what
    // the loop adds to it.
    bool divides(int number, int loop, const std::set<int>& summed) const {
        const auto outside = [&](int node) {
            int up = s_.parent(node);
            while (up >= 0 && s_.at(up).form == Form::group) up = s_.parent(up);
            return up;
        };
        const auto is = [&](int node, Form form, std::string_view a, std::string_view b) {
            return node >= 0 && s_.at(node).form == form && (s_.at(node).text == a || s_.at(node).text == b);
        };
        const int division = outside(number);
        if (!is(division, Form::infix, "/", "/") && !is(division, Form::assign, "/=", "/=")) return false;
        const std::vector<int> sides = s_.parts(division);
        if (s_.bare(sides[1]) != number) return false;
        int sum = sum_of(sides[0], summed), top = division;
        while (is(outside(top), Form::infix, "*", "/")) {  // s * (1. / 16.)
            top = outside(top);
            if (sum < 0) sum = sum_of(s_.parts(top)[0], summed);
        }
        const int stored = outside(top);
        const bool plain = s_.at(division).form == Form::infix;
        if (s_.at(loop).begin <= division && division < loop)
            return plain && is(stored, Form::assign, "+=", "+=") && sum_of(s_.parts(stored)[0], summed) >= 0;
        if (sum < 0 && is(stored, Form::assign, "*=", "*=")) sum = sum_of(s_.parts(stored)[0], summed);
        const int first = s_.at(stored >= 0 && s_.at(stored).form == Form::assign ? stored : top).first;
        if (sum < 0 || first <= s_.at(loop).last) return false;
        return std::none_of(s_.uses(sum).begin(), s_.uses(sum).end(), [&](int use) {
            return s_.written(use) && s_.at(use).first > s_.at(loop).last && s_.at(use).first < first;
        });
    }

    // A constant, or a local that nothing assigns later: where it is declared, so that the size of a step follows the
    // number of steps.
    bool definition_of_name(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        if (n.form != Form::name || n.variable < 0 || sizes_.contains(n.text)) return false;
        const int declared = s_.declarator(n.variable);
        if (declared < 0) return false;
        const std::vector<int> inside = s_.parts(declared);
        if (inside.size() != 1 || !s_.own(declared)) return false;
        if (!s_.at(declared).constant) return local(bound, declared, inside[0], share);
        const Node& number = s_.at(inside[0]);
        if (number.form != Form::number) return false;
        if (const auto value = fewer(bound, number.value.front(), share))
            offer(bound, s_.span(declared), s_.span(inside[0]), number, *value);
        return true;
    }

    bool local(const RoundBound& bound, int declared, int begins, int share) {
        const Node& n = s_.at(begins);
        const std::vector<int>& uses = s_.uses(s_.at(bound.node).variable);
        const bool assigned = std::any_of(uses.begin(), uses.end(), [&](int use) { return s_.written(use); });
        if (assigned || s_.function_of(s_.at(declared).first) < 0 || n.type.base != s_.at(bound.node).type.base)
            return false;
        if (n.value.size() == 1 && n.value.front() < share) return true;
        const std::string text = closed(n) ? s_.text(begins) : "(" + s_.text(begins) + ")";
        if (n.form == Form::number)
            offer(bound, s_.span(declared), s_.span(begins), n, std::floor(n.value.front() / share));
        else
            offers_.add(ChangeKind::fewer_rounds, s_.span(declared), {{s_.span(begins), divided(text, n, share)}});
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
        return s_.unit.invocations[at(macro)].source;
    }

    bool definition_of_macro(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        const std::string_view name = macro_of(n);
        if (name.empty() || n.form != Form::number || sizes_.contains(name)) return false;
        const auto [known, fresh] = definitions_.try_emplace(s_.token(n.first).text.data());
        if (fresh) known->second = definition(name, s_.token(n.first).text);
        const std::optional<Span>& place = known->second;
        const auto value = fewer(bound, n.value.front(), share);
        if (!place) return false;
        if (!value) return true;
        const std::string_view all = s_.sources.text(place->file);
        const std::uint32_t line = static_cast<std::uint32_t>(all.rfind('\n', place->begin) + 1);
        offer(bound, {place->file, line, place->end}, *place, n, *value);
        return true;
    }

    void use_of_macro(const RoundBound& bound, int share) {
        const Node& n = s_.at(bound.node);
        const std::string_view name = macro_of(n);
        const glsl::Token& t = s_.token(n.first);
        const bool word = !name.empty() && name.find_first_of("( \t\n") == std::string_view::npos;
        const bool fewer_left = n.value.size() != 1 || fewer(bound, n.value.front(), share);
        if (!word || !closed(n) || s_.library[t.file] || !fewer_left) return;
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
        const std::string_view name = s_.unit.invocations[at(s_.token(n.first).macro)].source;
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
};

}  // namespace

void add_fewer_rounds(const Shader& shader, Offers& offers) { Rounds(shader, offers).run(); }

}  // namespace snell::accuracy
