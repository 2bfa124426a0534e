// Constants are followed through the code of a stage without regard to the order of its statements: a variable may be
// constant if one of its assignments is, and is surely a number if all of them are that number.
#include "src/glsl/translate/program.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "parser/text/number.h"
#include "parser/text/ranges.h"

namespace snell::glsl::folding {

namespace {

using Kind = Fold::Kind;
using Sure = Fold::Sure;

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr int most_walks = 100;
constexpr double largest = 1e30;  // of what is surely finite in floats, too

struct Item {
    Fold fold;
    int variable = -1;
    bool whole = true;      // not an element or a member of the variable
    std::size_t begin = 0;  // the first of its instructions
};

bool is_live(const Fold& a) { return a.kind == Kind::live; }

Fold constant(bool zero) {
    Fold fold;
    fold.kind = Kind::constant;
    fold.zero = zero;
    return fold;
}

Fold both(const Fold& a, const Fold& b, bool zero) {
    Fold fold = is_live(a) || is_live(b) ? Fold{} : constant(zero);
    fold.cancels = a.cancels || b.cancels;
    return fold;
}

// A difference of floats may be 0 where one of doubles is not.
bool vanishes(double value, double a, double b) {
    return !std::isfinite(value) || std::abs(value) <= 1e-5 * std::max(std::abs(a), std::abs(b));
}

bool may_be_zero(const Fold& fold) { return !is_live(fold) && fold.zero; }

// 0 times or by anything is 0 for a driver, even where NaN, if it finds the 0.
Fold of_operator(std::string_view op, const Fold& a, const Fold& b) {
    Fold result = both(a, b, op == "*" ? a.zero || b.zero : op == "/" ? a.zero : true);
    const bool either_way = op == "*" || op == "&" || op == "&&" || op == "||";
    const bool first = op == "/" || op == "%" || op == "<<" || op == ">>";
    if (((either_way || first) && may_be_zero(a)) || (either_way && may_be_zero(b))) result = constant(true);
    if (is_live(result) || std::isnan(a.value) || std::isnan(b.value) || op.size() != 1) return result;
    result.value = op == "+"   ? a.value + b.value
                   : op == "-" ? a.value - b.value
                   : op == "*" ? a.value * b.value
                   : op == "/" ? a.value / b.value
                               : result.value;
    if (op == "+" || op == "-") result.zero = vanishes(result.value, a.value, b.value);
    return result;
}

// ---- what is sure -----------------------------------------------------------------------------------------

// As the stage has it; not known beyond what its type holds, and what drivers may flush to zero.
Fold& give_number(Fold& fold, Base base, double value, bool exact, std::uint64_t from) {
    const bool real = base == Base::real, fits = base == Base::boolean || std::abs(value) < 2147483648.;
    fold.base = base;
    if (!std::isfinite(value) || (!real && !fits) || (base == Base::uinteger && value < 0) ||
        (real && (std::abs(value) > largest || (value != 0 && std::abs(value) < 1e-30))) || base == Base::dreal)
        return fold;
    fold.sure = Sure::number;
    fold.exact = exact && (!real || static_cast<double>(static_cast<float>(value)) == value);
    fold.number = value;
    fold.most = std::abs(value);
    fold.from = from;
    return fold;
}

// Of two numbers that may be rounded: whether their order is sure.
bool apart(const Fold& a, const Fold& b) {
    return (a.exact && b.exact) ||
           std::abs(a.number - b.number) > 1e-4 * std::max(std::abs(a.number), std::abs(b.number));
}

void compute(Fold& result, std::string_view op, const Fold& a, const Fold& b) {
    const double x = a.number, y = b.number;
    const bool exact = a.exact && b.exact, whole = std::max(a.base, b.base) < Base::real;
    const Base base = std::max(a.base, b.base);
    const auto is = [&](bool value) { give_number(result, Base::boolean, value ? 1 : 0, true, a.from | b.from); };
    const auto gives = [&](double value) { give_number(result, base, value, exact, a.from | b.from); };
    if (op == "+") return gives(x + y), void();
    if (op == "-") return gives(x - y), void();
    if (op == "*") return gives(x * y), void();
    if (op == "/" && y != 0) return gives(whole ? std::trunc(x / y) : x / y), void();
    if (op == "&&") return is(x != 0 && y != 0);
    if (op == "||") return is(x != 0 || y != 0);
    if (op == "^^") return is((x != 0) != (y != 0));
    if (!apart(a, b)) return;
    if (op == "<") is(x < y);
    if (op == ">") is(x > y);
    if (op == "<=") is(x <= y);
    if (op == ">=") is(x >= y);
    if (op == "==") is(x == y);
    if (op == "!=") is(x != y);
}

double product(double a, double b) { return a < endless && b < endless ? a * b : endless; }

double most_of(std::string_view op, const Fold& a, const Fold& b) {
    if (op == "+" || op == "-") return a.most + b.most;
    return op == "*" ? 4 * product(a.most, b.most) : endless;  // of matrices: a sum
}

bool either_nothing(const Fold& a, const Fold& b) { return a.sure == Sure::nothing || b.sure == Sure::nothing; }

void know_operator(Fold& result, std::string_view op, const Fold& a, const Fold& b) {
    result.most = either_nothing(a, b) ? 0 : most_of(op, a, b);
    result.base = std::max(a.base, b.base);
    result.from = a.from | b.from;
    if (either_nothing(a, b)) result.sure = Sure::nothing;
    // What decides alone: the other operand is not looked at.
    const auto alone = [&](const Fold& one) {
        return one.sure == Sure::number && ((op == "&&" && one.number == 0) || (op == "||" && one.number != 0));
    };
    for (const Fold* one : {&a, &b})
        if (alone(*one)) return give_number(result, Base::boolean, op == "||" ? 1 : 0, true, one->from), void();
    if (a.sure == Sure::number && b.sure == Sure::number) compute(result, op, a, b);
}

// One of them, nobody knows which.
void know_either(Fold& result, const Fold& a, const Fold& b) {
    const auto take = [&](const Fold& one) {
        result.sure = one.sure, result.base = one.base, result.number = one.number, result.exact = one.exact;
    };
    if (a.sure == Sure::nothing)
        take(b);
    else if (b.sure == Sure::nothing)
        take(a);
    else if (a.sure == Sure::number && b.sure == Sure::number && a.number == b.number && a.exact == b.exact)
        take(a);
    else
        result.sure = Sure::anything, result.base = a.base;
    result.most = std::max(a.most, b.most);
    result.from = a.from | b.from;
}

Fold either(const Fold& a, const Fold& b) {
    Fold one;
    if (!is_live(a) && !is_live(b)) {
        one = constant(a.zero || b.zero);
        if (a.value == b.value) one.value = a.value;
    } else if (!is_live(a) || !is_live(b)) {
        const Fold& known = is_live(a) ? b : a;
        one.kind = known.kind, one.zero = known.zero, one.value = known.value;
    }
    one.cancels = a.cancels || b.cancels;
    know_either(one, a, b);
    return one;
}

bool same(const Fold& a, const Fold& b) {
    const bool value = a.value == b.value || (std::isnan(a.value) && std::isnan(b.value));
    const bool number = a.sure != Sure::number || (a.base == b.base && a.number == b.number && a.exact == b.exact);
    return value && number && a.kind == b.kind && a.zero == b.zero && a.cancels == b.cancels && a.sure == b.sure &&
           a.most == b.most && a.from == b.from;
}

bool decided(const Fold& fold) { return fold.sure == Sure::number && fold.from != 0; }

// As an operand that is written as decided: see Parser::combine.
Fold seen(std::string_view op, Fold fold) {
    const bool logic = op == "&&" || op == "||" || op == "^^";
    const bool relation = op == "<" || op == ">" || op == "<=" || op == ">=" || op == "==" || op == "!=";
    const bool whole = fold.base == Base::integer || fold.base == Base::uinteger;
    if (decided(fold) && (logic || (relation && whole))) fold.kind = Kind::constant;
    return fold;
}

class Follower {
public:
    explicit Follower(const Unit& unit)
        : u_(unit),
          variables_(unit.code.variables.size()),
          results_(unit.code.steps.size()),
          given_(variables_.size()) {
        for (std::size_t n = 0; n < variables_.size(); ++n) {
            variables_[n].sure = Sure::nothing;
            variables_[n].most = 0;
            variables_[n].base = unit.code.variables[n].base;
        }
        for (const auto& [name, variable] : unit.built_ins) come_from_outside(variable, {});
        for (const Block& b : unit.blocks)
            for (std::size_t k = 0; b.variable >= 0 && k < (b.instance.empty() ? b.members.size() : 1); ++k)
                come_from_outside(b.variable + static_cast<int>(k), {});
    }

