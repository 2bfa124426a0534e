// Statements in function bodies.
#include <algorithm>

#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

void Parser::compound() {
    const int first = p_, begin = grown();
    ++p_;
    open_scope();
    while (!at_end() && !is("}")) {
        const int before = p_;
        statement();
        if (p_ == before) ++p_;
    }
    close_scope();
    accept("}");
    grow_statement(Form::block, begin, first);
}

// The statement that another one holds: one node of the tree.
void Parser::inner_statement() {
    const int first = p_, begin = grown();
    statement();
    if (u_.tree && (grown() == begin || u_.tree->back().begin != begin)) grow_statement(Form::block, begin, first);
}

bool Parser::starts_declaration() const {
    if (token().kind != Kind::identifier) return false;
    const std::string_view t = text();
    if (is_qualifier(t) || t == "struct") return true;
    if (is_statement_word(t)) return false;
    const Symbol* symbol = find(t);
    if (symbol && !symbol->function) return false;
    if (token(1).kind == Kind::identifier) return !is_statement_word(text(1));
    if (!is("[", 1)) return false;
    int k = 1, open = 0;
    do {
        if (is("[", k)) ++open;
        if (is("]", k)) --open;
        ++k;
    } while ((open > 0 || is("[", k)) && token(k).kind != Kind::end);
    return token(k).kind == Kind::identifier;
}

void Parser::local_declaration() {
    const int first = p_, begin = grown();
    const Qualifiers q = qualifiers();
    leave_old_words(first);
    const std::optional<Type> type = type_specifier();
    if (!type) {
        give_up();
        return skip_to_semicolon();
    }
    Type base = *type;
    dimensions(base, nullptr);
    if (is("(", 1)) return local_prototype(base, first);
    declarators(q, base, {}, false);
    grow_statement(Form::declaration, begin, first);
}

// GLSL 1.10 allows prototypes within functions; they are moved ahead of the function.
void Parser::local_prototype(const Type& result, int first) {
    const int name = p_++;
    skip_balanced();
    if (!is(";")) {
        give_up();
        return skip_to_semicolon();
    }
    p_ = name;
    const std::size_t known = u_.functions.size();
    function(result, first, name);
    if (u_.functions.size() > known) u_.functions.back().local = true;
}

void Parser::jump_out(bool repeat) {
    const auto loop =
        std::find_if(leaving_.rbegin(), leaving_.rend(), [&](const Leaving& l) { return !repeat || l.value < 0; });
    if (loop == leaving_.rend()) return give_up();
    (repeat ? loop->continues : loop->breaks).push_back(emit(Op::jump));
}

// `continue` goes on at `again`, `break` behind the loop.
void Parser::close_loop(int again, int out) {
    if (out >= 0) land(out);
    for (const int jump : leaving_.back().breaks) land(jump);
    for (const int jump : leaving_.back().continues) u_.code.steps[static_cast<std::size_t>(jump)].a = again;
    leaving_.pop_back();
}

void Parser::condition() {
    const int begin = grown();
    if (!accept("(")) {
        grow_empty();
        return give_up();
    }
    if (starts_declaration()) {
        local_declaration();
        give_up();
    } else {
        convert(expression(), make_type(Base::boolean), Due::condition);
    }
    if (grown() == begin) grow_empty();
    accept(")");
}

void Parser::for_statement() {
    const int first = p_, begin = grown();
    p_ += 2;
    open_scope();
    if (starts_declaration()) {
        local_declaration();
    } else {
        if (!is(";")) expression(), emit(Op::drop);
        accept(";");
    }
    if (grown() == begin) grow_empty();
    const int test = here();
    int out = -1;
    if (is(";")) {
        grow_empty();
    } else {
        convert(expression(), make_type(Base::boolean), Due::condition);
        out = emit(Op::unless);
    }
    accept(";");
    const int in = emit(Op::jump), again = here();
    if (is(")"))
        grow_empty();
    else
        expression(), emit(Op::drop);
    emit(Op::jump, test);
    accept(")");
    land(in);
    leaving_.emplace_back();
    inner_statement();
    emit(Op::jump, again);
    close_loop(again, out);
    close_scope();
    grow_statement(Form::loop, begin, first, "for");
}

