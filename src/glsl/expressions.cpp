// The types of expressions, from the bottom up.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "src/glsl/legacy.h"
#include "src/glsl/parse.h"
#include "src/glsl/words.h"

namespace snell::glsl {

namespace {

int precedence(std::string_view op) {
    if (op.empty() || op.size() > 2) return 0;
    if (op == "||") return 1;
    if (op == "^^") return 2;
    if (op == "&&") return 3;
    if (op == "|") return 4;
    if (op == "^") return 5;
    if (op == "&") return 6;
    if (op == "==" || op == "!=") return 7;
    if (op == "<" || op == ">" || op == "<=" || op == ">=") return 8;
    if (op == "<<" || op == ">>") return 9;
    if (op == "+" || op == "-") return 10;
    if (op == "*" || op == "/" || op == "%") return 11;
    return 0;
}

bool assigns(std::string_view op) {
    return op == "=" || op == "+=" || op == "-=" || op == "*=" || op == "/=" || op == "%=" || op == "&=" ||
           op == "|=" || op == "^=" || op == "<<=" || op == ">>=";
}

bool has_alpha(std::string_view selection) { return selection.find_first_of("awq") != std::string_view::npos; }

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

}  // namespace

void Parser::wrap(const Expression& e, std::string_view type) {
    Edit& before = u_.edit(e.first);
    before.before = std::string(type) + "(" + before.before;
    u_.edit(e.last).after += ")";
}

void Parser::warn(std::string_view code, int token, std::string message) {
    if (told_.insert(code).second) diagnostics_.warning(code, u_.span(token), std::move(message));
}

// What no version allows and some compilers read nevertheless.
void Parser::forgive(const Expression& e, const Type& due, std::string_view code, std::string_view what) {
    warn(code, e.first, std::string(what));
    wrap(e, type_name(due.base, due.rows, 1));
}

void Parser::convert(const Expression& e, const Type& due, Due why) {
    if (e.first < 0 || e.last < e.first || e.type.dims || due.dims || e.type.rows != due.rows || e.type.cols != 1 ||
        due.cols != 1)
        return;
    const Type& have = e.type;
    if (have.base == due.base || have.base < Base::boolean || due.base < Base::boolean || have.base > Base::dreal ||
        due.base > Base::dreal)
        return;
    if (due.base == Base::boolean)
        return forgive(e, due, "number-as-bool", "a number stands where true or false is due: true unless it is zero");
    if (have.base == Base::boolean)
        return forgive(e, due, "bool-as-number", "true or false stands where a number is due: 1 or 0");
    if (due.integral() && have.floating())
        return forgive(e, due, "float-to-int", "a float stands where an int is due: its fraction is dropped");
    const bool to_float = due.floating() && have.integral();
    const bool to_unsigned = due.base == Base::uinteger && have.base == Base::integer;
    if (!to_float && !to_unsigned) return;
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
    Expression e = assignment();
    while (is(",")) {
        const int first = e.first;
        ++p_;
        e = assignment();
        e.first = first;
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
        return e;
    }
    ++depth_;
    Expression target = ternary();
    if (assigns(text())) {
        const std::string_view op = text();
        ++p_;
        const Expression value = assignment();
        const bool plain = op == "=";
        Type due = target.type;
        if (!plain && due.floating()) due = make_type(due.base, value.type.rows);
        if (op != "<<=" && op != ">>=") convert(value, due, plain ? Due::assignment : Due::operand);
        note_write(target, &value, op);
        target.last = value.last >= 0 ? value.last : p_ - 1;
        target.constant = false;
        target.value.clear();
        target.alpha_one = plain && value.alpha_one;
        target.global = -1;
        target.legacy = {};
    }
    --depth_;
    return target;
}

Expression Parser::ternary() {
    Expression condition = binary(1);
    if (!accept("?")) return condition;
    convert(condition, make_type(Base::boolean), Due::condition);
    Expression a = expression();
    accept(":");
    Expression b = assignment();
    if (a.type.base != b.type.base && a.type.numeric() && b.type.numeric()) {
        const Base base = std::max(a.type.base, b.type.base);
        convert(a, make_type(base, a.type.rows), Due::operand);
        convert(b, make_type(base, b.type.rows), Due::operand);
        if (a.type.base < base) a.type = b.type;
    }
    a.constant = a.constant && b.constant && condition.constant;
    a.alpha_one = a.alpha_one && b.alpha_one;
    a.value.clear();
    a.first = condition.first;
    a.last = b.last;
    a.global = -1;
    a.legacy = {};
    return a;
}

Expression Parser::combine(Expression a, Expression b, std::string_view op) {
    Expression out;
    out.first = a.first;
    out.last = b.last;
    out.constant = a.constant && b.constant;
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
        out.type = make_type(Base::boolean);
        return out;
    }
    out.type = arithmetic(a.type, b.type, op);
    const bool matrix = a.type.cols > 1 || b.type.cols > 1;
    if (out.constant && !(matrix && op == "*") && (op == "+" || op == "-" || op == "*" || op == "/")) {
        out.value = fold(a.value, b.value, op[0]);
        if (op == "/" && out.type.integral())
            for (double& v : out.value) v = std::trunc(v);
    }
    return out;
}

