// The types of expressions, from the bottom up.
#include <algorithm>
#include <cmath>

#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

namespace {

// Componentwise arithmetic of known constants; a scalar goes with every component.
std::vector<double> fold(const std::vector<double>& a, const std::vector<double>& b, char op) {
    if (a.empty() || b.empty() || (a.size() != b.size() && a.size() != 1 && b.size() != 1)) return {};
    std::vector<double> out(std::max(a.size(), b.size()));
    for (std::size_t i = 0; i < out.size(); ++i) {
        const double x = a[a.size() == 1 ? 0 : i], y = b[b.size() == 1 ? 0 : i];
        out[i] = op == '+' ? x + y : op == '-' ? x - y : op == '*' ? x * y : x / y;
        if (!std::isfinite(out[i])) return {};
    }
    return out;
}

// The type of a*b, a+b … where both are numeric.
Type arithmetic(const Type& a, const Type& b, std::string_view op) {
    if (a.dims || b.dims || !a.numeric() || !b.numeric()) return {};
    Base base = std::max(a.base, b.base);
    const bool matrix_a = a.cols > 1, matrix_b = b.cols > 1;
    if (op == "*" && matrix_a && matrix_b) return make_type(base, a.rows, b.cols);
    if (op == "*" && matrix_a && b.rows > 1) return make_type(base, a.rows);
    if (op == "*" && matrix_b && a.rows > 1) return make_type(base, b.cols);
    if (a.scalar()) return make_type(base, b.rows, b.cols);
    return make_type(base, a.rows, a.cols);
}

bool known(const Type& type) { return type.dims == 0 && type.basic(); }

// Whether GLSL, with what is forgiven, takes these operands; both types are known.
bool takes(std::string_view op, const Type& a, const Type& b) {
    const bool same_shape = a.rows == b.rows && a.cols == b.cols;
    const int level = op == "?:" ? 7 : precedence(op);
    if (level <= 3 || level == 8) return a.scalar() && b.scalar();
    if (level == 7) return same_shape;
    if (level == 10 || (level == 11 && op != "%")) {
        if (!a.numeric() && !b.numeric()) return false;
        if (op == "*" && (a.cols > 1 || b.cols > 1) && !a.scalar() && !b.scalar())
            return (a.cols > 1 ? a.cols : a.rows) == b.rows;
        return same_shape || a.scalar() || b.scalar();
    }
    return a.integral() && b.integral() && (same_shape || b.scalar() || (a.scalar() && level != 9));
}

}  // namespace

void Parser::emit(Op op, int a, std::string_view text, const Type& type, double number) {
    auto& types = u_.code.types;
    if (types.empty() || !types.back().same(type) || types.back().size != type.size) types.push_back(type);
    u_.code.steps.push_back({op, a, 0, static_cast<int>(types.size()) - 1, number, text});
}

int Parser::variable(const Type& type) {
    u_.code.variables.push_back(type);
    return static_cast<int>(u_.code.variables.size()) - 1;
}

void Parser::note_misfit(int first, int last, std::string_view op, const Type* a, const Type* b) {
    const auto name = [](const Type* type) {
        return type ? type_name(type->base, type->rows, type->cols) : std::string_view();
    };
    const Span begin = u_.span(first), end = u_.span(last);
    if (begin.file == end.file)
        u_.misfits.push_back({{begin.file, begin.begin, end.end}, std::string(op), name(a), name(b)});
}

void Parser::note_operands(const Expression& a, const Expression& b, std::string_view op) {
    if (a.first < 0 || b.last < a.first || !known(a.type) || !known(b.type) || takes(op, a.type, b.type)) return;
    note_misfit(a.first, b.last, op, &a.type, &b.type);
}

void Parser::note_assigned(const Type& to, const Expression& value) {
    if (value.first < 0 || value.last < value.first || !known(to) || !known(value.type)) return;
    if (to.rows != value.type.rows || to.cols != value.type.cols)
        note_misfit(value.first, value.last, ":=", &to, &value.type);
}

void Parser::note_operand(const Expression& e, std::string_view op) {
    if (e.first < 0 || e.last < e.first || !known(e.type)) return;
    const bool good = op == "!" ? e.type.scalar() : op == "~" ? e.type.integral() : e.type.numeric();
    if (!good) note_misfit(e.first, e.last, op, &e.type, nullptr);
}

void Parser::wrap(const Expression& e, std::string_view type) {
    Edit& before = u_.edit(e.first);
    before.before = std::string(type) + "(" + before.before;
    u_.edit(e.last).after += ")";
}

void Parser::warn(std::string_view code, int token, std::string message) {
    if (told_.insert(code).second) diagnostics_.warning(code, u_.span(token), std::move(message));
}

// No version allows these conversions, but some compilers accept them.
void Parser::forgive(const Expression& e, const Type& due, std::string_view code, std::string_view what) {
    warn(code, e.first, std::string(what));
    wrap(e, type_name(due.base, due.rows, 1));
}

