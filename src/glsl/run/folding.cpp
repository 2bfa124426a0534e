// Constants are followed through the code of a stage without regard to the order of its statements: a variable may be
// constant if one of its assignments is.
#include "src/glsl/run/folding.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "parser/text/ranges.h"

namespace snell::glsl::run {

namespace {

using Kind = Fold::Kind;

struct Item {
    Fold fold;
    int variable = -1;
    bool whole = true;  // not an element or a member of the variable
};

bool is_live(const Fold& a) { return a.kind == Kind::live; }
bool is_settled(const Fold& a) { return a.kind == Kind::settled; }

// Uniforms and numbers take part in what is computed, whether it is constant or not.
Fold with(Fold fold, const Fold& a, const Fold& b) {
    fold.from = a.from | b.from;
    fold.gain = std::max(a.gain, b.gain);
    return fold;
}

Fold both(const Fold& a, const Fold& b, bool zero) {
    if (is_live(a) || is_live(b)) return with({}, a, b);
    return with({std::max(a.kind, b.kind), zero}, a, b);
}

// A difference of floats may be 0 where one of doubles is not.
bool vanishes(double value, double a, double b) {
    return !std::isfinite(value) || std::abs(value) <= 1e-5 * std::max(std::abs(a), std::abs(b));
}

Fold of_operator(std::string_view op, const Fold& a, const Fold& b) {
    // Zero times anything is zero.
    if (op == "*" && ((is_settled(a) && a.zero) || (is_settled(b) && b.zero))) return with({Kind::settled, true}, a, b);
    Fold result = both(a, b, op == "*" ? a.zero || b.zero : op == "/" ? a.zero : true);
    if (is_live(result) || std::isnan(a.value) || std::isnan(b.value) || op.size() != 1) return result;
    result.value = op == "+"   ? a.value + b.value
                   : op == "-" ? a.value - b.value
                   : op == "*" ? a.value * b.value
                   : op == "/" ? a.value / b.value
                               : result.value;
    if (op == "+" || op == "-") result.zero = vanishes(result.value, a.value, b.value);
    return result;
}

// One of them, nobody knows which.
Fold either(const Fold& a, const Fold& b) {
    if (is_live(a) && is_live(b)) return with({}, a, b);  // nothing else is known, so that rounds come to an end
    if (is_live(a) || is_live(b)) return with(is_live(a) ? b : a, a, b);
    Fold one{std::max(a.kind, b.kind), a.zero || b.zero};
    if (a.value == b.value) one.value = a.value;
    return with(one, a, b);
}

constexpr double much = 1000;  // rounding errors become a thousand times as large

class Follower {
public:
    explicit Follower(const Unit& unit) : u_(unit), variables_(unit.code.variables.size()) {}

    void know(int variable, const Fold& fold) {
        if (variable >= 0) know(variables_[at(variable)], fold);
    }
    Fold of(int variable) const { return variable < 0 ? Fold{} : variables_[at(variable)]; }

    void follow() {
        do {
            changed_ = false;
            stack_.clear();
            for (std::size_t step = 0; step < u_.code.steps.size(); ++step) take(u_.code.steps[step], step);
        } while (changed_);
    }
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
            if (g.qualifiers.storage == Storage::uniform || g.qualifiers.storage == Storage::in) keep(g.variable);
        variables_ = std::move(first);
        in_order_ = true;
        stack_.clear();
        for (std::size_t step = 0; step < u_.code.steps.size(); ++step) take(u_.code.steps[step], step);
    }
    // Uniforms in places where nearly the same number gives another result.
    std::uint64_t touchy() const { return touchy_; }
    // Of an instruction with two operands.
    Fold operand(int step, int n) const {
        const auto found = operands_.find(at(step));
        return found == operands_.end() ? Fold{Kind::settled, true} : found->second[at(n)];
    }

private:
    void know(Fold& known, const Fold& fold) {
        const Fold now = either(known, fold);
        const bool same = now.value == known.value || (std::isnan(now.value) && std::isnan(known.value));
        changed_ = changed_ || now.kind != known.kind || now.zero != known.zero || !same || now.from != known.from ||
                   now.gain != known.gain;
        known = now;
    }
    // What a variable is given as a whole takes the place of what it was.
    void give(const Item& target, const Fold& fold) {
        if (in_order_ && target.whole && target.variable >= 0)
            variables_[at(target.variable)] = fold;
        else
            know(target.variable, fold);
    }
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    Item pop() {
        if (stack_.empty()) return {};
        const Item item = stack_.back();
        stack_.pop_back();
        return item;
    }
    void push(const Fold& fold, int variable = -1) { stack_.push_back({fold, variable}); }
    std::vector<Item> pop(int count) {
        std::vector<Item> items(at(count));
        for (auto item = items.rbegin(); item != items.rend(); ++item) *item = pop();
        return items;
    }