    void come_from_outside(int variable, const Fold& fold) {
        if (variable < 0) return;
        outside_.insert(variable);
        variables_[at(variable)] = fold;
    }
    Fold of(int variable) const { return variable < 0 ? Fold{} : variables_[at(variable)]; }

    void follow() {
        if (begun_.empty()) begun_ = variables_;
        do {
            changed_ = false;
            ++rounds_;
            walk();
        } while (changed_ && rounds_ < most_walks);
        if (changed_) results_.assign(results_.size(), {});  // nothing is known
    }
    // Again from the start: what goes through `snell_value` is not found constant. Chooses the marks that are written
    // so, of which none is needed for what another one hides already. False: it never ends.
    bool hide() {
        hidden_.assign(u_.marks.size(), false);
        for (std::size_t n = 0; n < u_.marks.size(); ++n)
            if (u_.marks[n].kind == Mark::Kind::kept) kept_[u_.marks[n].step].push_back(n);
        variables_ = begun_;
        results_of_.clear();
        choosing_ = true;
        rounds_ = 0;
        follow();
        choosing_ = false;
        return !changed_;
    }
    void hide(const std::vector<bool>& hidden) {
        hidden_ = hidden;
        for (std::size_t n = 0; n < u_.marks.size(); ++n)
            if (hidden_[n]) kept_[u_.marks[n].step].push_back(n);
    }
    const std::vector<bool>& hidden() const { return hidden_; }
    // Once more, with regard to the order: what a variable was last given in the text. Parameters keep what all calls
    // give them.
    void follow_in_order() {
        std::vector<Fold> first(variables_.size());
        const auto keep = [&](int variable) {
            if (variable >= 0) first[at(variable)] = variables_[at(variable)];
        };
        for (const Function& f : u_.functions)
            for (const Parameter& parameter : f.parameters) keep(parameter.variable);
        for (const Global& g : u_.globals)
            if (outside_.contains(g.variable)) keep(g.variable);
        variables_ = std::move(first);
        in_order_ = true;
        walk();
    }
    // The result of an instruction; of one that never runs, nothing.
    const Fold& result(int step) const { return results_[at(step)]; }
    // The uniforms that take part in numbers whose zeros differ by their sign: 1 / -0.
    std::uint64_t signs() const { return signs_; }
    // Whether what the instruction gives to a variable, or returns, is not all that this may be.
    bool one_of_several(int step) const {
        const Instruction& i = u_.code.steps[at(step)];
        if (i.op == Op::choose) return !is_live(conditions_.at(at(step))) || decided(conditions_.at(at(step)));
        if (i.op == Op::back) {
            const Function& f = u_.functions[function_at(at(step))];
            return std::count_if(u_.code.steps.begin() + f.code, u_.code.steps.begin() + f.code_end,
                                 [](const Instruction& other) { return other.op == Op::back && other.a; }) > 1;
        }
        const auto target = targets_.find(at(step));
        return target == targets_.end() || target->second < 0 || given_[at(target->second)] > 1;
    }

private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    void walk() {
        stack_.clear();
        count_.assign(given_.size(), 0);
        for (const Function& f : u_.functions)
            for (const Parameter& p : f.parameters)
                if (p.storage != Storage::in && p.variable >= 0) count_[at(p.variable)] = 2;
        for (std::size_t step = 0; step < u_.code.steps.size(); ++step) take(u_.code.steps[step], step);
        given_ = count_;
    }
    // Whether a mark of the step's result is written as a call; -1: a zero of the instruction `into`.
    bool hides(int step, int into, const Fold& fold) {
        const auto marks = kept_.find(step);
        if (marks == kept_.end()) return false;
        bool any = false;
        for (const std::size_t n : marks->second) {
            const int one = u_.marks[n].one;
            if (step < 0 && one != into) continue;
            const bool found = !is_live(fold) || (one >= 0 && fold.cancels);
            const bool now = choosing_ && found && (one < 0 || one_of_several(one));
            changed_ = changed_ || (now && !hidden_[n]);
            if (now) hidden_[n] = true;
            any = any || hidden_[n];
        }
        return any;
    }
    static Fold unseen(Fold fold) {
        fold.kind = Kind::live, fold.zero = fold.cancels = false;
        fold.value = std::numeric_limits<double>::quiet_NaN();
        return fold;
    }
    void know(Fold& known, const Fold& fold) {
        Fold now = either(known, fold);
        if (rounds_ > 8 && now.most > known.most) now.most = endless;  // a sum in a loop
        changed_ = changed_ || !same(now, known);
        known = now;
    }
    // What a variable is given as a whole takes the place of what it was.
    void give(const Item& target, Fold fold, std::size_t step) {
        if (target.variable < 0) return;
        targets_[step] = target.variable;
        count_[at(target.variable)] += target.whole ? 1 : 2;
        const Base base = u_.code.variables[at(target.variable)].base;
        if (fold.sure == Sure::number && (!target.whole || !u_.code.variables[at(target.variable)].scalar()))
            fold.sure = Sure::anything;
        fold.base = base;
        if (in_order_ && target.whole)
            variables_[at(target.variable)] = fold;
        else
            know(variables_[at(target.variable)], fold);
    }