void Parser::convert(const Expression& e, const Type& due, Due why) {
    if (e.first < 0 || e.last < e.first || e.type.dims || due.dims || e.type.rows != due.rows || e.type.cols != 1 ||
        due.cols != 1)
        return;
    const Type& have = e.type;
    if (why == Due::condition && have.base == Base::boolean) return mark_decision(e);
    if (have.base == due.base || have.base < Base::boolean || due.base < Base::boolean || have.base > Base::dreal ||
        due.base > Base::dreal)
        return;
    if (due.base == Base::boolean) {
        bool assigns = false;
        for (int i = e.first; i <= e.last; ++i) assigns |= u_.now(i) == "=";
        forgive(e, due, "number-as-bool",
                assigns ? "this assigns a number, and is true unless it is zero; '==' compares"
                        : "a number is used where true or false is expected; it is true unless it is zero");
        return why == Due::condition ? mark_decision(e) : void();
    }
    if (have.base == Base::boolean)
        return forgive(e, due, "bool-as-number", "true or false is used where a number is expected; it is 1 or 0");
    if (due.integral() && have.floating())
        return forgive(e, due, "float-to-int", "a float is used where an int is expected; its fraction is dropped");
    const bool to_float = due.floating() && have.integral();
    const bool to_unsigned = due.base == Base::uinteger && have.base == Base::integer;
    if (!to_float && !to_unsigned) return;
    if (to_float) mark_kept(e, -1);
    if (!target_.es && !(why == Due::result && target_.version < 420) && !(to_unsigned && target_.version < 400))
        return;
    const bool literal = e.first == e.last && u_.at(e.first).kind == Kind::integer;
    const std::string_view text = u_.now(e.first);
    if (literal && to_float && text.find_first_not_of("0123456789") == std::string_view::npos && text.size() < 18) {
        const std::size_t digits = std::min(text.find_first_not_of('0'), text.size() - 1);
        return u_.replace(e.first, std::string(text.substr(digits)) + ".0");
    }
    wrap(e, type_name(due.base == Base::dreal ? Base::real : due.base, due.rows, 1));
}

void Parser::note_write(const Expression& target, const Expression* value, std::string_view op) {
    bool color = false;
    if (target.first >= 0) written_.insert(u_.at(target.first).text);
    if (!target.legacy.empty()) {
        u_.legacy_written.insert(target.legacy);
        color = target.legacy == "gl_FragColor" || target.legacy == "gl_FragData";
    }
    if (target.global >= 0) {
        Global& g = u_.globals[static_cast<std::size_t>(target.global)];
        g.written = true;
        color = u_.stage == Stage::fragment && g.qualifiers.storage == Storage::out;
        if (color && g.type.rows != 4) u_.alpha_unknown = true;
    }
    if (!color) return;
    if (!target.selection.empty()) {
        if (!has_alpha(target.selection)) return;
        const bool one = value && op == "=" && target.selection.size() == 1 && value->value == std::vector<double>{1};
        (one ? u_.alpha_known : u_.alpha_unknown) = true;
    } else {
        const bool one = value && op == "=" && value->alpha_one;
        (one ? u_.alpha_known : u_.alpha_unknown) = true;
    }
}

Expression Parser::expression() {
    const int begin = grown();
    Expression e = assignment();
    while (is(",")) {
        const int first = e.first;
        // An operand before a comma that has no effect is removed: OpenGL ES 1.00 has constants with commas.
        if (e.constant && first >= 0 && e.last == p_ - 1) u_.erase(first, p_);
        ++p_;
        emit(Op::drop);
        e = assignment();
        e.first = first;
        grow(Form::comma, begin, e);
    }
    return e;
}

Expression Parser::assignment() {
    if (depth_ > 200) {
        Expression e;
        e.first = p_;
        skip_balanced();
        e.last = p_ - 1;
        e.constant = false;
        emit(Op::unknown);
        give_up();
        grow(Form::other, grown(), e);
        return e;
    }
    ++depth_;
    const int begin = grown();
    Expression target = ternary();
    if (assigns(text())) {
        const std::string_view op = text();
        ++p_;
        const Expression value = assignment();
        const bool plain = op == "=";
        const bool name = target.first == target.last && u_.at(target.first).kind == Kind::identifier;
        if (plain && name && target.legacy.empty() && !known(target.type) && known(value.type) &&
            !value.type.integral() && !find(u_.at(target.first).text))
            note_misfit(target.first, target.first, "=", nullptr, &value.type);
        Type due = target.type;
        if (!plain && op != "<<=" && op != ">>=") note_operands(target, value, op.substr(0, 1));
        if (plain) note_assigned(due, value);
        if (!plain && due.floating()) due = make_type(due.base, value.type.rows);
        if (op != "<<=" && op != ">>=") convert(value, due, plain ? Due::assignment : Due::operand);
        if (!plain) mark_division(nullptr, value, op.substr(0, 1));
        const std::size_t marked = u_.marks.size();
        mark_kept(value, here());
        if (!plain && u_.marks.size() > marked) u_.marks.back().step = here();  // of which the result is what counts
        note_write(target, &value, op);
        emit(Op::assign, 0, op);
        target.step = here() - 1;
        target.last = value.last >= 0 ? value.last : p_ - 1;
        target.constant = false;
        target.value.clear();
        target.alpha_one = plain && value.alpha_one;
        target.no_variable();
        grow(Form::assign, begin, target, op);
    }
    --depth_;
    return target;
}

