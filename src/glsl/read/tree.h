// What the light parse found, as a tree: expressions and the statements that hold them, with their tokens and types.
// The parser writes it only if Unit::tree is set. Besides, what loops do with the variables that they count by.
#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"

namespace snell::glsl {

enum class Form : std::uint8_t {
    other,  // not understood
    // expressions
    name,
    number,     // also true and false
    group,      // ( … )
    list,       // { …, … }
    select,     // .text
    index,      // […]
    length,     // .length()
    prefix,     // an operator of one operand
    step,       // ++ and --
    infix,      // an operator of two operands
    comma,      // …, …
    choose,     // … ? … : …
    assign,     // target, value; text: the operator
    construct,  // a constructor or a cast
    call,       // of a function of the text
    built_in,   // of a function of the language; text: its modern name
    // statements
    declarator,   // a variable outside of a parameter list, with its initialiser; text: its name
    declaration,  // declarators, within functions
    returned,     // return …;
    evaluated,    // an expression and its semicolon
    block,        // { … }; also what is no statement, or several, where one is due
    branch,       // condition, statement, perhaps the other statement
    choice,       // switch: value, statement
    label,        // case or default: perhaps its value
    jump,         // text: break, continue or discard
    empty,        // nothing, where something might be
    // text: for, while or do. Parts of `for`: what it begins with, condition, step, statement. Of `while`: condition,
    // statement. Of `do`: statement, condition.
    loop,
};

// Nodes come behind their parts: those of node n are the nodes from `begin` to before n.
struct Node {
    Form form = Form::other;
    int first = -1, last = -1;  // tokens
    int begin = 0;
    Type type;
    std::string_view text;
    bool constant = false;
    std::vector<double> value;  // of constants, where known; column-major
    int global = -1;            // names: Unit::globals
    int variable = -1;          // names and declarators: Code::variables
    int function = -1;          // calls: Unit::functions, if the overload is known
};

using Tree = std::vector<Node>;

// The parts of a node, in the order of the text.
inline std::vector<int> parts(const Tree& tree, int node) {
    std::vector<int> found;
    const int begin = tree[static_cast<std::size_t>(node)].begin;
    for (int k = node - 1; k >= begin; k = tree[static_cast<std::size_t>(k)].begin - 1) found.push_back(k);
    return {found.rbegin(), found.rend()};
}

// What loops do with the variables that they count by. Nodes are indices into Unit::tree.

// `x op= by`; op: one of + - * / = < >, the latter for shifts.
struct Update {
    char op;
    double by;
    int amount = -1;  // the expression of `by`, where that is no number of the text; `by` is NaN then
};
// What i++, i -= 2, x *= .5, i <<= 1, i = 0, x += step, x = x + step and their like do with the variable; nullopt:
// another thing.
std::optional<Update> update_of(const Unit& unit, int variable, int node);

// What the variable has after it.
double updated(double value, Update update, Base base);

// The expression that a variable begins with, by what `for` begins with.
std::optional<int> begin_of(const Unit& unit, int variable, int begins);

// Calls `each` for every variable that nodes first … last may store something in.
void each_stored(const Unit& unit, int first, int last, const std::function<void(int variable)>& each);

bool stores(const Unit& unit, int variable, int first, int last);

bool compares(std::string_view op);
// A loop's condition, as the variable that the loop changes is compared in it: `i < n` also of `n > i`.
struct Comparison {
    int variable;
    std::string_view name;  // of the variable
    std::string_view op;
    int bound;
};
// `first`, `last`: the nodes that each round runs.
std::optional<Comparison> comparison_of(const Unit& unit, int condition, int first, int last);

}  // namespace snell::glsl