    Item pop() {
        if (stack_.empty()) return {};
        const Item item = stack_.back();
        stack_.pop_back();
        begin_ = std::min(begin_, item.begin);
        return item;
    }
    void push(const Fold& fold, int variable = -1) { stack_.push_back({fold, variable, true, begin_}); }
    // Whether the text gives an operator the same operand twice: x - x, x / x. `b` ends before `end`.
    bool same_twice(std::string_view op, const Item& a, const Item& b, std::size_t end) const {
        const auto& steps = u_.code.steps;
        const auto same_step = [](const Instruction& one, const Instruction& other) {
            return one.op == other.op && one.a == other.a && one.text == other.text && one.number == other.number;
        };
        return (op == "-" || op == "/" || op == "%" || op == "^") && b.begin - a.begin == end - b.begin &&
               std::equal(steps.begin() + static_cast<std::ptrdiff_t>(a.begin),
                          steps.begin() + static_cast<std::ptrdiff_t>(b.begin),
                          steps.begin() + static_cast<std::ptrdiff_t>(b.begin), same_step);
    }
    std::vector<Item> pop(int count) {
        std::vector<Item> items(at(count));
        for (auto item = items.rbegin(); item != items.rend(); ++item) *item = pop();
        return items;
    }

    void take(const Instruction& i, std::size_t step) {
        begin_ = step;
        switch (i.op) {
            case Op::assign: {
                const Item given = pop(), target = pop();
                Fold fold = given.fold;
                if (i.text == "/=") signs_ |= given.fold.from;
                if (i.text.size() > 1) {
                    fold = of_operator(i.text.substr(0, 1), target.fold, given.fold);
                    if (same_twice(i.text.substr(0, 1), target, given, step)) fold = constant(true);
                    if (!kept_.empty() && hides(static_cast<int>(step), -1, fold)) fold = unseen(fold);
                    if (i.text.size() == 2) know_operator(fold, i.text.substr(0, 1), target.fold, given.fold);
                }
                give(target, fold, step);
                push(fold);
                break;
            }
            case Op::declare:
                declare(i, step);
                return;
            case Op::drop:
            case Op::unless:
                pop();
                return;
            case Op::back:
                if (i.a) know_result(step, pop().fold);
                return;
            case Op::jump:
            case Op::discard:
                return;
            default:
                value(i, step);
        }
        if (stack_.empty()) return;
        results_[step] = stack_.back().fold;
        if (!kept_.empty() && hides(static_cast<int>(step), -1, results_[step]))
            stack_.back().fold = unseen(stack_.back().fold);
    }

