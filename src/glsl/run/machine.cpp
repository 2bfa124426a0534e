// Steps, variables and calls.
#include "src/glsl/run/machine.h"

#include <algorithm>

#include "parser/text/ranges.h"

namespace snell::glsl::run {

int count(const Unit& unit, const Type& type) {
    constexpr int most = 4096;
    if (type.dims > 1 || (type.dims == 1 && type.size <= 0)) return 0;
    int one = 0;
    if (type.base == Base::structure && type.structure >= 0) {
        for (const Member& m : unit.structure(type).members) {
            const bool inside_itself = m.type.structure >= type.structure;  // an error of the text
            const int size = inside_itself ? 0 : count(unit, m.type);
            if (size == 0 || size > most - one) return 0;
            one += size;
        }
    } else if (type.base != Base::unknown && type.base != Base::none) {
        one = type.rows * type.cols;
    }
    const std::int64_t all = static_cast<std::int64_t>(one) * (type.dims ? type.size : 1);
    return all > most ? 0 : static_cast<int>(all);
}

Type shape(Base base, int rows, int cols) {
    Type type;
    type.base = base;
    type.rows = static_cast<std::uint8_t>(rows);
    type.cols = static_cast<std::uint8_t>(cols);
    return type;
}

Type unknown_type() { return {}; }

double* Arena::take(std::size_t size) {
    for (; at_.block < blocks_.size(); ++at_.block, at_.used = 0)
        if (at_.used + size <= blocks_[at_.block].size) {
            at_.used += size;
            return blocks_[at_.block].data.get() + at_.used - size;
        }
    const std::size_t whole = std::max(size, std::size_t{2048} << std::min<std::size_t>(blocks_.size(), 8));
    // Not by make_unique_for_overwrite, which libc++ lacks before version 16.
    blocks_.push_back({std::unique_ptr<double[]>(new double[whole]), whole});
    at_.used = size;
    return blocks_.back().data.get();
}

Machine::Machine(const Unit& unit) : u_(unit), functions_(unit.code.steps.size()), operators_(unit.code.steps.size()) {
    for (const Type& type : u_.code.variables) {
        Variable v;
        v.size = std::max(count(u_, type), 1);
        variables_.push_back(std::move(v));
    }
}

void Machine::set(int n, int lanes, const std::function<double(int k, int lane)>& value) {
    Variable& v = variable(n);
    v.lanes = lanes;
    v.data.resize(static_cast<std::size_t>(v.size) * static_cast<std::size_t>(lanes));
    for (int k = 0; k < v.size; ++k)
        for (int l = 0; l < lanes; ++l) v.data[static_cast<std::size_t>(k * lanes + l)] = value(k, l);
}

Machine::End Machine::run(int lanes, int neighbour, std::uint64_t& alive, int& budget) {
    lanes_ = lanes;
    neighbour_ = neighbour;
    arena_.release({});
    alive_ = &alive;
    budget_ = &budget;
    end_ = End::running;
    stack_.clear();
    calling_.clear();
    statement_ = {};
    statement_stack_ = 0;
    execute(0);
    const auto main = ranges::find_if(u_.functions, [](const Function& f) { return f.name == "main" && f.code >= 0; });
    if (main == u_.functions.end()) return End::unknown;
    if (end_ == End::running) execute(main->code);
    stop(End::done);
    return end_;
}

void Machine::execute(int from) {
    const auto end = static_cast<int>(u_.code.steps.size());
    for (int at = from; at >= 0 && at < end && end_ == End::running;) {
        if (--*budget_ < 0) return stop(End::unknown);
        const Instruction& i = u_.code.steps[static_cast<std::size_t>(at++)];
        step(i, at);
    }
}

Value Machine::pop() {
    if (stack_.size() <= statement_stack_) {
        stop(End::unknown);
        return unknown(unknown_type());
    }
    const Value v = stack_.back();
    stack_.pop_back();
    return v;
}

Value Machine::make(const Type& type, int size, int lanes) {
    Value v;
    v.type = type;
    v.size = size;
    v.lanes = lanes;
    v.data = arena_.take(static_cast<std::size_t>(size) * static_cast<std::size_t>(lanes));
    return v;
}

Value Machine::unknown(const Type& type) {
    Value v = make(type, std::max(count(u_, type), 1), 1);
    std::fill_n(v.data, v.size, nothing);
    return v;
}

Value Machine::load(int n) {
    Variable& from = variable(n);
    Value v;
    v.type = type_of(n);
    v.size = from.size;
    v.lanes = from.lanes;
    v.data = from.data.data();
    v.variable = n;
    if (v.size > 16) return v;  // nothing assigns it while an expression reads an element
    v.data = arena_.take(from.data.size());
    ranges::copy(from.data, v.data);
    return v;
}

void Machine::begin(int n, double number) {
    Variable& to = variable(n);
    if (to.given) return;
    if (count(u_, type_of(n)) == 0) number = nothing;
    to.lanes = 1;
    to.data.assign(static_cast<std::size_t>(to.size), number);
}

void Machine::declare(int n, const Value& value) {
    Variable& to = variable(n);
    if (to.given) return;
    const Value v = converted(value, type_of(n));
    if (v.size != to.size) return set(n, 1, [](int, int) { return nothing; });
    to.lanes = v.lanes;
    to.data.assign(v.data, v.data + v.size * v.lanes);
}

void Machine::store(const Value& target, const Value& given) {
    if (target.variable < 0) return stop(End::unknown);
    Variable& to = variable(target.variable);
    const Value v = converted(given, target.type);
    if (target.lost || v.size != target.size) return set(target.variable, 1, [](int, int) { return nothing; });
    if (v.lanes > to.lanes) {
        std::vector<double> wide(static_cast<std::size_t>(to.size) * static_cast<std::size_t>(lanes_));
        for (std::size_t k = 0; k < wide.size(); ++k) wide[k] = to.data[k / static_cast<std::size_t>(lanes_)];
        to.data = std::move(wide);
        to.lanes = lanes_;
    }
    for (int k = 0; k < v.size; ++k) {
        const int place = target.first + (target.swizzled ? target.at[static_cast<std::size_t>(k)] : k);
        for (int l = 0; l < to.lanes; ++l) to.data[static_cast<std::size_t>(place * to.lanes + l)] = v.get(k, l);
    }
}

bool Machine::is_true(const Value& condition) {
    const double base = condition.get(0, 0);
    if (std::isnan(base)) stop(End::unknown);
    for (int l = 1; l < condition.lanes; ++l) {
        const double other = condition.get(0, l);
        if (std::isnan(other) || (other != 0) != (base != 0)) *alive_ &= ~(std::uint64_t{1} << l);
    }
    return base != 0;
}

void Machine::step(const Instruction& i, int& at) {
    switch (i.op) {
        case Op::declare: {
            if (i.b != 1) return begin(i.a, i.b == 0 ? 0. : nothing);
            const Value v = pop();
            declare(i.a, v);
            return end_statement();
        }
        case Op::drop:
            pop();
            return end_statement();
        case Op::jump:
            at = i.a;
            return;
        case Op::unless:
            if (!is_true(pop())) at = i.a;
            return end_statement();
        case Op::back:
            result_.reset();
            if (i.a) result_ = pop();
            at = -1;
            return;
        case Op::discard:
            return stop(End::discarded);
        case Op::call:
        case Op::built_in:
            return call(i);
        default:
            return evaluate(i);
    }
}

void Machine::evaluate(const Instruction& i) {
    const auto type = [&] { return i.type < 0 ? unknown_type() : u_.code.types[static_cast<std::size_t>(i.type)]; };
    switch (i.op) {
        case Op::number:
            return push(constant(type(), i.number));
        case Op::load:
            return push(load(i.a));
        case Op::select:
            return push(select(pop(), i.text));
        case Op::index: {
            const Value index = pop();
            return push(element(pop(), index));
        }
        case Op::length: {
            const Type of = pop().type;
            const int rows = of.cols > 1 ? of.cols : of.rows, known = of.dims == 0 ? rows : of.dims == 1 ? of.size : -1;
            return push(constant(shape(Base::integer), known > 0 ? known : nothing));
        }
        case Op::prefix:
            return push(prefix(i.text, pop()));
        case Op::step: {
            Value old = pop(), now = infix(i, i.text.substr(0, 1), old, constant(shape(Base::integer), 1));
            store(old, now);
            old.variable = now.variable = -1;
            return push(i.a ? old : now);
        }
        case Op::infix: {
            const Value b = pop(), a = pop();
            return push(infix(i, i.text, a, b));
        }
        case Op::choose: {
            const Value b = pop(), a = pop();
            return push(choose(pop(), a, b));
        }
        case Op::assign: {
            const Value given = pop(), target = pop();
            const bool plain = i.text.size() == 1;
            Value v = plain ? given : infix(i, i.text.substr(0, i.text.size() - 1), target, given);
            v = converted(v, target.type);
            store(target, v);
            v.variable = -1;
            return push(v);
        }
        case Op::construct:
            return push(construct(type(), i.a));
        default:
            return push(unknown(unknown_type()));
    }
}

Value Machine::constant(const Type& type, double number) {
    Value v = make(type, 1, 1);
    v.data[0] = number;
    return v;
}

void Machine::call(const Instruction& i) {
    const auto n = static_cast<std::size_t>(i.a);
    if (stack_.size() < statement_stack_ + n) return stop(End::unknown);
    if (i.op == Op::built_in) {
        const Value result = built_in(i, std::span(stack_).last(n));
        stack_.resize(stack_.size() - n);
        return push(result);
    }
    const std::vector<Value> given(stack_.end() - i.a, stack_.end());
    stack_.resize(stack_.size() - n);
    const Function* f = find_function(i, given);
    push(f ? call_user(*f, given) : unknown(unknown_type()));
    if (!f) stop(End::unknown);
}

const Function* Machine::find_function(const Instruction& i, std::span<const Value> given) const {
    const Function* meant = i.b >= 0 ? &u_.functions[static_cast<std::size_t>(i.b)] : nullptr;
    if (meant && meant->code >= 0) return meant;
    const Function* found = nullptr;
    for (const Function& f : u_.functions) {
        if (f.name != i.text || f.code < 0 || f.parameters.size() != given.size()) continue;
        bool same = true;
        for (std::size_t n = 0; n < given.size(); ++n)
            same = same && f.parameters[n].type.same(meant ? meant->parameters[n].type : given[n].type);
        if (same) return &f;
        if (found) return nullptr;  // which of them is not known
        found = &f;
    }
    return meant ? nullptr : found;
}

Value Machine::call_user(const Function& f, std::span<const Value> given) {
    if (ranges::find(calling_, &f) != calling_.end()) {
        stop(End::unknown);
        return unknown(f.result);
    }
    for (std::size_t n = 0; n < given.size(); ++n) {
        const Parameter& p = f.parameters[n];
        if (p.variable >= 0 && p.storage == Storage::out) begin(p.variable, nothing);
        if (p.variable >= 0 && p.storage != Storage::out) declare(p.variable, given[n]);
    }
    const Arena::Mark statement = statement_;
    const std::size_t stack = statement_stack_;
    calling_.push_back(&f);
    statement_ = arena_.mark();
    statement_stack_ = stack_.size();
    result_.reset();
    execute(f.code);
    std::optional<Value> result = std::move(result_);
    result_.reset();
    stack_.resize(std::min(stack_.size(), statement_stack_));
    statement_ = statement;
    statement_stack_ = stack;
    calling_.pop_back();
    for (std::size_t n = 0; n < given.size(); ++n) {
        const Parameter& p = f.parameters[n];
        if (p.storage != Storage::in && p.variable >= 0) store(given[n], load(p.variable));
    }
    Value v = result ? converted(*result, f.result) : unknown(f.result);
    v.variable = -1;
    return v;
}

}  // namespace snell::glsl::run