Expression Parser::binary(int least) {
    Expression left = unary();
    for (int level = precedence(text()); level >= least && level > 0; level = precedence(text())) {
        const std::string_view op = text();
        ++p_;
        Expression right = binary(level + 1);
        left = combine(std::move(left), std::move(right), op);
    }
    return left;
}

Expression Parser::unary() {
    const std::string_view op = text();
    if (token().kind != Kind::punct || (op != "-" && op != "+" && op != "!" && op != "~" && op != "++" && op != "--"))
        return postfix();
    const int first = p_;
    if (depth_ > 200) return primary();
    ++p_;
    ++depth_;
    Expression e = unary();
    --depth_;
    e.first = first;
    if (op == "++" || op == "--") {
        note_write(e, nullptr, op);
        e.constant = false;
    }
    if (op == "-")
        for (double& v : e.value) v = -v;
    if (op == "!") {
        Expression operand = e;
        operand.first = first + 1;
        if (operand.type.scalar()) convert(operand, make_type(Base::boolean), Due::condition);
        e.type = make_type(Base::boolean);
    }
    if (op != "-" && op != "+") e.value.clear();
    e.alpha_one = false;
    e.global = -1;
    e.legacy = {};
    return e;
}

void Parser::select(Expression& e, std::string_view member) {
    e.selected = true;
    if (member.starts_with("gl_")) {
        const LegacyName* legacy = legacy_name(member);
        e.type = {};
        if (legacy)
            if (const auto type = builtin_type(legacy->type)) e.type = *type;
        if (legacy && legacy->size > 0) e.type.dims = 1;
        e.legacy = member;
        e.value.clear();
        return;
    }
    if (e.type.base == Base::structure && e.type.dims == 0 && e.type.structure >= 0) {
        Type found;
        for (const Member& m : u_.structs[static_cast<std::size_t>(e.type.structure)].members)
            if (m.name == member) found = m.type;
        e.type = found;
        e.value.clear();
        return;
    }
    e.selection = member;
    const bool scalar_selected = e.type.scalar() && e.type.numeric() && member.find_first_not_of("xrs") == member.npos;
    if (scalar_selected && (target_.es || target_.version < 420) && e.first >= 0) {
        Edit& before = u_.edit(e.first);
        before.before =
            std::string(type_name(e.type.base, static_cast<int>(std::min<std::size_t>(member.size(), 4)), 1)) + "(" +
            before.before;
        u_.replace(p_ - 2, "");
        u_.replace(p_ - 1, ")");
    }
    if (e.type.dims || e.type.cols > 1 || e.type.base < Base::boolean || e.type.base > Base::dreal ||
        member.size() > 4) {
        e.type = {};
        e.value.clear();
        return;
    }
    std::vector<double> value;
    for (const char c : member) {
        constexpr std::string_view sets = "xyzwrgbastpq";
        const std::size_t n = sets.find(c);
        if (n != std::string_view::npos && n % 4 < e.value.size()) value.push_back(e.value[n % 4]);
    }
    e.value = value.size() == member.size() ? value : std::vector<double>{};
    e.alpha_one = e.alpha_one && member.size() == 4 && has_alpha(member.substr(3));
    e.type = make_type(e.type.base, static_cast<int>(member.size()));
}