    bool global(int variable) const { return ranges::count(u_.globals, variable, &Global::variable) > 0; }
    void declare(const Instruction& i, std::size_t step) {
        const Fold given = i.b == 1 ? pop().fold : Fold{};
        if (i.b == 2 || outside_.contains(i.a) || (i.b == 0 && global(i.a))) return;
        if (i.b == 1) return give({{}, i.a}, given, step);
        const Type& type = u_.code.variables[at(i.a)];
        Fold zero = constant(true);
        if (type.scalar()) zero.value = 0;
        zero.most = 0;
        if (!kept_.empty() && hides(-1, static_cast<int>(step), zero)) zero = unseen(zero);
        give({{}, i.a}, type.scalar() ? give_number(zero, type.base, 0, true, 0) : zero, step);
    }

    void prefix(const Instruction& i) {
        Fold fold = pop().fold;
        fold.value = i.text == "-" ? -fold.value : std::numeric_limits<double>::quiet_NaN();
        if (i.text != "-" && i.text != "+") fold.zero = true;
        if (fold.sure == Sure::number && i.text == "!")
            give_number(fold, Base::boolean, fold.number == 0 ? 1 : 0, true, fold.from);
        else if (fold.sure == Sure::number && i.text == "-" && fold.base != Base::uinteger)
            fold.number = -fold.number;
        else if (i.text != "+" && fold.sure == Sure::number)
            fold.sure = Sure::anything;
        if (i.text == "~") fold.most = endless;
        push(fold);
    }

    void index() {
        const Fold index = pop().fold;
        const Item of_what = pop();
        Fold fold = both(of_what.fold, index, of_what.fold.zero);
        if (!is_live(of_what.fold)) fold.kind = Kind::constant;  // where the index becomes one
        fold.most = of_what.fold.most;
        fold.from = of_what.fold.from | index.from;
        push(fold, of_what.variable);
        stack_.back().whole = false;
    }

    void infix(const Instruction& i, std::size_t step) {
        const Item right = pop(), left = pop();
        const Fold &a = left.fold, &b = right.fold;
        if (i.text == "/") signs_ |= b.from;
        Fold fold = of_operator(i.text, seen(i.text, a), seen(i.text, b));
        if (same_twice(i.text, left, right, step)) fold = constant(true);
        if (i.text == "&&" || i.text == "||")  // one may be enough
            for (const Fold* one : {&a, &b})
                if (decided(*one)) fold.kind = Kind::constant, fold.zero = true;
        know_operator(fold, i.text, a, b);
        push(fold);
    }

