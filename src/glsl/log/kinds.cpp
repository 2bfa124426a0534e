// Maps the messages of drivers to kinds of errors.
#include <array>

#include "src/glsl/log/log.h"

namespace snell::glsl::log {
namespace {

// A pattern of a message: `*` stands for any text, as short as possible; the texts become a and b in the order
// that `captures` names them ('a', 'b', '-' for none).
struct Pattern {
    std::string_view text;
    Kind kind;
    std::string_view captures = "ab";
};

// In order: the first that fits decides. Quotes of all kinds are written '.
constexpr auto patterns = std::to_array<Pattern>({
    {"'*' undeclared", Kind::undeclared},                     // Mesa
    {"undefined variable '*'*", Kind::undeclared, "a"},       // NVIDIA
    {"'*' : undeclared identifier*", Kind::undeclared, "a"},  // ANGLE, Intel, AMD, glslang
    {"Undeclared identifier: *", Kind::undeclared},           // older AMD
    {"Undeclared identifier *", Kind::undeclared},
    {"Use of undeclared type '*'*", Kind::undeclared, "a"},
    {"Use of undeclared identifier '*'*", Kind::undeclared, "a"},  // Apple
    {"Invalid call of undeclared identifier '*'*", Kind::no_function, "a"},
    {"no function with name '*'", Kind::no_function},
    {"'*' : no matching overloaded function found*", Kind::no_overload, "a"},
    {"No matching overloaded function found: *", Kind::no_overload},
    {"No matching overloaded function found *", Kind::no_overload},
    {"No matching function for call to *(*)", Kind::no_overload},
    {"no matching function for call to '*(*)'*", Kind::no_overload, "ab"},
    {"unable to find compatible overloaded function '*(*)'*", Kind::no_overload, "ab"},
    {"ambiguous overloaded function reference '*(*)'*", Kind::no_overload, "ab"},
    {"too few parameters in function call*", Kind::few_arguments, "-"},
    {"too many parameters in function call*", Kind::many_arguments, "-"},
    {"cannot call a non-function*", Kind::no_function, "-"},
    {"function name is not an identifier*", Kind::no_function, "-"},

    {"'return' with wrong type *, in function '*' returning *", Kind::returns, "a-b"},
    {"could not implicitly convert return value to *, in function '*'*", Kind::returns, "b-"},
    {"'return' : function return is not matching type*", Kind::returns, "-"},
    {"'return' : * cannot convert return value to function return type*", Kind::returns, "-"},
    {"'return' : type does not match, or is not convertible to, the function's return type*", Kind::returns, "-"},
    {"expression type incompatible with function return type*", Kind::returns, "-"},
    {"Incompatible types (* and *) in return*", Kind::returns, "ba"},

    {"initializer of type * cannot be assigned to variable of type *", Kind::convert},
    {"value of type * cannot be assigned to variable of type *", Kind::convert},
    {"implicit cast from '*' to '*'*", Kind::convert},
    {"implicit narrowing of type from '*' to '*'*", Kind::convert},
    {"cannot implicitly convert from '*' to '*'*", Kind::convert},
    {"Cannot convert from: '*' to: '*'*", Kind::convert},
    {"Cannot convert from '*' to '*'*", Kind::convert},
    {"'*' : non-matching types for const initializer*", Kind::convert, "-"},
    {"'*' : cannot convert from '*' to '*'*", Kind::convert, "-ab"},
    {"Incompatible types (* and *) in *", Kind::convert, "ba"},
    {"Implicit truncation of vector from size: * to size: *", Kind::convert},
    {"assignment of incompatible types*", Kind::convert, "-"},
    {"incompatible types in initialization*", Kind::convert, "-"},
    {"invalid initialization*", Kind::convert, "-"},
    {"'*' : dimension mismatch*", Kind::convert, "-"},

    {"'*' : wrong operand types*left-hand operand of type '*' and a right operand of type '*'*", Kind::operands,
     "--ab"},
    {"Wrong operand types:*left-hand operand of type '*' and a right operand of type '*'*", Kind::operands, "-ab"},
    {"'*' : wrong operand types*", Kind::operands, "-"},
    {"'*' does not operate on '*' and '*'*", Kind::operands, "-ab"},
    {"could not implicitly convert operands to *", Kind::operands, "-"},
    {"Types '*' and '*' in conditional operator do not match*", Kind::operands},
    {"*-statement condition must be scalar boolean*", Kind::condition, "--"},
    {"operand of '!' must be scalar boolean*", Kind::condition, "-"},
    {"*HS of '*' must be scalar boolean*", Kind::condition, "---"},
    {"*oolean expression expected*", Kind::condition, "--"},
    {"size mismatch for matrix multiplication*", Kind::operands, "-"},
    {"operands to relational operators must be scalar and numeric*", Kind::operands, "-"},
    {"second and third operands of ?: operator must have matching types*", Kind::operands, "-"},
    {"vector size mismatch for arithmetic operator*", Kind::operands, "-"},
    {"invalid operands to '*'*", Kind::operands, "-"},
    {"operands to '*' must be *", Kind::operands, "--"},
    {"operands to arithmetic operators must be numeric*", Kind::operands, "-"},
    {"operands of * must have the same type*", Kind::operands, "-"},
    {"type mismatch*", Kind::operands, "-"},

    {"too few components to construct '*'", Kind::constructor_few},
    {"too little data in type constructor*", Kind::constructor_few, "-"},
    {"'*' : not enough data provided for construction*", Kind::constructor_few, "-"},
    {"Not enough data provided for construction*", Kind::constructor_few, "-"},
    {"too many parameters to '*' constructor*", Kind::constructor_many, "a"},
    {"too much data in type constructor*", Kind::constructor_many, "-"},
    {"'*' : too many arguments*", Kind::constructor_many, "-"},
    {"Too many arguments to constructor of '*'*", Kind::constructor_many, "a"},
    {"Too many arguments *", Kind::constructor_many, "-"},

    {"invalid swizzle / mask '*'*", Kind::swizzle, "a"},
    {"swizzle mask element not present in operand '*'*", Kind::swizzle, "a"},
    {"invalid character '*' in swizzle '*'*", Kind::swizzle, "-a"},
    {"'*' : illegal vector field selection*", Kind::swizzle, "a"},
    {"'*' : vector field selection out of range*", Kind::swizzle, "a"},
    {"'*' : vector swizzle selection out of range*", Kind::swizzle, "a"},
    {"'*' redeclared", Kind::redeclared},
    {"redefinition of '*'*", Kind::redeclared, "a"},
    {"declaration of '*' conflicts with previous declaration*", Kind::redeclared, "a"},
    {"function '*' redefined*", Kind::redeclared, "a"},
    {"function '*' is already defined*", Kind::redeclared, "a"},
    {"'*' : redefinition*", Kind::redeclared, "a"},
    {"'*' : function already has a body*", Kind::redeclared, "a"},
    {"Function already has a body: *", Kind::redeclared},
    {"Redefinition of '*'*", Kind::redeclared, "a"},

    {"assignment to read-only variable '*'", Kind::read_only},
    {"non-lvalue in assignment*", Kind::read_only, "-"},
    {"lvalue in * is not *", Kind::read_only, "--"},
    {"'*' : l-value required (cannot modify * '*')*", Kind::read_only, "--a"},
    {"'*' : l-value required '*' (cannot modify *)*", Kind::read_only, "-a"},
    {"'*' : l-value required*", Kind::read_only, "-"},
    {"initializer of * must be a constant expression*", Kind::not_constant, "-"},
    {"non constant expression in initialization*", Kind::not_constant, "-"},
    {"'*' : assigning non-constant to '*'*", Kind::not_constant, "--"},
    {"'*' : global variable initializers must be constant expressions*", Kind::not_constant, "-"},
    {"Initializer not constant*", Kind::not_constant, "-"},
    {"* variable '*' must be declared at global scope*", Kind::not_global, "-a"},
    {"'*' : not allowed in nested scope*", Kind::not_global, "a"},
    {"'*' : only allowed at global scope*", Kind::not_global, "a"},
    {"function '*' has non-void return type *, but no return statement*", Kind::no_return, "a-"},
    {"'*' : function does not return a value: *", Kind::no_return, "-a"},
    {"'*' : function does not return a value*", Kind::no_return, "a"},
    {"function '*' * requires a return value*", Kind::no_return, "a"},

    {"syntax error, unexpected end of file*", Kind::end_of_file, "-"},
    {"syntax error, unexpected $end*", Kind::end_of_file, "-"},
    {"'*' : syntax error, unexpected end of file*", Kind::end_of_file, "-"},
    {"'*' : syntax error: unexpected end of file*", Kind::end_of_file, "-"},
    {"'*' : unexpected end of file*", Kind::end_of_file, "-"},
    {"'*' : end of input*", Kind::end_of_file, "-"},
    {"unexpected end of file*", Kind::end_of_file, "-"},
    {"*nterminated #if*", Kind::if_unfinished, "--"},
    {"'*' : missing #endif*", Kind::if_unfinished, "-"},
    {"'*' : unexpected end of file found in conditional block*", Kind::if_unfinished, "-"},
    {"*#if*without*#endif*", Kind::if_unfinished, "----"},
    {"syntax error, * at token '*'*", Kind::syntax, "-a"},
    {"syntax error, unexpected *, expecting *", Kind::syntax, "-"},
    {"syntax error, unexpected *", Kind::syntax, "-"},
    {"Syntax error: '*' parse error*", Kind::syntax, "a"},
    {"'*' : syntax error*", Kind::syntax, "a"},
    {"syntax error*", Kind::syntax, "-"},

    {"'*' requires #version * or later*", Kind::needs_version},
    {"global * * requires '#version *' or later*", Kind::needs_version, "-ab"},
    {"* requires GLSL *", Kind::needs_version},
    {"'*' : requires GLSL *", Kind::needs_version},
    {"'*' : not supported for this version*", Kind::needs_version, "a"},
    {"'*' : not supported with this profile*", Kind::needs_version, "a"},

    {"* shader lacks 'main'*", Kind::no_main, "-"},
    {"no program defined*", Kind::no_main, "-"},
    {"*issing main()*", Kind::no_main, "--"},
    {"*issing entry point*", Kind::no_main, "--"},
    {"*No definition of main*", Kind::no_main, "--"},
    {"unresolved reference to function '*'*", Kind::no_body, "a"},
    {"unresolved reference to function *", Kind::no_body},
    {"*ndefined reference to '*'*", Kind::no_body, "-a"},
    {"*ndefined symbol*'*'*", Kind::no_body, "--a"},
    {"*: No function definition (body) found: *", Kind::no_body, "-a"},
    {"*varying * not written by *", Kind::not_written, "-a-"},
    {"* shader input '*' has no matching output in the previous stage*", Kind::not_written, "-a"},
    {"Input of * shader '*' not written by *", Kind::not_written, "-a-"},
    {"The *shader uses varying *, but previous shader does not write to it*", Kind::not_written, "-a"},
    {"Varying '*' not found in * shader*", Kind::not_written, "a-"},
    {"'*' not declared as an output from the previous stage*", Kind::not_written, "a"},
    {"* shader varying '*' is not declared by *", Kind::not_written, "-a-"},
    {"* shader output '*' declared as type '*', but * shader input declared as type '*'", Kind::types_differ, "-a"},
    {"uniform '*' declared as type '*' and type '*'", Kind::types_differ, "a"},
    {"*'*' declared as type '*' and type '*'", Kind::types_differ, "-a"},
    {"*ype mismatch*varying '*'*", Kind::types_differ, "--a"},
    {"Type mismatch: Type of * different between shaders*", Kind::types_differ, "a"},
    {"Symbol '*' usage doesn't match between two stages*", Kind::types_differ, "a"},
    {"Types of * '*' differ between *", Kind::types_differ, "-a-"},
    {"Type of '*' doesn't match*", Kind::types_differ, "a"},

    {"*macro * invoked with *", Kind::other, "-a-"},
    {"unrecognized layout identifier '*'", Kind::other, "a"},

    {"linking with uncompiled*", Kind::noise, "-"},
    {"* compilation errors.*", Kind::noise, "--"},
    {"*compilation terminated*", Kind::noise, "--"},
    {"*attached shaders not successfully compiled*", Kind::noise, "--"},
    {"Not all shaders have valid object code*", Kind::noise, "-"},
    {"*hader was successfully compiled*", Kind::noise, "--"},
    {"*shader(s) linked*", Kind::noise, "--"},
    {"*shader failed to compile with the following errors*", Kind::noise, "--"},
    {"Out of resource error*", Kind::noise, "-"},
    {"... or #extension*", Kind::noise, "-"},
    {"exception during compilation*", Kind::noise, "-"},
    {"incompatible options for link*", Kind::noise, "-"},
    {"No errors*", Kind::noise, "-"},
    {"*extension * unsupported in * shader*", Kind::noise, "----"},
});

// Texts that the stars of `pattern` take; false if the pattern does not fit. Stars take as little as possible.
bool fits(std::string_view pattern, std::string_view text, std::vector<std::string_view>& taken) {
    const std::size_t star = pattern.find('*');
    if (star == std::string_view::npos) return pattern == text;
    if (!text.starts_with(pattern.substr(0, star))) return false;
    text.remove_prefix(star);
    pattern.remove_prefix(star + 1);
    if (pattern.empty()) {
        taken.push_back(text);
        return true;
    }
    const std::string_view literal = pattern.substr(0, pattern.find('*'));
    const std::size_t before = taken.size();
    for (std::size_t at = text.find(literal); at != std::string_view::npos; at = text.find(literal, at + 1)) {
        taken.push_back(text.substr(0, at));
        if (fits(pattern, text.substr(at), taken)) return true;
        taken.resize(before);
    }
    return false;
}

// All quotes as ', runs of blanks as one.
std::string plain(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == ' ' && result.ends_with(' ')) continue;
        result += c == '`' || c == '"' ? '\'' : c;
    }
    return result;
}

}  // namespace