Expression Parser::postfix() {
    Expression e = primary();
    for (;;) {
        if (is("[")) {
            ++p_;
            const Expression index = expression();
            if (index.type.base == Base::real) convert(index, make_type(Base::integer), Due::operand);
            if (!accept("]")) break;
            if (e.type.dims > 0) {
                --e.type.dims;
                e.type.size = -1;
            } else if (e.type.cols > 1) {
                e.type = make_type(e.type.base, e.type.rows);
            } else if (e.type.rows > 1) {
                e.type = make_type(e.type.base);
                const bool alpha = index.value.size() != 1 || index.value[0] > 2.5;
                e.selection = alpha ? "?a" : "x";
            } else {
                e.type = {};
            }
            e.constant = e.constant && index.constant;
            e.value.clear();
            e.alpha_one = false;
            e.selected = true;
            e.last = p_ - 1;
        } else if (is(".") && token(1).kind == Kind::identifier) {
            const std::string_view member = text(1);
            p_ += 2;
            if (member == "length" && is("(")) {
                skip_balanced();
                const bool known = e.type.size > 0;
                e.value = known ? std::vector<double>{static_cast<double>(e.type.size)} : std::vector<double>{};
                e.constant = true;
                e.type = make_type(Base::integer);
                e.global = -1;
                e.legacy = {};
            } else {
                select(e, member);
            }
            e.last = p_ - 1;
        } else if (is("++") || is("--")) {
            note_write(e, nullptr, text());
            ++p_;
            e.last = p_ - 1;
            e.constant = false;
            e.value.clear();
        } else {
            break;
        }
    }
    return e;
}

Expression Parser::number() {
    Expression e;
    e.first = e.last = p_;
    const std::string_view t = text();
    if (token().kind == Kind::integer) {
        const bool uns = t.ends_with('u') || t.ends_with('U');
        e.type = make_type(uns ? Base::uinteger : Base::integer);
        long long v = 0;
        if (t.starts_with("0x") || t.starts_with("0X"))
            std::from_chars(t.data() + 2, t.data() + t.size(), v, 16);
        else
            std::from_chars(t.data(), t.data() + t.size(), v, t.size() > 1 && t[0] == '0' ? 8 : 10);
        e.value = {static_cast<double>(v)};
    } else {
        e.type = make_type(t.ends_with("lf") || t.ends_with("LF") ? Base::dreal : Base::real);
        double v = 0;
        std::from_chars(t.data(), t.data() + t.size(), v);
        e.value = {v};
    }
    ++p_;
    return e;
}

Expression Parser::primary() {
    const Token& t = token();
    Expression e;
    e.first = e.last = p_;
    if (t.kind == Kind::integer || t.kind == Kind::real) return number();
    if (t.text == "(") {
        const int first = p_;
        if (is(")", 2) && builtin_type(text(1)) && !find(text(1)) && token(3).kind != Kind::end && !is(";", 3))
            return cast();
        ++p_;
        e = expression();
        const bool alpha = e.alpha_one;
        accept(")");
        e.first = first;
        e.last = p_ - 1;
        e.alpha_one = alpha;
        return e;
    }
    if (t.kind != Kind::identifier) {
        e.constant = false;
        if (t.kind == Kind::other) ++p_;
        return e;
    }
    if (t.text == "true" || t.text == "false") {
        ++p_;
        e.type = make_type(Base::boolean);
        e.value = {t.text == "true" ? 1. : 0.};
        return e;
    }
    const Symbol* symbol = find(t.text);
    const bool hidden = symbol && !symbol->function;
    if (!hidden) {
        if (const auto type = builtin_type(t.text); type && (is("(", 1) || is("[", 1))) {
            ++p_;
            return constructor(*type, p_ - 1);
        }
        for (std::size_t n = 0; n < u_.structs.size(); ++n)
            if (u_.structs[n].name == t.text && (is("(", 1) || is("[", 1))) {
                Type type;
                type.base = Base::structure;
                type.structure = static_cast<std::int32_t>(n);
                type.name = t.text;
                ++p_;
                return constructor(type, p_ - 1);
            }
        if (is("(", 1)) return call(p_);
    } else if (is("(", 1) && !builtin_signatures(t.text).empty()) {
        return call(p_);
    }
    return name();
}