    // Pushes one.
    void value(const Instruction& i, std::size_t step) {
        switch (i.op) {
            case Op::number: {
                Fold fold = constant(i.number == 0);
                fold.value = i.number;
                const Base base = i.type < 0 ? Base::unknown : u_.code.types[at(i.type)].base;
                const bool real = base == Base::real;
                return push(give_number(fold, base, real ? static_cast<float>(i.number) : i.number, true, 0));
            }
            case Op::length:
                pop();
                return push(constant(false));
            case Op::load:
                return push(of(i.a), i.a);
            case Op::unknown:
                return push({});
            case Op::select:
                if (stack_.empty()) return;
                stack_.back().fold.value = std::numeric_limits<double>::quiet_NaN();
                if (stack_.back().fold.sure == Sure::number) stack_.back().fold.sure = Sure::anything;
                stack_.back().whole = false;
                return;
            case Op::prefix:
                return prefix(i);
            case Op::step: {
                const Item item = pop();
                Fold fold = both(item.fold, constant(false), true);
                give({item.fold, item.variable, false}, fold, step);
                return push(both(item.fold, item.fold, true));
            }
            case Op::index:
                return index();
            case Op::infix:
                return infix(i, step);
            case Op::choose:
                return choose(step);
            case Op::construct:
                return construct(i);
            case Op::built_in:
                return built_in(i);
            case Op::call:
                return call(i);
            default:
                return;
        }
    }

    void choose(std::size_t step) {
        const Fold b = pop().fold, a = pop().fold, condition = pop().fold;
        conditions_[step] = condition;
        Fold fold = both(both(a, b, a.zero || b.zero), condition, a.zero || b.zero);
        if (condition.sure == Sure::number) {
            know_either(fold, condition.number != 0 ? a : b, condition.number != 0 ? a : b);
            fold.from |= condition.from;
        } else {
            know_either(fold, a, b);
        }
        const bool told = !is_live(condition) || decided(condition);
        const bool same_arms = !is_live(a) && !is_live(b) && !(a.value < b.value || a.value > b.value);
        if (same_arms || (told && !is_live(either(a, b)))) fold.kind = Kind::constant, fold.zero = a.zero || b.zero;
        push(fold);
    }

    static Fold all_of(const std::vector<Item>& items) {
        Fold all = constant(false);
        bool zero = false;
        double most = 0;
        std::uint64_t from = 0;
        for (const Item& item : items) {
            zero = zero || item.fold.zero;
            all = both(all, item.fold, zero);
            most = std::max(most, item.fold.most);
            from |= item.fold.from;
        }
        all.most = most;
        all.from = from;
        return all;
    }

    void construct(const Instruction& i) {
        const std::vector<Item> given = pop(i.a);
        Fold fold = all_of(given);
        const Type type = i.type < 0 ? Type{} : u_.code.types[at(i.type)];
        for (const Item& item : given)  // one of its components
            if (!is_live(item.fold)) fold.kind = Kind::constant, fold.zero = fold.zero || item.fold.zero;
        fold.base = type.base;
        if (given.size() != 1 || !type.scalar()) return push(fold);
        if (given[0].fold.sure == Sure::nothing) fold.sure = Sure::nothing;
        if (given[0].fold.sure != Sure::number) return push(fold);
        const Fold& a = given[0].fold;
        const bool whole = type.integral();
        const bool between =
            a.exact || std::abs(a.number - std::round(a.number)) > 1e-3 * std::max(1., std::abs(a.number));
        if (type.base == Base::boolean && (a.exact || a.number != 0))
            give_number(fold, type.base, a.number != 0 ? 1 : 0, true, a.from);
        else if (whole ? between : type.base == Base::real)
            give_number(fold, type.base, whole ? std::trunc(a.number) : a.number, a.exact, a.from);
        push(fold);
    }

    void built_in(const Instruction& i) {
        const std::vector<Item> given = pop(i.a);
        Fold result = all_of(given);
        constexpr std::string_view signs[] = {"inversesqrt", "sqrt", "log", "log2", "pow", "atan", "normalize", "mod"};
        if (ranges::count(signs, i.text) > 0 || i.text.find("Bits") != i.text.npos || i.text.starts_with("pack"))
            signs_ |= result.from;
        constexpr std::string_view keep_zero[] = {"abs", "sqrt", "min",     "max",    "clamp",
                                                  "mix", "sign", "radians", "degrees"};
        result.zero = !is_live(result) && (result.zero || ranges::count(keep_zero, i.text) == 0);
        constexpr std::string_view invertible[] = {"sqrt", "inversesqrt", "exp", "exp2", "log", "log2", "pow"};
        result.cancels = ranges::count(invertible, i.text) > 0;
        if (folds(i.text, given)) result.kind = Kind::constant, result.zero = true;
        if (!is_live(result) && given.size() == 1 && !std::isnan(given[0].fold.value))
            compute(i.text, given[0], result);
        result.most = bound(i, given, result.most);
        result.base = i.type < 0 ? Base::unknown : u_.code.types[at(i.type)].base;
        if (ranges::any_of(given, [](const Item& item) { return item.fold.sure == Sure::nothing; }))
            result.sure = Sure::nothing;
        else if (given.size() == 1 && given[0].fold.sure == Sure::number && given[0].fold.exact)
            round(i.text, given[0].fold, result);
        push(result);
    }

