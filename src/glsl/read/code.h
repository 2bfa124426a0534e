// What a stage computes, as code for a stack machine (src/glsl/run): the light parser writes it while it reads.
#pragma once

#include <string_view>
#include <vector>

namespace snell::glsl {

enum class Op : unsigned char {
    number,     // pushes `number`; `type`
    load,       // pushes the variable `a`
    unknown,    // pushes something of which nothing is known
    select,     // .text: a member or components
    index,      // value, index → element
    length,     // .length()
    prefix,     // an operator of one operand
    step,       // ++ and --; a: 1 where it stands behind its operand
    infix,      // an operator of two operands
    choose,     // condition ? value : value
    assign,     // target, value → value; text: the operator
    construct,  // a values; `type`
    call,       // a values; text: the name; b: Unit::functions, or -1 where it is declared further down
    built_in,   // the same for a function of the language; `type` is that of the result
    declare,    // the variable a begins; b: with zero (0), with the value (1), with what GLSL leaves undefined (2)
    drop,       // the value of a statement
    jump,       // to a
    unless,     // condition → ; to a where it is false
    back,       // return; a: 1 with a value
    discard,
};

struct Instruction {
    Op op;
    int a = 0, b = 0;
    int type = -1;  // Code::types
    double number = 0;
    std::string_view text;
};

template <class Type>
struct Code {
    bool whole = true;  // false: something was not understood
    std::vector<Instruction> steps;
    std::vector<Type> types;
    std::vector<Type> variables;  // each has one place: GLSL has no recursion
};

}  // namespace snell::glsl