    void take(const Instruction& i, std::size_t step) {
        switch (i.op) {
            case Op::assign: {
                const Item given = pop(), target = pop();
                operands_[step] = {target.fold, given.fold};
                const Fold fold =
                    i.text.size() == 1 ? given.fold : of_operator(i.text.substr(0, 1), target.fold, given.fold);
                give(target, fold);
                return push(fold);
            }
            case Op::declare:
                if (i.b == 1) give({{}, i.a}, pop().fold);
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
                return value(i, step);
        }
    }

    // Pushes one.
    void value(const Instruction& i, std::size_t step) {
        switch (i.op) {
            case Op::number:
                return push({Kind::constant, i.number == 0, i.number, 0, std::abs(i.number)});
            case Op::length:
                pop();
                return push({Kind::constant, false, std::numeric_limits<double>::quiet_NaN(), 0, 0});
            case Op::load:
                return push(of(i.a), i.a);
            case Op::unknown:
                return push({});
            case Op::select:
                if (stack_.empty()) return;
                stack_.back().fold.value = std::numeric_limits<double>::quiet_NaN();
                stack_.back().whole = false;
                return;
            case Op::prefix: {
                Fold fold = pop().fold;
                fold.value = i.text == "-" ? -fold.value : std::numeric_limits<double>::quiet_NaN();
                if (i.text != "-" && i.text != "+") fold.zero = true;
                return push(fold);
            }
            case Op::step: {
                const Item item = pop();
                know(item.variable, both(item.fold, {Kind::constant, false}, true));
                return push(both(item.fold, item.fold, true));
            }
            case Op::index: {
                const Fold index = pop().fold;
                const Item of_what = pop();
                if (!inside(index, of_what)) touchy_ |= index.from;
                push(both(of_what.fold, index, of_what.fold.zero), of_what.variable);
                stack_.back().whole = false;
                return;
            }
            case Op::infix: {
                const Fold b = pop().fold, a = pop().fold;
                operands_[step] = {a, b};
                if (i.text == "==" || i.text == "!=") touch({{a}, {b}});
                return push(of_operator(i.text, a, b));
            }
            case Op::choose:
                return choose();
            case Op::construct: {
                const std::vector<Item> given = pop(i.a);
                if (i.type >= 0 && u_.code.types[at(i.type)].integral()) touch(given);
                return push(all_of(given, true));
            }
            case Op::built_in:
                return built_in(i, step);
            case Op::call:
                return call(i);
            default:
                return;
        }
    }

    void choose() {
        const Fold b = pop().fold, a = pop().fold, condition = pop().fold;
        const Fold one = either(a, b);
        const bool may = is_settled(one) || (is_settled(condition) && !is_live(one));
        if (may) return push(with({Kind::settled, one.zero}, one, condition));
        push(both(both(a, b, one.zero), condition, one.zero));
    }

    // Whether the index is known to be one of an element.
    bool inside(const Fold& index, const Item& of_what) const {
        if (of_what.variable < 0 || !of_what.whole || is_live(index)) return false;
        const Type& type = u_.code.variables[at(of_what.variable)];
        const int elements = type.dims > 0 ? type.size : type.cols > 1 ? type.cols : type.rows;
        return index.value >= 0 && index.value < elements;
    }

    // Where constants meet what differs between pixels, compilers may multiply and add in another order.
    void touch(const std::vector<Item>& given) {
        for (const Item& item : given)
            if (is_live(item.fold)) touchy_ |= item.fold.from;
    }

    // `any`: one that is settled is enough.
    static Fold all_of(const std::vector<Item>& items, bool any = false) {
        Fold all{Kind::constant, false}, one;
        for (const Item& item : items) {
            one = either(one, item.fold);
            all = both(all, item.fold, one.zero);
        }
        return any && is_settled(one) ? one : all;
    }