Expression Parser::ternary() {
    const int begin = grown();
    Expression condition = binary(1);
    if (!accept("?")) return condition;
    convert(condition, make_type(Base::boolean), Due::condition);
    Expression a = expression();
    accept(":");
    Expression b = assignment();
    const int choice = emit(Op::choose);
    note_operands(a, b, "?:");
    if (a.type.base != b.type.base && a.type.numeric() && b.type.numeric()) {
        const Base base = std::max(a.type.base, b.type.base);
        convert(a, make_type(base, a.type.rows), Due::operand);
        convert(b, make_type(base, b.type.rows), Due::operand);
        if (a.type.base < base) a.type = b.type;
    }
    const bool constant = a.constant && b.constant && condition.constant;  // perhaps where GLSL wants a constant
    for (const Expression* arm : {&a, &b})
        if (!constant) mark_kept(*arm, choice);
    a.step = choice;
    a.constant = constant;
    a.alpha_one = a.alpha_one && b.alpha_one;
    a.value.clear();
    a.first = condition.first;
    a.last = b.last;
    a.no_variable();
    grow(Form::choose, begin, a);
    return a;
}

Expression Parser::combine(Expression a, Expression b, std::string_view op) {
    Expression out;
    out.first = a.first;
    out.last = b.last;
    out.constant = a.constant && b.constant;
    out.step = here() - 1;
    note_operands(a, b, op);
    const bool logical = op == "&&" || op == "||" || op == "^^";
    const bool relation = precedence(op) == 7 || precedence(op) == 8;
    if (logical) {
        convert(a, make_type(Base::boolean), Due::condition);
        convert(b, make_type(Base::boolean), Due::condition);
        out.type = make_type(Base::boolean);
        return out;
    }
    if (op == "<<" || op == ">>") {
        out.type = a.type;
        return out;
    }
    if (a.type.base == Base::boolean && b.type.numeric()) {
        convert(a, make_type(b.type.base, a.type.rows), Due::operand);
        a.type = make_type(b.type.base, a.type.rows);
    } else if (b.type.base == Base::boolean && a.type.numeric()) {
        convert(b, make_type(a.type.base, b.type.rows), Due::operand);
        b.type = make_type(a.type.base, b.type.rows);
    } else if (a.type.numeric() && b.type.numeric() && a.type.base != b.type.base) {
        const Base base = std::max(a.type.base, b.type.base);
        convert(a, make_type(base, a.type.rows), Due::operand);
        convert(b, make_type(base, b.type.rows), Due::operand);
    }
    if (relation) {
        for (const Expression* bound : {&a, &b})
            if (bound->type.integral()) mark_decision(*bound);
        out.type = make_type(Base::boolean);
        return out;
    }
    mark_division(&a, b, op);
    out.type = arithmetic(a.type, b.type, op);
    if (op == "*") mark_product(out, a, b, nullptr);
    const bool matrix = a.type.cols > 1 || b.type.cols > 1;
    if (out.constant && !(matrix && op == "*") && (op == "+" || op == "-" || op == "*" || op == "/")) {
        out.value = fold(a.value, b.value, op[0]);
        if (op == "/" && out.type.integral())
            for (double& v : out.value) v = std::trunc(v);
    }
    return out;
}

Expression Parser::binary(int least) {
    const int begin = grown();
    Expression left = unary();
    for (int level = precedence(text()); level >= least && level > 0; level = precedence(text())) {
        const std::string_view op = text();
        ++p_;
        Expression right = binary(level + 1);
        emit(Op::infix, 0, op);
        left = combine(std::move(left), std::move(right), op);
        grow(Form::infix, begin, left, op);
    }
    return left;
}

Expression Parser::unary() {
    const std::string_view op = text();
    if (token().kind != Kind::punct || (op != "-" && op != "+" && op != "!" && op != "~" && op != "++" && op != "--"))
        return postfix();
    const int first = p_, begin = grown();
    if (depth_ > 200) return primary();
    ++p_;
    ++depth_;
    Expression e = unary();
    --depth_;
    note_operand(e, op);
    e.first = first;
    const bool steps = op == "++" || op == "--";
    Expression operand = e;
    operand.first = first + 1;
    emit(steps ? Op::step : Op::prefix, 0, op);
    e.step = here() - 1;
    if (steps) {
        note_write(e, nullptr, op);
        e.constant = false;
    }
    if (op == "-")
        for (double& v : e.value) v = -v;
    if (op == "!") {
        if (operand.type.scalar()) convert(operand, make_type(Base::boolean), Due::condition);
        e.type = make_type(Base::boolean);
    }
    if (op != "-" && op != "+") e.value.clear();
    e.alpha_one = false;
    e.no_variable();
    grow(steps ? Form::step : Form::prefix, begin, e, op);
    return e;
}

}  // namespace snell::glsl