// (float) x, as C has it.
Expression Parser::cast() {
    const int first = p_;
    const Type type = *builtin_type(text(1));
    warn("c-cast", p_, "a cast in parentheses is C: read as " + std::string(type.name) + "(…)");
    p_ += 3;
    ++depth_;
    Expression e = depth_ > 200 ? Expression{} : unary();
    --depth_;
    if (e.last >= first + 3) {
        u_.replace(first, "");
        u_.replace(first + 2, "(");
        u_.edit(e.last).after += ")";
    }
    e.first = first;
    e.type = type;
    e.alpha_one = false;
    e.value.clear();
    e.global = -1;
    e.legacy = {};
    return e;
}

Expression Parser::name() {
    Expression e;
    e.first = e.last = p_;
    const std::string_view t = text();
    ++p_;
    e.constant = false;
    if (const Symbol* symbol = find(t); symbol && !symbol->function) {
        e.type = symbol->type;
        e.constant = symbol->constant;
        e.value = symbol->value;
        e.global = symbol->global;
        if (e.global >= 0) {
            Global& g = u_.globals[static_cast<std::size_t>(e.global)];
            g.uses.push_back(p_ - 1);
            g.read = true;
        }
        return e;
    }
    if (const LegacyName* legacy = legacy_name(t)) {
        e.legacy = t;
        if (const auto type = builtin_type(legacy->type)) e.type = *type;
        if (!legacy->struct_text.empty()) e.type = *legacy_structure(legacy->struct_text);
        if (legacy->size != 0) e.type.dims = legacy->size == -2 ? 2 : 1;
        e.constant = t.starts_with("gl_Max");
    }
    if (t == "gl_in" || t == "gl_out") e.type.dims = 1;
    return e;
}

std::vector<Expression> Parser::arguments() {
    std::vector<Expression> given;
    ++p_;  // (
    if (is("void") && is(")", 1)) ++p_;
    while (!at_end() && !is(")")) {
        const int before = p_;
        given.push_back(assignment());
        if (!accept(",")) break;
        if (p_ == before) ++p_;
    }
    if (!accept(")") && !at_end()) {
        // Not understood: go to the closing parenthesis, but not past the statement.
        int open = 1;
        while (!at_end() && !is(";") && !is("{") && !is("}") && open > 0) {
            if (is("(")) ++open;
            if (is(")")) --open;
            ++p_;
        }
    }
    return given;
}

Expression Parser::constructor(const Type& type, int first) {
    Expression e;
    e.type = type;
    e.first = first;
    if (is("[")) dimensions(e.type, nullptr);
    if (!is("(")) {
        e.last = p_ - 1;
        e.constant = false;
        return e;
    }
    const std::vector<Expression> given = arguments();
    e.last = p_ - 1;
    bool known = true;
    for (const Expression& a : given) {
        e.constant = e.constant && a.constant;
        known = known && !a.value.empty();
        if (known) e.value.insert(e.value.end(), a.value.begin(), a.value.end());
    }
    if (!known) e.value.clear();
    if (e.type.dims > 0) {
        Type element = e.type;
        --element.dims;
        for (const Expression& a : given) convert(a, element, Due::argument);
        if (e.type.size < 0) e.type.size = static_cast<std::int32_t>(given.size());
        return e;
    }
    if (type.base == Base::structure) {
        const Struct& s = u_.structs[static_cast<std::size_t>(type.structure)];
        for (std::size_t n = 0; n < given.size() && n < s.members.size(); ++n)
            convert(given[n], s.members[n].type, Due::argument);
        return e;
    }
    const std::size_t size = static_cast<std::size_t>(type.rows) * type.cols;
    if (type.rows == 4 && type.cols == 1 && !given.empty()) {
        const Expression& last = given.back();
        e.alpha_one =
            (!last.value.empty() && last.value.back() == 1 && (given.size() == 1 || last.type.scalar() || known)) ||
            (given.size() == 1 && last.alpha_one);
    }
    if (e.value.size() == 1 && size > 1) {
        const double v = e.value[0];
        e.value.assign(size, type.cols > 1 ? 0. : v);
        if (type.cols > 1)
            for (std::size_t n = 0; n < std::min(type.rows, type.cols); ++n) e.value[n * type.rows + n] = v;
    } else if (e.value.size() > size && type.cols == 1) {
        e.value.resize(size);
    } else if (e.value.size() != size) {
        e.value.clear();
    }
    if (type.integral())
        for (double& v : e.value) v = std::trunc(v);
    if (type.base == Base::boolean)
        for (double& v : e.value) v = v != 0;
    return e;
}

}  // namespace snell::glsl