    void built_in(const Instruction& i, std::size_t step) {
        const std::vector<Item> given = pop(i.a);
        constexpr std::string_view jumps[] = {
            "fract", "floor", "ceil", "round",          "roundEven",       "trunc",       "mod",
            "modf",  "sign",  "step", "floatBitsToInt", "floatBitsToUint", "packHalf2x16"};
        constexpr std::string_view waves[] = {"sin", "cos", "tan"};
        const bool wave = ranges::count(waves, i.text) > 0 && !given.empty() && given[0].fold.gain >= much;
        if (wave || ranges::count(jumps, i.text) > 0) touch(given);
        if (given.size() == 2) operands_[step] = {given[0].fold, given[1].fold};
        if (i.text == "dot" || i.text == "cross" || i.text == "matrixCompMult") return push(all_of(given, true));
        Fold result = all_of(given);
        if (i.text == "mix" && given.size() == 3 && is_settled(given[2].fold)) {  // it may be the first or the second
            result = either(given[0].fold, given[1].fold);
            if (!is_live(result)) result.kind = Kind::settled;
            result = with(result, result, given[2].fold);
        }
        constexpr std::string_view keep_zero[] = {"abs", "sqrt", "min",     "max",    "clamp",
                                                  "mix", "sign", "radians", "degrees"};
        result.zero = !is_live(result) && (result.zero || ranges::count(keep_zero, i.text) == 0);
        if (!is_live(result) && given.size() == 1 && !std::isnan(given[0].fold.value))
            compute(i.text, given[0], result);
        push(result);
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
        for (std::size_t n = 0; n < u_.functions.size(); ++n) {
            const Function& f = u_.functions[n];
            if (f.name != i.text || f.parameters.size() != given.size()) continue;
            for (std::size_t k = 0; k < given.size(); ++k) {
                if (f.parameters[k].storage != Storage::out) know(f.parameters[k].variable, given[k].fold);
                if (f.parameters[k].storage != Storage::in) know(given[k].variable, of(f.parameters[k].variable));
            }
            if (const auto known = results_.find(n); known != results_.end()) result = either(result, known->second);
        }
        push(result);
    }

    void know_result(std::size_t step, const Fold& fold) {
        for (std::size_t n = 0; n < u_.functions.size(); ++n) {
            const Function& f = u_.functions[n];
            if (f.code < 0 || step < at(f.code) || step >= at(f.code_end)) continue;
            know(results_[n], fold);
        }
    }

    const Unit& u_;
    std::vector<Fold> variables_;  // by Code::variables
    std::vector<Item> stack_;
    std::map<std::size_t, std::array<Fold, 2>> operands_;  // by instruction, as of the last round
    std::map<std::size_t, Fold> results_;                  // by Unit::functions
    std::uint64_t touchy_ = 0;
    bool changed_ = false, in_order_ = false;
};

}  // namespace

namespace {

// Of a stage whose code is whole.
Follower followed(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                  std::map<std::string_view, Fold>& passed) {
    Follower follower(unit);
    for (const Global& g : unit.globals) {
        const auto& known = g.qualifiers.storage == Storage::uniform ? settled : passed;
        if (g.qualifiers.storage != Storage::uniform && g.qualifiers.storage != Storage::in) continue;
        if (const auto found = known.find(g.name); found != known.end()) follower.know(g.variable, found->second);
    }
    follower.follow();
    passed.clear();
    for (const Global& g : unit.globals)
        if (g.qualifiers.storage == Storage::out) passed[g.name] = follower.of(g.variable);
    return follower;
}

}  // namespace

std::uint64_t touchy(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                     std::map<std::string_view, Fold>& passed) {
    if (unit.code.whole) return followed(unit, settled, passed).touchy();
    passed.clear();
    return 0;
}

std::vector<bool> marks_that_stay(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                                  std::map<std::string_view, Fold>& passed) {
    if (!unit.code.whole) {
        passed.clear();
        std::vector<bool> stay;
        for (const Mark& mark : unit.marks) stay.push_back(mark.number ? mark.known : !settled.empty());
        return stay;
    }
    Follower follower = followed(unit, settled, passed);
    const auto stays = [&](const Mark& mark) {
        const Fold fold = follower.operand(mark.step, mark.operand),
                   other = follower.operand(mark.step, 1 - mark.operand);
        if (mark.both && is_settled(other)) return true;
        return is_settled(fold) && (fold.zero || mark.function != divisor_mark);
    };
    std::vector<bool> stay;
    ranges::transform(unit.marks, std::back_inserter(stay), stays);
    if (ranges::count(unit.marks, divisor_mark, &Mark::function) == 0) return stay;
    follower.follow_in_order();
    for (std::size_t n = 0; n < stay.size(); ++n) {
        const Fold fold = follower.operand(unit.marks[n].step, unit.marks[n].operand);
        if (unit.marks[n].function == divisor_mark && fold.kind == Kind::constant && fold.zero) stay[n] = true;
    }
    return stay;
}

}  // namespace snell::glsl::run
