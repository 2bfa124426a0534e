// Statements in function bodies.
#include "src/glsl/read/parse.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

void Parser::compound() {
    ++p_;
    open_scope();
    while (!at_end() && !is("}")) {
        const int before = p_;
        statement();
        if (p_ == before) ++p_;
    }
    close_scope();
    accept("}");
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
    const int first = p_;
    const Qualifiers q = qualifiers();
    const std::optional<Type> type = type_specifier();
    if (!type) return skip_to_semicolon();
    Type base = *type;
    dimensions(base, nullptr);
    if (is("(", 1)) return local_prototype(base, first);
    declarators(q, base, {}, false);
}

// GLSL 1.10 allows prototypes within functions; they are moved ahead of the function.
void Parser::local_prototype(const Type& result, int first) {
    const int name = p_++;
    skip_balanced();
    if (!is(";")) return skip_to_semicolon();
    p_ = name;
    const std::size_t known = u_.functions.size();
    function(result, first, name);
    if (u_.functions.size() > known) u_.functions.back().local = true;
}

void Parser::for_statement() {
    p_ += 2;
    open_scope();
    if (starts_declaration()) {
        local_declaration();
    } else {
        if (!is(";")) expression();
        accept(";");
    }
    if (!is(";")) convert(expression(), make_type(Base::boolean), Due::condition);
    accept(";");
    if (!is(")")) expression();
    accept(")");
    statement();
    close_scope();
}

void Parser::statement() {
    if (depth_ > 200) return skip_balanced();
    ++depth_;
    if (is("{")) {
        compound();
    } else if (accept(";")) {
    } else if (is("if") || is("while") || is("switch")) {
        const bool condition = !is("switch");
        ++p_;
        open_scope();
        if (accept("(")) {
            if (starts_declaration()) {
                local_declaration();
            } else {
                const Expression e = expression();
                if (condition) convert(e, make_type(Base::boolean), Due::condition);
            }
            accept(")");
        }
        statement();
        close_scope();
        if (accept("else")) statement();
    } else if (is("for") && is("(", 1)) {
        for_statement();
    } else if (accept("do")) {
        statement();
        if (accept("while") && accept("(")) {
            convert(expression(), make_type(Base::boolean), Due::condition);
            accept(")");
        }
        accept(";");
    } else if (accept("return")) {
        if (!is(";")) {
            const Expression e = expression();
            convert(e, result_, Due::result);
        }
        accept(";");
    } else if (is("case")) {
        ++p_;
        expression();
        accept(":");
    } else if (is("default") || is("break") || is("continue") || is("discard")) {
        ++p_;
        if (!accept(";")) accept(":");
    } else if (starts_declaration()) {
        local_declaration();
    } else {
        expression();
        if (!accept(";") && !is("}")) {
            // The statement was not understood, or lacks its semicolon: parsing resumes after it.
            if (!starts_declaration() && !is_statement_word(text())) skip_to_semicolon();
        }
    }
    --depth_;
}

}  // namespace snell::glsl
