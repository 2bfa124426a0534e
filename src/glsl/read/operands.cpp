// Operands: names, numbers, constructors, and what is selected from them.
#include <algorithm>
#include <charconv>
#include <cmath>

#include "parser/text/number.h"
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

void Parser::select(Expression& e, std::string_view member) {
    e.selected = true;
    emit(Op::select, 0, member);
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
        for (const Member& m : u_.structure(e.type).members)
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
    if (e.type.dims || e.type.cols > 1 || !e.type.basic() || member.size() > 4) {
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

// e[…], behind its bracket; false if the bracket is never closed.
bool Parser::index(Expression& e, bool& moves) {
    const Expression at = expression();
    if (at.type.base == Base::real) convert(at, make_type(Base::integer), Due::operand);
    moves = !at.constant;
    emit(Op::index);
    if (!accept("]")) {
        give_up();
        return false;
    }
    if (e.global >= 0 && !e.selected) {
        Global& g = u_.globals[static_cast<std::size_t>(e.global)];
        if (at.value.size() == 1 && at.value[0] < 1e6)
            g.most_index = std::max(g.most_index, static_cast<int>(at.value[0]));
        else
            g.indexed_freely = true;
    }
    if (e.type.dims > 0) {
        --e.type.dims;
        e.type.size = -1;
    } else if (e.type.cols > 1) {
        e.type = make_type(e.type.base, e.type.rows);
    } else if (e.type.rows > 1) {
        e.type = make_type(e.type.base);
        const bool alpha = at.value.size() != 1 || at.value[0] > 2.5;
        e.selection = alpha ? "?a" : "x";
    } else {
        e.type = {};
    }
    e.constant = e.constant && at.constant;
    e.value.clear();
    e.alpha_one = false;
    e.selected = true;
    return true;
}

// e.length(), behind its name.
void Parser::length(Expression& e) {
    emit(Op::length);
    skip_balanced();
    e.value = e.type.size > 0 ? std::vector<double>{static_cast<double>(e.type.size)} : std::vector<double>{};
    e.constant = true;
    e.type = make_type(Base::integer);
    e.no_variable();
}

Expression Parser::postfix() {
    const int begin = grown();
    Expression e = primary();
    e.step = here() - 1;
    const auto called = [&] {
        const Token& before = u_.at(std::max(p_ - 1, 0));
        return is("(") && p_ > 0 && (before.text == "]" || before.kind == Kind::integer || before.kind == Kind::real);
    };
    for (;;) {
        Form form = Form::other;
        std::string_view word;
        const bool constant = e.constant;
        bool moves = false;  // the index may differ
        if (accept("[")) {
            if (!index(e, moves)) break;
            form = Form::index;
        } else if (is(".") && token(1).kind == Kind::identifier) {
            const std::string_view member = text(1);
            p_ += 2;
            const bool asks = member == "length" && is("(");
            form = asks ? Form::length : Form::select;
            word = member;
            if (asks)
                length(e);
            else
                select(e, member);
        } else if (called()) {  // at least one driver does not survive this
            diagnostics_.error("not-a-function", u_.span(p_),
                               "the expression before this parenthesis is not a function");
            skip_balanced();
            give_up();
            e = Expression{};
            e.constant = false;
            continue;
        } else if (is("++") || is("--")) {
            note_operand(e, text());
            note_write(e, nullptr, text());
            emit(Op::step, 1, text());
            form = Form::step;
            word = text();
            ++p_;
            e.constant = false;
            e.value.clear();
        } else {
            break;
        }
        e.last = p_ - 1;
        e.step = here() - 1;
        if (moves && e.type.floating()) mark_kept(e, -1, constant);
        grow(form, begin, e, word);
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
        read_real(t.data(), t.data() + t.size(), v);
        e.value = {v};
    }
    emit(Op::number, 0, {}, e.type, e.value.front());
    grow(Form::number, grown(), e);
    ++p_;
    return e;
}

Expression Parser::primary() {
    const Token& t = token();
    Expression e;
    e.first = e.last = p_;
    if (t.kind == Kind::integer || t.kind == Kind::real) return number();
    if (t.text == "(") {
        const int first = p_, begin = grown();
        if (is(")", 2) && builtin_type(text(1)) && !find(text(1)) && token(3).kind != Kind::end && !is(";", 3))
            return cast();
        ++p_;
        e = expression();
        const bool alpha = e.alpha_one;
        accept(")");
        e.first = first;
        e.last = p_ - 1;
        e.alpha_one = alpha;
        grow(Form::group, begin, e);
        return e;
    }
    if (t.kind != Kind::identifier) {
        e.constant = false;
        emit(Op::unknown);
        give_up();
        grow(Form::other, grown(), e);
        if (t.kind == Kind::other) ++p_;
        return e;
    }
    if (t.text == "true" || t.text == "false") {
        ++p_;
        e.type = make_type(Base::boolean);
        e.value = {t.text == "true" ? 1. : 0.};
        emit(Op::number, 0, {}, e.type, e.value.front());
        grow(Form::number, grown(), e);
        return e;
    }
    const Symbol* symbol = find(t.text);
    const bool hidden = symbol && !symbol->function;
    if (!hidden) {
        if (const auto type = builtin_type(t.text); type && (is("(", 1) || is("[", 1))) {
            ++p_;
            return constructor(*type, p_ - 1);
        }
        if (const auto type = structure_named(t.text); type && (is("(", 1) || is("[", 1))) {
            ++p_;
            return constructor(*type, p_ - 1);
        }
        if (is("(", 1)) return call(p_);
    } else if (is("(", 1) && u_.function_names.contains(t.text)) {
        u_.shared_by_kinds.insert(t.text);
        return call(p_);
    } else if (is("(", 1) && !builtin_signatures(t.text).empty()) {
        return call(p_);
    }
    return name();
}

Expression Parser::name() {
    Expression e;
    e.first = e.last = p_;
    std::string_view t = text();
    ++p_;
    e.constant = false;
    const Symbol* symbol = find(t);
    if (const std::string_view meaning = gstap_meaning(t, u_.stage); !symbol && !meaning.empty()) {
        u_.tokens[static_cast<std::size_t>(e.first)].spelled = t;
        u_.tokens[static_cast<std::size_t>(e.first)].text = t = meaning;
    }
    if (symbol && !symbol->function) {
        if (symbol->variable >= 0)
            emit(Op::load, symbol->variable);
        else
            emit(Op::unknown);
        e.type = symbol->type;
        e.constant = symbol->constant;
        e.value = symbol->value;
        e.global = symbol->global;
        if (e.global >= 0) {
            Global& g = u_.globals[static_cast<std::size_t>(e.global)];
            g.uses.push_back(p_ - 1);
            g.read = true;
        }
        if (Node* node = grow(Form::name, grown(), e, t)) {
            node->global = e.global;
            node->variable = symbol->variable;
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
    if (e.legacy.empty()) {
        emit(Op::unknown);
    } else {
        const auto [known, fresh] = u_.built_ins.try_emplace(t, -1);
        if (fresh) {
            Type type = e.type;
            if (type.dims == 1) type.size = legacy_name(t)->size;
            known->second = variable(type);
        }
        emit(Op::load, known->second);
    }
    grow(Form::name, grown(), e, t);
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
        give_up();
        // The arguments were not understood: parsing resumes after the closing parenthesis, within the statement.
        int open = 1;
        while (!at_end() && !is(";") && !is("{") && !is("}") && open > 0) {
            if (is("(")) ++open;
            if (is(")")) --open;
            ++p_;
        }
    }
    return given;
}

Expression Parser::construction(const Type& type, int first) {
    Expression e;
    e.type = type;
    e.first = first;
    if (is("[")) dimensions(e.type, nullptr);
    if (!is("(")) {
        e.last = p_ - 1;
        e.constant = false;
        emit(Op::unknown);
        give_up();
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
        emit(Op::construct, static_cast<int>(given.size()), {}, e.type);
        if (settles_) constructed_[here() - 1] = given;
        return e;
    }
    emit(Op::construct, static_cast<int>(given.size()), {}, e.type);
    for (const Expression& a : given)
        if (type.floating() && !a.type.floating()) mark_kept(a, -1);
    if (type.base == Base::structure) {
        const Struct& s = u_.structure(type);
        for (std::size_t n = 0; n < given.size() && n < s.members.size(); ++n)
            convert(given[n], s.members[n].type, Due::argument);
        if (settles_) constructed_[here() - 1] = given;
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