void Parser::if_statement() {
    const int first = p_, begin = grown();
    ++p_;
    open_scope();
    condition();
    const int otherwise = emit(Op::unless);
    inner_statement();
    close_scope();
    if (accept("else")) {
        const int end = emit(Op::jump);
        land(otherwise);
        inner_statement();
        land(end);
    } else {
        land(otherwise);
    }
    grow_statement(Form::branch, begin, first);
}

void Parser::while_statement() {
    const int first = p_, begin = grown();
    ++p_;
    open_scope();
    const int again = here();
    condition();
    const int out = emit(Op::unless);
    leaving_.emplace_back();
    inner_statement();
    emit(Op::jump, again);
    close_loop(again, out);
    close_scope();
    grow_statement(Form::loop, begin, first, "while");
}

void Parser::do_statement() {
    const int first = p_ - 1, begin = grown();
    const int start = here();
    leaving_.emplace_back();
    inner_statement();
    const int again = here();
    if (accept("while")) {
        condition();
    } else {
        grow_empty();
        give_up();
    }
    const int out = emit(Op::unless);
    emit(Op::jump, start);
    close_loop(again, out);
    accept(";");
    grow_statement(Form::loop, begin, first, "do");
}

void Parser::switch_statement() {
    const int first = p_, begin = grown();
    ++p_;
    open_scope();
    Leaving cases;
    if (!is("(")) grow_empty();
    if (accept("(")) {
        const Expression e = expression();
        cases.value = variable(e.type);
        if (e.type.integral()) mark_decision(e);
        emit(Op::declare, cases.value, {}, 1);
        accept(")");
    }
    cases.test = emit(Op::jump);
    leaving_.push_back(std::move(cases));
    inner_statement();
    const int last = leaving_.back().test;
    if (last >= 0) land(last);
    close_loop(0, -1);
    close_scope();
    grow_statement(Form::choice, begin, first);
}

// A label: what comes from above passes the test, which leads to the next label.
void Parser::case_label(bool other) {
    ++p_;
    if (leaving_.empty() || leaving_.back().value < 0 || leaving_.back().test < 0) give_up();  // or behind `default`
    const int fall = emit(Op::jump);
    if (!leaving_.empty() && leaving_.back().test >= 0) {
        land(leaving_.back().test);
        leaving_.back().test = -1;
    }
    if (!other) {
        emit(Op::load, leaving_.empty() ? 0 : std::max(leaving_.back().value, 0));
        expression();
        emit(Op::infix, 0, "==");
        const int test = emit(Op::unless);
        if (!leaving_.empty()) leaving_.back().test = test;
    }
    land(fall);
    accept(":");
}

// Statements that hold no other ones.
void Parser::simple_statement() {
    const int first = p_, begin = grown();
    if (accept("return")) {
        const bool value = !is(";");
        if (value) {
            const Expression e = expression();
            convert(e, result_, Due::result);
            mark_kept(e, here());
        }
        emit(Op::back, value ? 1 : 0);
        accept(";");
        grow_statement(Form::returned, begin, first);
    } else if (is("case") || is("default")) {
        case_label(is("default"));
        grow_statement(Form::label, begin, first);
    } else if (is("break") || is("continue") || is("discard")) {
        const std::string_view word = text();
        if (word == "discard")
            emit(Op::discard);
        else
            jump_out(word == "continue");
        ++p_;
        if (!accept(";")) accept(":");
        grow_statement(Form::jump, begin, first, word);
    } else if (starts_declaration()) {
        local_declaration();
    } else {
        expression();
        emit(Op::drop);
        if (!accept(";") && !is("}")) {
            give_up();
            // The statement was not understood, or lacks its semicolon: parsing resumes after it.
            if (!starts_declaration() && !is_statement_word(text())) skip_to_semicolon();
        }
        grow_statement(Form::evaluated, begin, first);
    }
}

void Parser::statement() {
    if (depth_ > 200) {
        give_up();
        return skip_balanced();
    }
    ++depth_;
    if (is("{")) {
        compound();
    } else if (accept(";")) {
    } else if (is("if")) {
        if_statement();
    } else if (is("while")) {
        while_statement();
    } else if (is("switch")) {
        switch_statement();
    } else if (is("for") && is("(", 1)) {
        for_statement();
    } else if (accept("do")) {
        do_statement();
    } else {
        simple_statement();
    }
    --depth_;
}

}  // namespace snell::glsl
