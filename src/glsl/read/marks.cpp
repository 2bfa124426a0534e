// Expressions that some programs write otherwise. Drivers fold constants by other rules than they compute by: where
// GLSL leaves a result undefined, the two differ. So divisors that could be 0 are marked in every program. In a program
// for settled values, decisions are marked, too, and what a driver would find constant as soon as these are made. What
// is written in their place is decided by resolve_marks, and the functions that are called there are in helpers.cpp.

#include "src/glsl/read/parse.h"

#include "parser/text/ranges.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

// A number or a vector of numbers that the helpers take.
bool marked_type(const Type& t) {
    return t.dims == 0 && t.cols == 1 && (t.base == Base::real || t.base == Base::integer || t.base == Base::uinteger);
}

// The same for what is kept.
bool kept_type(const Type& t) {
    if (t.dims > 0 || t.base < Base::boolean || t.base > Base::real) return false;
    return t.cols == 1 || (t.base == Base::real && t.cols == t.rows);
}

// Whether the source text itself says what the value is: then it is folded in every form of the program.
bool from_source(const Expression& e) { return e.constant || e.first < 0 || e.last < e.first; }

bool zero(const Expression& e) {
    return e.value.empty() || ranges::any_of(e.value, [](double v) { return v == 0; });
}

}  // namespace

Mark& Parser::mark(Mark::Kind kind, const Expression& e) {
    wrap(e, std::string(mark_name) + std::to_string(u_.marks.size()));
    return u_.marks.emplace_back(Mark{kind, e.step, -1, -1, e.last, from_source(e), !e.value.empty()});
}

// Divisors that are numbers of the text are marked where they may be 0.
void Parser::mark_divisor(const Expression& e) {
    if (e.first < 0 || e.last < e.first || !marked_type(e.type)) return;
    if (!from_source(e) || zero(e)) mark(Mark::Kind::divisor, e);
}

// What is made of numbers only is folded by the rules of constant expressions in every form.
void Parser::mark_division(const Expression* a, const Expression& b, std::string_view op) {
    if ((op == "/" || op == "%") && !(a && from_source(*a) && from_source(b))) mark_divisor(b);
}

// A condition, or what a loop counts to; nothing that has another effect.
void Parser::mark_decision(const Expression& e) {
    if (!settles_ || from_source(e) || !e.type.scalar() || e.type.base < Base::boolean || e.type.base > Base::real)
        return;
    for (int k = e.first; k <= e.last; ++k) {
        const std::string_view t = u_.at(k).text;
        if (assigns(t) || t == "++" || t == "--" || u_.function_names.contains(t)) return;
    }
    mark(Mark::Kind::decision, e);
}

// A product of two factors, or mix(a, b, weight).
void Parser::mark_product(const Expression& e, const Expression& a, const Expression& b, const Expression* weight) {
    const auto fits = [&](const Expression& f) {
        return !from_source(f) && f.type.scalar() && f.type.base == Base::real;
    };
    if (!settles_ || !marked_type(e.type) || e.type.base != Base::real || (weight && !fits(*weight))) return;
    if (!weight && !fits(a) && !fits(b)) return;
    const auto mark_weight = [&](const Expression& f, int one, int other) {
        if (!fits(f)) return;
        Mark& m = mark(Mark::Kind::weight, f);
        m.one = one, m.other = other;
    };
    if (weight) {
        mark_weight(*weight, b.step, a.step);
    } else {
        mark_weight(a, b.step, -1);
        mark_weight(b, a.step, -1);
    }
    const auto first = static_cast<int>(u_.marks.size()) - 1;
    mark(Mark::Kind::product, e).one = first;
    u_.marks.back().other = !weight && fits(a) && fits(b) ? first - 1 : first;
}

// `into`: the instruction that gives it to a variable, or returns it; -1: it is kept anyway. What can't be written as a
// call is marked all the same: the unit's values are not settled then.
void Parser::mark_kept(const Expression& e, int into, bool written) {
    if (!settles_ || e.first < 0 || e.last < e.first || (into < 0 && e.constant)) return;
    if (e.type.dims > 0 || e.type.base == Base::structure) {
        const auto made_of = constructed_.find(e.step);
        if (made_of != constructed_.end())
            for (const Expression& part : std::vector(made_of->second)) mark_kept(part, into, written);
        if (made_of != constructed_.end() || !e.constant) return;  // what enters it otherwise is kept there
    }
    const bool other = e.type.base == Base::sampler || e.type.base == Base::none;
    if (other || (into >= 0 && e.type.basic() && !e.type.floating())) return;
    if (written && kept_type(e.type))
        mark(Mark::Kind::kept, e);
    else
        u_.marks.push_back({Mark::Kind::kept, e.step, -1, -1, -1});
    u_.marks.back().one = into;
}

}  // namespace snell::glsl
