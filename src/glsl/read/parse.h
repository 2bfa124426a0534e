// The light parse: declarations, functions and the types of expressions, good enough to know what a name
// means, whether an initialiser is constant, and where a float is due. What it does not understand it skips;
// errors of the language are left to the driver.
#pragma once

#include <optional>
#include <unordered_map>

#include "src/glsl/read/tree.h"

namespace snell::glsl {

struct Expression {
    Type type;
    int first = -1, last = -1;  // tokens
    int step = -1;              // of Code::steps: the last of its own
    bool constant = true;
    bool alpha_one = false;      // a vec4 whose last component is known to be 1
    std::vector<double> value;   // of constants, where known; column-major
    int global = -1;             // the variable at the root, if it is a global one
    std::string_view legacy;     // the same for a built-in variable
    std::string_view selection;  // last member or swizzle selected from it
    bool selected = false;       // anything was selected from the root

    void no_variable() { global = -1, legacy = {}; }
};

// What stands in front of a marked operand until it is known whether the mark stays, with its number.
inline constexpr std::string_view mark_name = "snell_mark";

class Parser {
public:
    // `settles`: some of the uniforms may be settled.
    Parser(Unit& unit, const Target& target, Diagnostics& diagnostics, bool settles = false)
        : u_(unit), target_(target), diagnostics_(diagnostics), settles_(settles) {}
    void run();

private:
    enum class Due : std::uint8_t { initialiser, argument, operand, result, assignment, condition };
    struct Symbol {
        Type type;
        int global = -1;
        int variable = -1;  // Code::variables
        bool constant = false;
        bool function = false;
        std::vector<double> value;
    };

    // declarations
    void external();
    Qualifiers qualifiers();
    bool layout(Qualifiers& q);
    std::optional<Type> type_specifier();
    std::optional<Type> structure();
    std::optional<Type> structure_named(std::string_view name) const;
    std::optional<Type> legacy_structure(std::string_view text);
    void members(int structure, std::vector<std::pair<int, int>>* tokens);
    int dimensions(Type& type, std::string* text);
    void block(const Qualifiers& q, int first);
    void function(const Type& result, int first, int name);
    void declarators(const Qualifiers& q, Type type, Group group, bool global);
    void declarator(const Qualifiers& q, Type type, int group, bool global);
    bool begins_undefined(const Qualifiers& q, const Type& type, const Global& g, bool global);
    Expression initialiser(const Type& due);
    bool starts_declaration() const;
    void give_parameter(int name, const Type& type);
    void skip_declaration(int first);
    void skip_to_declaration();  // the next one
    // Turns words since `first` that the driver lacks into its own: it would complain of them in place of what is
    // wrong.
    void leave_old_words(int first);

    // statements
    void statement();
    void compound();
    void simple_statement();
    void if_statement();
    void while_statement();
    void do_statement();
    void switch_statement();
    void condition();
    void local_declaration();
    void local_prototype(const Type& result, int first);
    void for_statement();

    // expressions
    Expression expression();
    Expression assignment();
    Expression ternary();
    Expression binary(int least);
    Expression unary();
    Expression postfix();
    bool index(Expression& e, bool& moves);
    void length(Expression& e);
    Expression primary();
    Expression number();
    Expression name();
    Expression constructor(const Type& type, int first);
    Expression construction(const Type& type, int first);
    Expression call(int name_token);
    void grow_call(int begin, const Expression& e, std::string_view name, bool ours);
    Expression combine(Expression a, Expression b, std::string_view op);
    std::vector<Expression> arguments();
    void select(Expression& e, std::string_view member);
    void call_builtin(Expression& result, std::string_view name, std::vector<Expression>& given);
    bool call_user(Expression& result, std::string_view name, std::vector<Expression>& given);
    void wrap(const Expression& e, std::string_view type);
    void warn(std::string_view code, int token, std::string message);
    void forgive(const Expression& e, const Type& due, std::string_view code, std::string_view what);
    Expression cast();
    bool foreign_function(std::string_view name, std::vector<Expression>& given, Expression& result);
    void convert(const Expression& e, const Type& due, Due why);
    // Remembers operands that the operator does not take.
    void note_misfit(int first, int last, std::string_view op, const Type* a, const Type* b);
    void note_assigned(const Type& to, const Expression& value);
    void note_operands(const Expression& a, const Expression& b, std::string_view op);
    void note_operand(const Expression& e, std::string_view op);
    // See marks.cpp. `a` is null where the dividend is assigned.
    Mark& mark(Mark::Kind kind, const Expression& e);
    void mark_divisor(const Expression& e);
    void mark_division(const Expression* a, const Expression& b, std::string_view op);
    void mark_decision(const Expression& e);
    void mark_product(const Expression& e, const Expression& a, const Expression& b, const Expression* weight);
    void mark_kept(const Expression& e, int into, bool written = true);
    void note_write(const Expression& target, const Expression* value, std::string_view op);

