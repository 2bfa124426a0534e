// Runs a stage's code on numbers, with several sets of inputs at once: the lanes. What can't be known is NaN, and so is
// all that is computed from it: results that GLSL leaves undefined, functions that are not computed here.
#pragma once

#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "src/glsl/read/token.h"

namespace snell::glsl::run {

inline constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
inline double finite(double x) { return std::isfinite(x) ? x : nothing; }

// The numbers of a type, in the order of GLSL's constructors; 0 where the number is not known.
int count(const Unit& unit, const Type& type);
Type shape(Base base, int rows = 1, int cols = 1);
Type unknown_type();

// A value on the stack. Numbers of all lanes: those of lane l, of n lanes, are data[k * n + l].
struct Value {
    Type type;
    int size = 1;
    int lanes = 1;  // 1: the same in all of them
    double* data = nullptr;
    // The place in a variable that it was read from, for assignments.
    int variable = -1;
    int first = 0;
    bool lost = false;      // which element is not known
    bool swizzled = false;  // components `at`, counted from `first`
    std::array<std::uint8_t, 4> at{};

    double get(int k, int lane) const { return data[k * lanes + (lanes > 1 ? lane : 0)]; }
};

// Memory of values until the statement ends.
class Arena {
public:
    struct Mark {
        std::size_t block = 0, used = 0;
    };
    double* take(std::size_t size);
    Mark mark() const { return at_; }
    void release(Mark mark) { at_ = mark; }

private:
    struct Block {
        std::unique_ptr<double[]> data;
        std::size_t size = 0;
    };
    std::vector<Block> blocks_;
    Mark at_;
};

struct Variable {
    int size = 0, lanes = 1;
    bool given = false;  // from outside: its declaration gives it no value
    std::vector<double> data;

    double get(int k, int lane) const { return data[static_cast<std::size_t>(k * lanes + (lanes > 1 ? lane : 0))]; }
};

struct BuiltIn;                               // a function of the language
using Operator = double (*)(double, double);  // of components

class Machine {
public:
    enum class End : std::uint8_t { running, done, discarded, unknown };

    explicit Machine(const Unit& unit);
    // Runs initialisers and main in at most 64 lanes. Those that branch unlike lane 0 leave `alive`. `neighbour`: the
    // lane of another vertex or fragment; -1: there is none. `budget`: steps that it may still take.
    End run(int lanes, int neighbour, std::uint64_t& alive, int& budget);

    const Unit& unit() const { return u_; }
    Variable& variable(int n) {
        Variable& v = variables_[static_cast<std::size_t>(n)];
        if (v.data.empty()) v.data.assign(static_cast<std::size_t>(v.size), nothing);
        return v;
    }
    const Type& type_of(int n) const { return u_.code.variables[static_cast<std::size_t>(n)]; }
    void set(int n, int lanes, const std::function<double(int k, int lane)>& value);

private:
    void execute(int from);
    void step(const Instruction& i, int& at);
    void evaluate(const Instruction& i);
    void end_statement() {
        if (stack_.size() == statement_stack_) arena_.release(statement_);
    }
    Value pop();
    void push(const Value& v) { stack_.push_back(v); }
    void stop(End end) {
        if (end_ == End::running) end_ = end;
    }
    Value make(const Type& type, int size, int lanes);
    Value unknown(const Type& type);
    Value constant(const Type& type, double number);
    Value load(int variable);
    void store(const Value& target, const Value& value);
    void begin(int variable, double number);
    void declare(int variable, const Value& value);
    bool is_true(const Value& condition);

    Value select(const Value& v, std::string_view member);
    Value component(const Value& v, std::string_view swizzle);
    Value part(const Value& v, const Type& type, int first, int size);
    Value element(const Value& v, const Value& index);
    Value gather(const Value& v, const Value& index, const Type& type, int size, int elements);
    Value converted(const Value& v, const Type& type);
    Value construct(const Type& type, int n);
    Value choose(const Value& condition, const Value& a, const Value& b);
    Value prefix(std::string_view op, const Value& v);
    Value infix(const Instruction& i, std::string_view op, const Value& a, const Value& b);
    Value multiply(const Value& a, const Value& b);
    Value equal(const Value& a, const Value& b, bool same);

    void call(const Instruction& i);
    const Function* find_function(const Instruction& i, std::span<const Value> given) const;
    Value call_user(const Function& f, std::span<const Value> given);
    Value built_in(const Instruction& i, std::span<const Value> given);
    Value by_component(std::span<const Value> given, double (*f)(const double*), const Type& result);
    Value arithmetic(const BuiltIn& f, std::string_view name, std::span<const Value> given, const Type& type);
    Value transposed(const Value& m);
    Value measured(std::string_view name, std::span<const Value> given);
    Value directed(std::string_view name, std::span<const Value> given);
    Value differences(const Value& v);
    Value sampled(std::span<const Value> given, const Type& type);

    const Unit& u_;
    int lanes_ = 1, neighbour_ = -1;
    std::vector<Variable> variables_;
    // For each of the code's steps: what its text means, once it has run.
    std::vector<const BuiltIn*> functions_;
    std::vector<Operator> operators_;
    std::vector<Value> stack_;
    Arena arena_;
    Arena::Mark statement_;  // values of the calls around lie before it
    std::size_t statement_stack_ = 0;
    std::optional<Value> result_;  // of the function that returns
    std::vector<const Function*> calling_;
    End end_ = End::running;
    std::uint64_t* alive_ = nullptr;
    int* budget_ = nullptr;
};

}  // namespace snell::glsl::run
