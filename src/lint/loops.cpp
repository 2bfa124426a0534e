// Estimates how often loops repeat, without running the shader.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"
#include "src/lint/walker.h"

namespace snell::lint {

namespace {

using glsl::Kind;

constexpr double endless = std::numeric_limits<double>::infinity();

// llvmpipe counts the rounds of all loops of a shader together, and one more each time that a loop is left.
constexpr double most_rounds = 65535;

bool is_step(std::string_view t) { return t == "++" || t == "--"; }

constexpr std::string_view go_round_text = "the loops of this shader go round ";

std::string rounds_text(double rounds) {
    return rounds == endless ? "for ever" : fmt::format("about {:.0f} times", rounds);
}

}  // namespace

// break, return and discard, but for a break that leaves another loop or a switch within.
bool Walker::leaves(int first, int last) const {
    int within = first - 1;  // the last token of such a one
    for (int k = first; k <= last; ++k) {
        const std::string_view t = u_.at(k).text;
        if (t == "return" || t == "discard" || (t == "break" && k > within)) return true;
        if (t == "for" || t == "while" || t == "switch") within = std::max(within, statement_end(matching(k + 1) + 1));
        if (t == "do") within = std::max(within, statement_end(k + 1));
    }
    return false;
}

bool Walker::assigned(std::string_view name, int first, int last) const {
    for (int k = first; k <= last; ++k) {
        if (u_.at(k).text != name) continue;
        const std::string_view before = u_.at(k - 1).text, after = u_.at(k + 1).text;
        // A function may change what it is given; float(i) doesn't.
        const bool converted = before == "(" && glsl::builtin_type(u_.at(k - 2).text);
        const bool handed = !converted && (before == "(" || before == ",") && (after == ")" || after == ",");
        if (is_step(before) || is_step(after) || glsl::assigns(after) || handed) return true;
    }
    return false;
}

// What i++, ++i, i -= 2 and their like add to `name`; 0: another thing.
double Walker::step_of(std::string_view name, int first, int last) const {
    const auto word = [&](int k) { return u_.at(k).text; };
    const auto sign = [](std::string_view t) { return t.starts_with('-') ? -1.0 : 1.0; };
    if (last - first == 1 && word(first) == name && is_step(word(last))) return sign(word(last));
    if (last - first == 1 && word(last) == name && is_step(word(first))) return sign(word(first));
    if (last - first != 2 || word(first) != name || (word(first + 1) != "+=" && word(first + 1) != "-=")) return 0;
    const glsl::Token& by = u_.at(last);
    if (by.kind != Kind::integer && by.kind != Kind::real) return 0;
    double step = 0;
    read_real(by.text.data(), by.text.data() + by.text.size(), step);
    return sign(word(first + 1)) * step;
}

// The same of a loop's body, as far as it is done in every round.
double Walker::body_step(std::string_view name, int first, int last) const {
    double step = 0;
    const bool braces = u_.at(first).text == "{";
    for (int k = first + (braces ? 1 : 0), end = 0; k <= last - (braces ? 1 : 0); k = end + 1) {
        end = statement_end(k);
        const double here = step_of(name, k, end - 1);
        if (here == 0 && assigned(name, k, end)) return 0;
        step += here;
    }
    for (int k = first; k <= last; ++k)
        if (u_.at(k).text == "continue") return 0;
    return step;
}

// Whether the variable has the same value in every round. A function might change a global one.
bool Walker::stays(std::string_view name, const Loop& loop) const {
    for (int k = loop.body; k <= loop.body_end; ++k)
        if (u_.function_names.contains(u_.at(k).text)) return false;
    return !assigned(name, loop.step, loop.step_end - 1) && !assigned(name, loop.body, loop.body_end);
}

// 0: it is not known. A slider counts as far as it goes.
double Walker::rounds_of(const Loop& loop) {
    const int begin = loop.condition, end = loop.condition_end;
    const bool always = end == begin || (end == begin + 1 && u_.at(begin).text == "true");
    if (leaves(loop.body, loop.body_end)) return 0;
    if (always) return endless;
    const std::string_view name = u_.at(begin).text, op = u_.at(begin + 1).text;
    const int slot = find(name);
    const bool stepped = loop.step < loop.step_end;  // by its header
    const double step =
        stepped ? step_of(name, loop.step, loop.step_end - 1) : body_step(name, loop.body, loop.body_end);
    const bool left_alone = step == 0 && stays(name, loop);
    if (slot < 0 || (step == 0 && !left_alone) || (stepped && assigned(name, loop.body, loop.body_end))) return 0;
    const int here = std::exchange(p_, begin + 2);
    Value bound = expression().v;
    const bool whole = std::exchange(p_, here) == end;
    if (!whole) return 0;
    if (bound.uniform >= 0)
        if (const auto set = around_.uniforms.find(u_.globals[static_cast<std::size_t>(bound.uniform)].name);
            set != around_.uniforms.end())
            bound.range = set->second.range;
    const Range& from = state_.slots[static_cast<std::size_t>(slot)].value.range;
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
    report(Rule::many_rounds, first, last,
           std::string(go_round_text) + rounds_text(rounds_) +
               ": without a GPU, Mesa's llvmpipe ends them after 65535, and the picture is what they had by then");
}

}  // namespace snell::lint