    static void round(std::string_view name, const Fold& a, Fold& result) {
        const double x = a.number;
        if (name == "abs") give_number(result, a.base, std::abs(x), true, a.from);
        if (name == "floor") give_number(result, a.base, std::floor(x), true, a.from);
        if (name == "ceil") give_number(result, a.base, std::ceil(x), true, a.from);
    }

    // What no component is larger than, whatever the arguments are within `most`.
    double bound(const Instruction& i, const std::vector<Item>& given, double most) const {
        constexpr std::string_view unit[] = {"sin", "cos", "fract", "step", "sign"};
        constexpr std::string_view within[] = {"abs", "min", "max", "clamp", "radians"};
        if (given.empty() || !(most < largest)) most = endless;
        if (ranges::count(unit, i.text) > 0) return most < endless ? 1 : endless;
        if (ranges::count(within, i.text) > 0) return most;
        if (i.text == "floor" || i.text == "ceil") return most + 1;
        if (i.text == "mix" && given.size() == 3)
            return product(given[0].fold.most + given[1].fold.most, 1 + given[2].fold.most);
        if (i.text == "dot") return 4 * product(given[0].fold.most, given[1].fold.most);
        if (i.text == "cross") return 2 * product(given[0].fold.most, given[1].fold.most);
        if (i.text == "length" || i.text == "distance") return product(most, most) < largest ? 4 * most : endless;
        if (i.text == "smoothstep" && given.size() == 3 && given[0].fold.sure == Sure::number &&
            given[1].fold.sure == Sure::number && apart(given[0].fold, given[1].fold) &&
            given[0].fold.number != given[1].fold.number)
            return most < endless ? 1 : endless;
        // Texels are finite: images with others are mended, and targets hold 8 bits.
        const bool texel =
            i.text.starts_with("texture") && i.text.find("Quer") == i.text.npos && i.text.find("Size") == i.text.npos;
        return texel || i.text.starts_with("texelFetch") ? 65504 : endless;
    }

    // Whether some of the arguments give a number that a driver finds, whatever the others are.
    static bool folds(std::string_view name, const std::vector<Item>& given) {
        constexpr std::string_view products[] = {"dot", "cross", "fma", "outerProduct", "matrixCompMult", "mod", "mix"};
        if (name == "pow") return ranges::any_of(given, [](const Item& item) { return !is_live(item.fold); });
        return ranges::count(products, name) > 0 &&
               ranges::any_of(given, [](const Item& item) { return may_be_zero(item.fold); });
    }
    // Of a number, where the result is surely not 0.
    static void compute(std::string_view name, const Item& given, Fold& result) {
        constexpr std::pair<std::string_view, double (*)(double)> rows[] = {
            {"sin", std::sin},
            {"cos", std::cos},
            {"tan", std::tan},
            {"asin", std::asin},
            {"acos", std::acos},
            {"exp", std::exp},
            {"exp2", std::exp2},
            {"log", std::log},
            {"log2", std::log2},
            {"sqrt", std::sqrt},
            {"radians", [](double x) { return x * 0.017453292519943295; }},
            {"degrees", [](double x) { return x / 0.017453292519943295; }}};
        const auto* row = ranges::find(rows, name, [](const auto& r) { return r.first; });
        if (row == std::end(rows)) return;
        const double value = row->second(given.fold.value);
        if (!std::isfinite(value) || std::abs(value) < 1e-5) return;
        result.value = value;
        result.zero = false;
    }

    void call(const Instruction& i) {
        const std::vector<Item> given = pop(i.a);
        Fold result;
        result.sure = Sure::nothing;
        result.most = 0;
        bool known = false;
        for (std::size_t n = 0; n < u_.functions.size(); ++n) {
            const Function& f = u_.functions[n];
            if (f.name != i.text || f.parameters.size() != given.size()) continue;
            known = known || f.code >= 0;
            for (std::size_t k = 0; k < given.size(); ++k) {
                const int variable = f.parameters[k].variable;
                if (f.parameters[k].storage != Storage::out && variable >= 0) {
                    Fold fold = given[k].fold;
                    fold.base = u_.code.variables[at(variable)].base;
                    if (!u_.code.variables[at(variable)].scalar() && fold.sure == Sure::number)
                        fold.sure = Sure::anything;
                    know(variables_[at(variable)], fold);
                }
                if (f.parameters[k].storage != Storage::in && given[k].variable >= 0) {
                    Fold fold = of(variable);
                    if (!given[k].whole && fold.sure == Sure::number) fold.sure = Sure::anything;
                    count_[at(given[k].variable)] += 2;
                    know(variables_[at(given[k].variable)], fold);
                }
            }
            if (const auto found = results_of_.find(n); found != results_of_.end())
                result = either(result, found->second);
        }
        push(known ? result : bounded(endless, all_of(given).from));
    }