void classify(Entry& entry) {
    entry.text = plain(entry.text);
    std::vector<std::string_view> taken;
    for (const Pattern& pattern : patterns) {
        taken.clear();
        if (!fits(pattern.text, entry.text, taken)) continue;
        entry.kind = pattern.kind;
        for (std::size_t i = 0; i < taken.size() && i < pattern.captures.size(); ++i) {
            if (pattern.captures[i] == 'a') entry.a = type_name(taken[i]);
            if (pattern.captures[i] == 'b') entry.b = type_name(taken[i]);
        }
        // Intel's link logs write `_I;block;name`.
        if (entry.a.starts_with("_")) entry.a.erase(0, entry.a.rfind(';') + 1);
        return;
    }
}

std::string type_name(std::string_view words) {
    std::string_view kept = words;
    for (bool more = true; more;) {
        more = false;
        for (const std::string_view prefix : {" ", "const ", "temp ", "global ", "default ", "in ", "out ", "uniform ",
                                              "flat ", "smooth ", "highp ", "mediump ", "lowp "})
            if (kept.starts_with(prefix)) {
                kept.remove_prefix(prefix.size());
                more = true;
            }
    }
    if (kept == "unsigned int") return "uint";
    const auto digit = [&](std::size_t i) { return i < kept.size() && kept[i] >= '2' && kept[i] <= '4'; };
    const std::size_t of = kept.rfind(' ');
    if (digit(0) && kept.substr(1).starts_with("-component vector of ")) {
        const std::string_view scalar = kept.substr(of + 1);
        if (scalar.starts_with("vec")) return std::string(scalar);
        const std::string prefix = scalar == "int" ? "i" : scalar == "uint" ? "u" : scalar == "bool" ? "b" : "";
        return prefix + "vec" + kept[0];
    }
    if (digit(0) && digit(2) && (kept[1] == 'X' || kept[1] == 'x') && kept.substr(3).starts_with(" matrix of "))
        return std::string("mat") + kept[0] + (kept[0] == kept[2] ? "" : std::string("x") + kept[2]);
    return std::string(kept);
}

}  // namespace snell::glsl::log
