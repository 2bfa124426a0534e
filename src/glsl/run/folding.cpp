// Constants are followed through the code of a stage without regard to the order of its statements: a variable may be
// constant if one of its assignments is.
#include "src/glsl/run/folding.h"

#include <algorithm>

namespace snell::glsl::run {

namespace {

struct Item {
    Fold fold = Fold::live;
    int variable = -1;
};

Fold both(Fold a, Fold b) { return a == Fold::live || b == Fold::live ? Fold::live : std::max(a, b); }
// Zero times anything is zero.
Fold product(Fold a, Fold b) { return std::max(a, b) == Fold::settled ? Fold::settled : both(a, b); }
Fold of_operator(std::string_view op, Fold a, Fold b) { return op == "*" ? product(a, b) : both(a, b); }

class Follower {
public:
    explicit Follower(const Unit& unit) : u_(unit), variables_(unit.code.variables.size(), Fold::live) {}

    void know(int variable, Fold fold) {
        if (variable < 0 || variables_[at(variable)] >= fold) return;
        variables_[at(variable)] = fold;
        changed_ = true;
    }
    Fold of(int variable) const { return variable < 0 ? Fold::live : variables_[at(variable)]; }

    void follow() {
        do {
            changed_ = false;
            stack_.clear();
            for (std::size_t step = 0; step < u_.code.steps.size(); ++step) take(u_.code.steps[step], step);
        } while (changed_);
    }
    // Of an instruction with two operands.
    Fold operand(int step, int n) const {
        const auto found = operands_.find(at(step));
        return found == operands_.end() ? Fold::settled : found->second[at(n)];
    }

private:
    static std::size_t at(int n) { return static_cast<std::size_t>(n); }

    Item pop() {
        if (stack_.empty()) return {};
        const Item item = stack_.back();
        stack_.pop_back();
        return item;
    }
    void push(Fold fold, int variable = -1) { stack_.push_back({fold, variable}); }
    std::vector<Item> pop(int count) {
        std::vector<Item> items(at(count));
        for (auto item = items.rbegin(); item != items.rend(); ++item) *item = pop();
        return items;
    }

    void take(const Instruction& i, std::size_t step) {
        switch (i.op) {
            case Op::number:
            case Op::length:
                if (i.op == Op::length) pop();
                return push(Fold::constant);
            case Op::load:
                return push(of(i.a), i.a);
            case Op::unknown:
                return push(Fold::live);
            case Op::select:
                return;
            case Op::prefix:
                return push(pop().fold);
            case Op::step: {
                const Item item = pop();
                return push(item.fold);
            }
            case Op::index: {
                const Fold index = pop().fold;
                const Item of_what = pop();
                return push(both(of_what.fold, index), of_what.variable);
            }
            case Op::infix: {
                const Fold b = pop().fold, a = pop().fold;
                operands_[step] = {a, b};
                return push(of_operator(i.text, a, b));
            }
            case Op::choose: {
                const Fold b = pop().fold, a = pop().fold, condition = pop().fold;
                const bool may =
                    std::max(a, b) == Fold::settled || (condition == Fold::settled && std::max(a, b) != Fold::live);
                return push(may ? Fold::settled : both(both(a, b), condition));
            }
            case Op::assign: {
                const Item given = pop(), target = pop();
                operands_[step] = {target.fold, given.fold};
                const Fold fold =
                    i.text.size() == 1 ? given.fold : of_operator(i.text.substr(0, 1), target.fold, given.fold);
                know(target.variable, fold);
                return push(fold);
            }
            case Op::declare:
                if (i.b == 1) know(i.a, pop().fold);
                return;
            case Op::drop:
            case Op::unless:
                pop();
                return;
            case Op::back:
                if (i.a) know_result(step, pop().fold);
                return;
            case Op::construct:
                return push(all_of(pop(i.a), true));
            case Op::built_in:
                return built_in(i, step);
            case Op::call:
                return call(i);
            case Op::jump:
            case Op::discard:
                return;
        }
    }

    // `any`: one that is settled is enough.
    static Fold all_of(const std::vector<Item>& items, bool any = false) {
        Fold all = Fold::constant, most = Fold::live;
        for (const Item& item : items) {
            all = both(all, item.fold);
            most = std::max(most, item.fold);
        }
        return any && most == Fold::settled ? most : all;
    }

    void built_in(const Instruction& i, std::size_t step) {
        const std::vector<Item> given = pop(i.a);
        if (given.size() == 2) operands_[step] = {given[0].fold, given[1].fold};
        if (i.text == "dot" || i.text == "cross" || i.text == "matrixCompMult") return push(all_of(given, true));
        if (i.text == "mix" && given.size() == 3 && given[2].fold == Fold::settled) return push(Fold::settled);
        push(all_of(given));
    }

    void call(const Instruction& i) {
        const std::vector<Item> given = pop(i.a);
        Fold result = Fold::live;
        for (std::size_t n = 0; n < u_.functions.size(); ++n) {
            const Function& f = u_.functions[n];
            if (f.name != i.text || f.parameters.size() != given.size()) continue;
            for (std::size_t k = 0; k < given.size(); ++k) {
                if (f.parameters[k].storage != Storage::out) know(f.parameters[k].variable, given[k].fold);
                if (f.parameters[k].storage != Storage::in) know(given[k].variable, of(f.parameters[k].variable));
            }
            if (const auto known = results_.find(n); known != results_.end()) result = std::max(result, known->second);
        }
        push(result);
    }

    void know_result(std::size_t step, Fold fold) {
        for (std::size_t n = 0; n < u_.functions.size(); ++n) {
            const Function& f = u_.functions[n];
            if (f.code < 0 || step < at(f.code) || step >= at(f.code_end) || results_[n] >= fold) continue;
            results_[n] = fold;
            changed_ = true;
        }
    }

    const Unit& u_;
    std::vector<Fold> variables_;  // by Code::variables
    std::vector<Item> stack_;
    std::map<std::size_t, std::array<Fold, 2>> operands_;  // by instruction, as of the last round
    std::map<std::size_t, Fold> results_;                  // by Unit::functions
    bool changed_ = false;
};

}  // namespace

std::vector<bool> marks_that_stay(const Unit& unit, const std::set<std::string_view>& settled,
                                  std::map<std::string_view, Fold>& passed) {
    if (!unit.code.whole) {
        passed.clear();
        return std::vector<bool>(unit.marks.size(), true);
    }
    Follower follower(unit);
    for (const Global& g : unit.globals) {
        if (g.qualifiers.storage == Storage::uniform && settled.contains(g.name))
            follower.know(g.variable, Fold::settled);
        if (g.qualifiers.storage != Storage::in) continue;
        if (const auto known = passed.find(g.name); known != passed.end()) follower.know(g.variable, known->second);
    }
    follower.follow();
    passed.clear();
    for (const Global& g : unit.globals)
        if (g.qualifiers.storage == Storage::out) passed[g.name] = follower.of(g.variable);
    std::vector<bool> stay;
    for (const Mark& mark : unit.marks)
        stay.push_back(follower.operand(mark.step, mark.operand) == Fold::settled ||
                       (mark.call >= 0 && follower.operand(mark.step, 1) == Fold::settled));
    return stay;
}

}  // namespace snell::glsl::run