    std::size_t function_at(std::size_t step) const {
        for (std::size_t n = 0; n < u_.functions.size(); ++n) {
            const Function& f = u_.functions[n];
            if (f.code >= 0 && step >= at(f.code) && step < at(f.code_end)) return n;
        }
        return u_.functions.size();
    }
    void know_result(std::size_t step, Fold fold) {
        const std::size_t n = function_at(step);
        if (n == u_.functions.size()) return;
        fold.base = u_.functions[n].result.base;
        const auto [known, fresh] = results_of_.try_emplace(n, fold);
        if (fresh)
            changed_ = true;
        else
            know(known->second, fold);
    }

    const Unit& u_;
    std::vector<Fold> variables_;  // by Code::variables
    std::vector<Fold> results_;    // by instruction, as of the last round
    std::vector<Fold> begun_;      // variables_ before the first round
    std::vector<int> given_;       // by Code::variables: how often it is given something; 2: often
    std::vector<int> count_;       // the same, of this round so far
    std::vector<bool> hidden_;     // by Unit::marks
    std::vector<Item> stack_;
    std::set<int> outside_;                   // variables whose values come from outside
    std::map<std::size_t, int> targets_;      // by instruction: the variable that it gives something to
    std::map<std::size_t, Fold> conditions_;  // of Op::choose
    std::map<std::size_t, Fold> results_of_;  // by Unit::functions
    std::uint64_t signs_ = 0;
    std::map<int, std::vector<std::size_t>> kept_;  // by instruction: marks of its result; -1: of zeros
    bool changed_ = false, in_order_ = false, choosing_ = false;
    int rounds_ = 0;
    std::size_t begin_ = 0;  // the least of the items that the instruction took
};

// Of a stage whose code is whole. `hidden`: the marks that are written as calls, of Unit::marks; null: not known yet.
Follower followed(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                  std::map<std::string_view, Fold>& passed, const std::vector<bool>* hidden = nullptr) {
    Follower follower(unit);
    if (hidden) follower.hide(*hidden);
    for (const Global& g : unit.globals) {
        const Storage storage = g.qualifiers.storage;
        const auto& known = storage == Storage::uniform ? settled : passed;
        if (storage != Storage::uniform && storage != Storage::in && storage != Storage::buffer) continue;
        const auto found = known.find(g.name);
        follower.come_from_outside(g.variable, found == known.end() ? Fold{} : found->second);
    }
    follower.follow();
    passed.clear();
    for (const Global& g : unit.globals) {
        if (g.qualifiers.storage != Storage::out) continue;
        Fold& fold = passed[g.name] = follower.of(g.variable);
        fold.sure = Sure::anything;  // but for rounding
    }
    return follower;
}

std::string text_of(const Fold& fold) {
    if (fold.base == Base::boolean) return fold.number != 0 ? "true" : "false";
    if (fold.base == Base::real) {
        std::string text = real_text(static_cast<float>(fold.number));
        return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
    }
    return std::to_string(static_cast<std::int64_t>(fold.number)) + (fold.base == Base::uinteger ? "u" : "");
}

// What is kept does not depend on the values of uniforms, so that all forms of a program compute the same: where one of
// `free` could decide anything, what a driver could follow if it were a constant. Nothing can be decided where that
// can't be written.
struct Kept {
    bool possible = false;
    std::vector<bool> stay;  // by Unit::marks
};

Kept kept(const Unit& unit, const std::map<std::string_view, Fold>& free) {
    Kept out{false, std::vector<bool>(unit.marks.size())};
    std::map<std::string_view, Fold> nothing_passed;
    Follower follower = followed(unit, free, nothing_passed);
    const auto constant = [&](int step) { return step < 0 || !is_live(follower.result(step)); };
    out.possible = ranges::any_of(unit.marks, [&](const Mark& mark) {
        const bool decides = mark.kind == Mark::Kind::decision || mark.kind == Mark::Kind::weight;
        return decides && mark.step >= 0 && follower.result(mark.step).from != 0;
    });
    out.possible = out.possible && follower.hide();
    for (std::size_t n = 0; out.possible && n < unit.marks.size(); ++n) {
        const Mark& mark = unit.marks[n];
        if (mark.kind == Mark::Kind::divisor) {
            const Base base = follower.result(mark.step).base;
            out.stay[n] = constant(mark.step) && (base == Base::integer || base == Base::uinteger);
        }
        if (mark.kind != Mark::Kind::kept) continue;
        out.stay[n] = mark.step < 0 ? mark.one < 0 || follower.one_of_several(mark.one) : follower.hidden()[n];
        if (out.stay[n] && mark.last < 0) return {false, std::vector<bool>(unit.marks.size())};
    }
    return out;
}

class Decider {
public:
    Decider(const Unit& unit, const Follower& follower, std::uint64_t signs)
        : u_(unit), follower_(follower), signs_(signs) {
        out_.text.resize(u_.marks.size());
    }
    Decided run(const Kept& kept) {
        out_.stay = kept.stay;
        out_.possible = kept.possible;
        for (std::size_t n = 0; kept.possible && n < u_.marks.size(); ++n) decide(n);
        return std::move(out_);
    }

private:
    const Fold& of(int step) const { return follower_.result(step); }
    void write(std::size_t n, const Fold& fold) {
        out_.stay[n] = true;
        out_.text[n] = text_of(fold);
        out_.from |= fold.from;
    }
    // What a compiler folds in every form is left to it.
    bool finite(int step) const { return step >= 0 && number(step) && is_live(of(step)); }
    // mix(a, b, 0) is a + 0 * (b - a), which is not a if a is infinite.
    bool number(int step) const { return of(step).most < largest; }
    void decide(std::size_t n) {
        const Mark& mark = u_.marks[n];
        const Fold none;
        const Fold& fold = mark.step < 0 ? none : of(mark.step);
        const bool known = fold.sure == Sure::number && fold.from != 0;
        if (mark.kind == Mark::Kind::decision && known && (fold.base != Base::real || fold.exact)) write(n, fold);
        if (mark.kind == Mark::Kind::weight && known && fold.exact && (fold.from & signs_) == 0 &&
            ((fold.number == 0 && finite(mark.one) && (mark.other < 0 || number(mark.other))) ||
             (fold.number == 1 && finite(mark.other)))) {
            write(n, fold);
            for (const int step : {mark.one, mark.other})
                if (step >= 0 && (fold.number == 0 || step == mark.other)) out_.from |= of(step).from;
        }
        if (mark.kind == Mark::Kind::product)
            out_.stay[n] =
                out_.stay[static_cast<std::size_t>(mark.one)] || out_.stay[static_cast<std::size_t>(mark.other)];
    }

