// What loops do with the variables that they count by. Nodes are indices into Unit::tree.
#pragma once

#include <functional>
#include <optional>

#include "src/glsl/read/tree.h"

namespace snell::glsl {

// `x op= by`; op: one of + - * / =.
struct Update {
    char op;
    double by;
};
// What i++, i -= 2, x *= .5, i = 0 and their like do with the variable; nullopt: another thing.
std::optional<Update> update_of(const Unit& unit, int variable, int node);

// What the variable has after it.
double updated(double value, Update update, Base base);

// The expression that a variable begins with, by what `for` begins with.
std::optional<int> begin_of(const Unit& unit, int variable, int begins);

// Calls `each` for every variable that nodes first … last may store something in.
void each_stored(const Unit& unit, int first, int last, const std::function<void(int variable)>& each);

bool compares(std::string_view op);

}  // namespace snell::glsl