    // code
    int emit(Op op, int a = 0, std::string_view text = {}, int b = 0) {
        u_.code.steps.push_back({op, a, b, -1, 0, text});
        return here() - 1;
    }
    void emit(Op op, int a, std::string_view text, const Type& type, double number = 0);
    int here() const { return static_cast<int>(u_.code.steps.size()); }
    void land(int jump) { u_.code.steps[static_cast<std::size_t>(jump)].a = here(); }
    int variable(const Type& type);

    // tree, where it is wanted
    int grown() const { return u_.tree ? static_cast<int>(u_.tree->size()) : 0; }
    // The node of the expression, whose parts were added since the tree had `begin` nodes; null if no tree is wanted.
    Node* grow(Form form, int begin, const Expression& e, std::string_view text = {}) {
        if (!u_.tree) return nullptr;
        return &u_.tree->emplace_back(Node{form, e.first, e.last, begin, e.type, text, e.constant, e.value});
    }
    void grow_statement(Form form, int begin, int first, std::string_view text = {}) {
        if (u_.tree) u_.tree->push_back({form, first, p_ - 1, begin, {}, text});
    }
    void grow_empty() {
        if (u_.tree) u_.tree->push_back({Form::empty, p_, p_ - 1, grown()});
    }
    void inner_statement();
    void give_up() { u_.code.whole = false; }  // the code is not that of the text
    // Statements that break and continue leave or repeat.
    struct Leaving {
        std::vector<int> breaks, continues;
        int value = -1, test = -1, type = -1;  // of a switch: the variable, the test of the next case
    };
    void jump_out(bool repeat);
    void close_loop(int again, int out);
    void case_label(bool other);

    // scopes
    void declare(std::string_view name, Symbol symbol);
    const Symbol* find(std::string_view name) const;
    void open_scope() { undo_.push_back({}); }
    void close_scope();

    std::string_view text(int ahead = 0) const { return token(ahead).text; }
    const Token& token(int ahead = 0) const {
        const std::size_t i = static_cast<std::size_t>(p_ + ahead);
        return i < u_.tokens.size() ? u_.tokens[i] : u_.tokens.back();
    }
    bool is(std::string_view t, int ahead = 0) const { return text(ahead) == t; }
    bool accept(std::string_view t) {
        if (!is(t)) return false;
        ++p_;
        return true;
    }
    bool at_end() const { return token().kind == Kind::end; }
    void skip_balanced();  // from an opening bracket to behind the closing one
    void skip_to_semicolon();

    void foresee();

    Unit& u_;
    const Target& target_;
    Diagnostics& diagnostics_;
    bool settles_;
    int p_ = 0;
    int depth_ = 0;
    std::set<std::string_view> told_;                      // kinds of forgiveness: one warning each
    std::unordered_map<std::string_view, Type> foreseen_;  // results of functions defined further down
    std::vector<Leaving> leaving_;
    Type result_;                                                   // of the function being read
    std::set<std::string_view> written_;                            // first tokens of what it writes to
    std::unordered_map<int, std::vector<Expression>> constructed_;  // by step: what structures and arrays are made of
    std::unordered_map<std::string_view, Symbol> symbols_;
    std::vector<std::vector<std::pair<std::string_view, std::optional<Symbol>>>> undo_;
};

}  // namespace snell::glsl