    const Unit& u_;
    const Follower& follower_;
    const std::uint64_t signs_;
    Decided out_;
};

}  // namespace

Fold free_number(Base base) {
    Fold fold = constant(false);
    fold.base = base;
    fold.from = 1;
    return fold;
}

Fold bounded(double most, std::uint64_t from) {
    Fold fold;
    fold.most = most;
    fold.from = from;
    return fold;
}

Fold settled_number(Base base, double value, std::uint64_t from) {
    // As the uniform holds it.
    const double held = base == Base::boolean ? (std::abs(value) >= 1 ? 1 : 0)
                        : base == Base::real  ? static_cast<double>(static_cast<float>(value))
                                              : std::trunc(value);
    Fold fold = bounded(std::abs(held), from);
    return std::signbit(value) && value == 0 ? fold : give_number(fold, base, held, true, from);
}

std::string number_text(Base base, double value) {
    const Fold fold = settled_number(base, value, 0);
    return fold.sure == Sure::number ? text_of(fold) : "";
}

std::uint64_t signs(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                    std::map<std::string_view, Fold>& passed) {
    if (unit.code.whole) return followed(unit, settled, passed).signs();
    passed.clear();
    std::uint64_t all = 0;
    for (const auto& [name, fold] : settled) all |= fold.from;
    return all;
}

Decided decide(const Unit& unit, const std::map<std::string_view, Fold>& settled,
               const std::map<std::string_view, Fold>& free, std::uint64_t signs,
               std::map<std::string_view, Fold>& passed) {
    if (!unit.code.whole) {
        passed.clear();
        Decided out;
        for (const Mark& mark : unit.marks) out.stay.push_back(mark.number && mark.known);
        out.text.resize(out.stay.size());
        return out;
    }
    const Kept known = kept(unit, free);
    Follower follower = followed(unit, settled, passed, &known.stay);
    Decided out = Decider(unit, follower, signs).run(known);
    if (ranges::count(unit.marks, Mark::Kind::divisor, &Mark::kind) == 0) return out;
    follower.follow_in_order();
    for (std::size_t n = 0; n < out.stay.size(); ++n) {
        const Mark& mark = unit.marks[n];
        if (mark.kind != Mark::Kind::divisor) continue;
        const Fold& fold = follower.result(mark.step);
        if (!is_live(fold) && fold.zero) out.stay[n] = true;
    }
    return out;
}

}  // namespace snell::glsl::folding
