// Statements, and the values that variables may have after them.
#include "src/lint/walker.h"

#include <algorithm>

#include "src/glsl/read/tree.h"
#include "src/glsl/read/words.h"
#include "src/glsl/translate/program.h"

namespace snell::lint {

using glsl::Kind;
using glsl::Storage;

Walker::Walker(const glsl::Unit& unit, const Surroundings& around, const Varyings* given, Report report)
    : u_(unit), around_(around), given_(given), report_(std::move(report)) {
    if (u_.tree)
        for (const glsl::Node& node : *u_.tree)
            if (node.form == glsl::Form::call && node.function >= 0) overloads_.emplace(node.first, node.function);
    scopes_.emplace_back();
    for (const glsl::Global& g : u_.globals) {
        declare(g.name, seed(g));
        state_.slots.back().constant = g.qualifiers.storage == Storage::constant;
    }
    // Initialisers of constants are expressions of constants that stand before them.
    for (std::size_t i = 0; i < u_.globals.size(); ++i) {
        const glsl::Global& g = u_.globals[i];
        if (g.qualifiers.storage != Storage::constant || g.init_first < 0 || g.type.dims > 0) continue;
        p_ = g.init_first;
        const Expr e = assignment();
        state_.slots[i].value = e.v;
        state_.slots[i].value.type = g.type;
    }
}

Varyings Walker::run() {
    const glsl::Function* main = glsl::find_main(u_);
    if (!main || main->open < 0) return {};
    for (const glsl::Function& f : u_.functions) {
        if (&f == main || f.open < 0) continue;
        for (int k = f.open; k < f.close; ++k)
            if (glsl::assigns(u_.at(k + 1).text) && find(u_.at(k).text) >= 0) unstable_.insert(find(u_.at(k).text));
    }
    call_user(*main, {});
    if (ended_) state_ = merge(std::move(*ended_), state_);
    Varyings out;
    for (std::size_t i = 0; i < u_.globals.size(); ++i)
        if (u_.globals[i].qualifiers.storage == Storage::out) out.emplace(u_.globals[i].name, state_.slots[i].value);
    finish();
    return out;
}

const glsl::Token& Walker::token(int ahead) const {
    const auto i = static_cast<std::size_t>(p_ + ahead);
    return i < u_.tokens.size() ? u_.tokens[i] : u_.tokens.back();
}

int Walker::matching(int open) const {
    int depth = 0;
    const int end = static_cast<int>(u_.tokens.size()) - 1;
    for (int k = open; k < end; ++k) {
        const std::string_view t = u_.at(k).text;
        if (t == "(" || t == "[" || t == "{") ++depth;
        if (t == ")" || t == "]" || t == "}") --depth;
        if (depth <= 0) return k;
    }
    return end;
}

void Walker::block() {
    const int close = matching(p_);
    ++p_;
    scopes_.emplace_back();
    while (p_ < close && !at_end() && budget_ > 0) {
        const int before = p_;
        statement();
        if (p_ == before) ++p_;
    }
    scopes_.pop_back();
    p_ = close + 1;
}

Walker::State Walker::merge(State a, const State& b) const {
    if (a.dead) return b;
    if (b.dead) return a;
    a.slots.resize(std::min(a.slots.size(), b.slots.size()));
    for (std::size_t i = 0; i < a.slots.size(); ++i)
        if (a.slots[i].value.id != b.slots[i].value.id || a.slots[i].value.id == 0)
            a.slots[i].value = either(a.slots[i].value, b.slots[i].value);
    return a;
}

// A number that was compared with something is no longer known to be as small or as large as it may have been.
void Walker::condition_on(int first, int last) {
    for (int k = first; k <= last; ++k) {
        if (u_.at(k).kind != Kind::identifier) continue;
        conditions_.insert(u_.at(k).text);
        const int slot = find(u_.at(k).text);
        if (slot < 0 || state_.slots[static_cast<std::size_t>(slot)].constant) continue;
        Value& value = state_.slots[static_cast<std::size_t>(slot)].value;
        value.range = {};
        value.difference = {};
    }
}

void Walker::branch() {
    const int open = p_ + 1;
    const int close = matching(open);
    p_ = open + 1;
    const Expr condition = expression();
    p_ = close + 1;
    const bool varies = condition.v.varies == Varies::yes;
    condition_on(open + 1, close - 1);
    nonuniform_ += varies ? 1 : 0;
    const State before = state_;
    ++perhaps_;
    statement();
    State taken = std::move(state_);
    state_ = before;
    if (accept("else")) statement();
    --perhaps_;
    nonuniform_ -= varies ? 1 : 0;
    const bool ended = taken.dead || state_.dead;
    const bool returned = taken.returned || state_.returned;
    // If a path ended here, the rest runs under the condition, too.
    perhaps_ += ended ? 1 : 0;
    if (!ended)
        for (int k = open + 1; k < close; ++k)
            if (const auto found = conditions_.find(u_.at(k).text); found != conditions_.end())
                conditions_.erase(found);
    state_ = merge(std::move(taken), state_);
    if (returned && !state_.dead && varies && calling_.size() == 1) ++nonuniform_;
}

void Walker::forget(int slot) {
    Slot& s = state_.slots[static_cast<std::size_t>(slot)];
    if (s.constant) return;
    const glsl::Type type = s.value.type;
    s.value = Value{};
    s.value.type = type;
}

// Every variable that the tokens may assign.
void Walker::forget_assigned(int first, int last) {
    for (int k = first; k <= last && k + 1 < static_cast<int>(u_.tokens.size()); ++k) {
        const glsl::Token& t = u_.at(k);
        if (t.kind != Kind::identifier) continue;
        int next = k + 1;
        while (u_.at(next).text == "." || u_.at(next).text == "[") {
            next = u_.at(next).text == "." ? next + 2 : matching(next) + 1;
            if (next >= static_cast<int>(u_.tokens.size())) return;
        }
        const std::string_view after = u_.at(next).text, before = k > 0 ? u_.at(k - 1).text : std::string_view();
        const bool stepped = after == "++" || after == "--" || before == "++" || before == "--";
        const bool handed = (before == "(" || before == ",") && (after == ")" || after == ",");
        const int slot = find(t.text);
        if (slot >= 0 && (stepped || handed || glsl::assigns(after))) forget(slot);
    }
}

// The last token of the statement at `from`.
int Walker::statement_end(int from) const {
    const int end = static_cast<int>(u_.tokens.size()) - 1;
    for (int k = from; k < end; ++k) {
        const std::string_view t = u_.at(k).text;
        if (t == "{") return matching(k);
        if (t == "(" || t == "[") k = matching(k);
        if (t == ";") return k;
    }
    return end;
}

// An `if` ends with its last `else`.
int Walker::body_end(int from) const {
    int last = statement_end(from);
    while (last + 1 < static_cast<int>(u_.tokens.size()) && u_.at(last + 1).text == "else")
        last = statement_end(last + 2);
    return last;
}

void Walker::loop() {
    const bool counted = is("for");
    const int open = p_ + 1;
    const int close = matching(open);
    scopes_.emplace_back();
    p_ = open + 1;
    if (counted) {
        if (starts_declaration())
            local_declaration();
        else if (!accept(";")) {
            expression();
            accept(";");
        }
    }
    const int last = body_end(close + 1);
    int semicolon = p_;
    while (semicolon < close && u_.at(semicolon).text != ";") ++semicolon;
    const bool broken = counted && semicolon == close;
    const double rounds = broken ? 0 : rounds_of({p_, semicolon, semicolon + 1, close, close + 1, last});
    const double weight = weight_;
    go_round(rounds, open - 1, close);
    weight_ *= std::max(rounds, 1.0);
    forget_assigned(p_, last);
    const State before = state_;
    const Expr condition = is(";") ? Expr{} : expression();
    condition_on(open + 1, close - 1);
    const bool varies = condition.v.varies == Varies::yes;
    nonuniform_ += varies ? 1 : 0;
    p_ = close + 1;
    perhaps_ += rounds > 0 ? 0 : 1;
    statement();
    perhaps_ -= rounds > 0 ? 0 : 1;
    nonuniform_ -= varies ? 1 : 0;
    weight_ = weight;
    const int end = p_;
    state_ = before;
    forget_assigned(open + 1, last);
    scopes_.pop_back();
    p_ = end;
}

void Walker::do_loop() {
    const int body = ++p_, last = body_end(body), open = last + 2;
    const double weight = weight_;
    if (u_.at(last + 1).text == "while" && u_.at(open).text == "(") {
        const int close = matching(open);
        const double rounds = rounds_of(
            {.condition = open + 1, .condition_end = close, .body = body, .body_end = last, .at_least_once = true});
        go_round(rounds, open - 1, close);
        weight_ *= std::max(rounds, 1.0);
    }
    forget_assigned(body, last);
    statement();
    weight_ = weight;
    state_.dead = false;
    if (accept("while") && is("(")) p_ = matching(p_) + 1;
    accept(";");
}

void Walker::returns() {
    ++p_;
    if (!is(";")) {
        const Expr e = expression();
        result_ = result_ ? either(*result_, e.v) : e.v;
    }
    accept(";");
    if (calling_.size() == 1) ended_ = ended_ ? merge(std::move(*ended_), state_) : state_;
    state_.dead = state_.returned = true;
}

bool Walker::starts_declaration() const {
    if (token().kind != Kind::identifier) return false;
    const std::string_view t = text();
    if (glsl::is_qualifier(t) || t == "struct") return true;
    if (glsl::is_statement_word(t) || find(t) >= 0) return false;
    return token(1).kind == Kind::identifier && !glsl::is_statement_word(text(1));
}

void Walker::local_declaration() {
    while (glsl::is_qualifier(text())) {
        if (is("layout", 0) && is("(", 1)) p_ = matching(p_ + 1);
        ++p_;
    }
    const std::string_view type_name = text();
    if (type_name == "struct") {
        p_ = statement_end(p_) + 1;
        return;
    }
    glsl::Type type = glsl::builtin_type(type_name).value_or(glsl::Type{});
    ++p_;
    if (is("[")) {
        p_ = matching(p_) + 1;
        type.dims = 1;
    }
    while (token().kind == Kind::identifier) {
        const int name = p_;
        ++p_;
        glsl::Type own = type;
        if (is("[")) {
            p_ = matching(p_) + 1;
            own.dims = 1;
        }
        Value value;
        if (accept("=")) {
            const int first = p_;
            if (is("{"))
                p_ = matching(p_) + 1;
            else
                value = assignment().v;
            if (of_interest(first, p_ - 1)) made_.try_emplace(name, Unread{first, p_ - 1});
        }
        value.type = own;
        if (own.dims > 0) value = Value{}, value.type = own;
        declare(u_.at(name).text, value);
        if (!accept(",")) break;
    }
    if (!accept(";")) p_ = statement_end(p_) + 1;
}

void Walker::statement() {
    if (--budget_ < 0 || depth_ > 100) {
        p_ = statement_end(p_) + 1;
        return;
    }
    ++depth_;
    if (is("{")) {
        block();
    } else if (accept(";")) {
    } else if (is("if") && is("(", 1)) {
        branch();
    } else if ((is("for") || is("while")) && is("(", 1)) {
        loop();
    } else if (is("do")) {
        do_loop();
    } else if (is("switch") && is("(", 1)) {
        // Cases may follow one another in any way: nothing is known of what they assign.
        p_ = matching(p_ + 1) + 1;
        const int last = statement_end(p_);
        forget_assigned(p_, last);
        p_ = last + 1;
    } else if (is("return")) {
        returns();
    } else if (is("discard") || is("break") || is("continue")) {
        state_.dead = true;
        p_ = statement_end(p_) + 1;
    } else if (starts_declaration()) {
        local_declaration();
    } else {
        expression();
        if (!accept(";")) p_ = statement_end(p_) + 1;
    }
    --depth_;
}

}  // namespace snell::lint
