// Drivers fold constants by other rules than they compute by: where GLSL leaves a result undefined, the two differ.
// Operands that could be such constants are marked here: divisors in every program, the others if the program asks for
// results as at run time. The functions that keep them from being folded there are written by provide_helpers.

#include "src/glsl/read/parse.h"

#include "parser/text/ranges.h"

namespace snell::glsl {

namespace {

// A number or a vector of numbers that the helpers take.
bool marked_type(const Type& t) {
    return t.dims == 0 && t.cols == 1 && (t.base == Base::real || t.base == Base::integer || t.base == Base::uinteger);
}

// Whether the source text itself says what the value is: then it is folded in every form of the program.
bool from_source(const Expression& e) { return e.constant || e.first < 0 || e.last < e.first; }

bool zero(const Expression& e) {
    return e.value.empty() || ranges::any_of(e.value, [](double v) { return v == 0; });
}

bool positive(const Expression& e) {
    return !e.value.empty() && ranges::all_of(e.value, [](double v) { return v > 0; });
}

}  // namespace

void Parser::mark(const Expression& e, std::string_view function, int step, int operand, bool both) {
    if (e.first < 0 || e.last < e.first || !marked_type(e.type)) return;
    wrap(e, std::string(mark_name) + std::to_string(u_.marks.size()));
    u_.marks.push_back({function, step, operand, -1, both, e.last, from_source(e), !e.value.empty()});
}

// Divisors that are numbers of the text are marked where they may be 0.
void Parser::mark_divisor(const Expression& e, int step) {
    if (!from_source(e) || zero(e)) mark(e, divisor_mark, step, 1, false);
}

// What is made of numbers only is folded by the rules of constant expressions in every form.
void Parser::mark_division(const Expression* a, const Expression& b, std::string_view op, int step) {
    if ((op != "/" && op != "%") || (a && from_source(*a) && from_source(b))) return;
    mark_divisor(b, step);
    if (at_run_time_ && op == "%" && a && a->type.base == Base::integer)
        mark(*a, "snell_dividend", step, 0, from_source(*a));
}

void Parser::mark_call(const Expression& call, std::string_view name, const std::vector<Expression>& given) {
    if (given.size() != 2) return;
    const bool first = from_source(given[0]), second = from_source(given[1]);
    if (first && second) return;
    const int step = here();  // the call comes next
    if (name == "mod") mark_divisor(given[1], step);
    if (!at_run_time_) return;
    if (name == "atan") mark(given[first ? 1 : 0], divisor_mark, step, first ? 1 : 0, false);
    if (name != "pow" || positive(given[0]) || !marked_type(given[0].type)) return;
    if (second) return mark(given[0], "snell_base", step, 0, false);
    u_.marks.push_back({"snell_pow", step, 0, call.first, true});
}

}  // namespace snell::glsl
