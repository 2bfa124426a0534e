// Declarations outside functions.
#include "src/glsl/read/parse.h"

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/glsl/read/macro.h"
#include "src/glsl/read/words.h"

namespace snell::glsl {

// Functions may be called above their definition: their results' types are known then too.
void Parser::foresee() {
    int depth = 0;
    for (int i = 0; i + 2 < static_cast<int>(u_.tokens.size()); ++i) {
        const std::string_view t = u_.at(i).text;
        if (t == "{") ++depth;
        if (t == "}") --depth;
        if (depth || u_.at(i).kind != Kind::identifier || u_.at(i + 1).kind != Kind::identifier ||
            u_.at(i + 2).text != "(")
            continue;
        if (const auto type = builtin_type(t)) foreseen_.try_emplace(u_.at(i + 1).text, *type);
    }
}

void Parser::run() {
    foresee();
    u_.code.steps.reserve(u_.tokens.size());
    open_scope();
    while (!at_end()) {
        const int before = p_;
        external();
        if (p_ == before) ++p_;
    }
}

void Parser::declare(std::string_view name, Symbol symbol) {
    const auto it = symbols_.find(name);
    undo_.back().emplace_back(name, it == symbols_.end() ? std::nullopt : std::optional<Symbol>(it->second));
    symbols_[name] = std::move(symbol);
}

void Parser::close_scope() {
    for (auto it = undo_.back().rbegin(); it != undo_.back().rend(); ++it) {
        if (it->second) {
            symbols_[it->first] = std::move(*it->second);
        } else {
            symbols_.erase(it->first);
        }
    }
    undo_.pop_back();
}

const Parser::Symbol* Parser::find(std::string_view name) const {
    const auto it = symbols_.find(name);
    return it == symbols_.end() ? nullptr : &it->second;
}

void Parser::skip_balanced() {
    int open = 0;
    while (!at_end()) {
        const std::string_view t = text();
        if (t == "(" || t == "[" || t == "{") ++open;
        if (t == ")" || t == "]" || t == "}") --open;
        ++p_;
        if (open <= 0) return;
    }
}

void Parser::skip_to_semicolon() {
    const int first = p_;
    while (!at_end() && !is(";") && !is("}")) {
        if (is("(") || is("[") || is("{")) {
            skip_balanced();
        } else {
            ++p_;
        }
    }
    accept(";");
    leave_old_words(first);
}

void Parser::skip_declaration(int first) {
    give_up();
    skip_to_declaration();
    leave_old_words(first);
}

void Parser::leave_old_words(int first) {
    for (int k = first; k < p_; ++k) {
        const std::string_view word = u_.at(k).text;
        if (word != "attribute" && word != "varying") continue;
        const std::string_view next = u_.at(k + 1).text;
        const bool given = word == "attribute" || u_.stage == Stage::fragment;
        u_.replace(k, next == "in" || next == "out" ? "" : given ? "in" : "out");
    }
}

void Parser::skip_to_declaration() {
    while (!at_end() && !is(";")) {
        if (is("{")) {
            skip_balanced();
            return;
        }
        if (is("(") || is("[")) {
            skip_balanced();
        } else {
            ++p_;
        }
    }
    accept(";");
}

bool Parser::layout(Qualifiers& q) {
    ++p_;
    if (!accept("(")) return false;
    while (!at_end() && !is(")")) {
        LayoutItem item;
        item.name = lowered(text());
        ++p_;
        if (accept("=")) {
            while (!at_end() && !is(",") && !is(")")) {
                if (is("(")) {
                    const int from = p_;
                    skip_balanced();
                    for (int k = from; k < p_; ++k) item.value += u_.at(k).text;
                } else {
                    item.value += token().text;
                    ++p_;
                }
            }
        }
        q.layout.push_back(std::move(item));
        accept(",");
    }
    return accept(")");
}

Qualifiers Parser::qualifiers() {
    Qualifiers q;
    q.first = p_;
    for (;;) {
        const std::string_view t = text();
        if (token().kind != Kind::identifier || !is_qualifier(t)) break;
        if (t == "layout") {
            if (!layout(q)) break;
            continue;
        }
        ++p_;
        if (t == "const") q.constant = true;
        if (t == "in") q.storage = q.storage == Storage::out ? Storage::inout : Storage::in;
        if (t == "out") q.storage = q.storage == Storage::in ? Storage::inout : Storage::out;
        if (t == "in" || t == "out") q.directed = true;
        if (t == "inout") q.storage = Storage::inout;
        if (t == "uniform") q.storage = Storage::uniform;
        if (t == "buffer") q.storage = Storage::buffer;
        if (t == "shared") q.storage = Storage::shared;
        if (t == "attribute") q.attribute = true;
        if (t == "varying") q.varying = true;
        if (t == "flat" || t == "smooth" || t == "noperspective") q.interpolation = t;
        if (t == "centroid" || t == "sample" || t == "patch") q.auxiliary = t;
        if (t == "highp" || t == "mediump" || t == "lowp") q.precision = t;
        if (t == "invariant") q.invariant = true;
        if (t == "precise") {
            q.precise = true;
            if (!target_.has_precise()) u_.replace(p_ - 1, "");
        }
        if (t == "coherent" || t == "volatile" || t == "restrict" || t == "readonly" || t == "writeonly")
            q.memory += std::string(t) + " ";
    }
    q.last = p_ - 1;
    if (q.attribute) q.storage = Storage::in;
    if (q.varying && q.storage == Storage::plain) q.storage = u_.stage == Stage::fragment ? Storage::in : Storage::out;
    if (q.constant && q.storage == Storage::plain) q.storage = Storage::constant;
    return q;
}

std::optional<Type> Parser::type_specifier() {
    if (is("struct")) return structure();
    if (token().kind != Kind::identifier) return std::nullopt;
    if (const auto type = builtin_type(text())) {
        ++p_;
        return type;
    }
    if (const auto type = structure_named(text())) {
        const Symbol* hidden = find(text());
        if (hidden && !hidden->function) return std::nullopt;  // a variable of the same name
        ++p_;
        return type;
    }
    if (const std::string_view legacy = legacy_struct_text(text()); !legacy.empty()) {
        ++p_;
        return legacy_structure(legacy);
    }
    if (token(1).kind == Kind::identifier && !is_statement_word(text()) && !is_qualifier(text())) {
        Type type;
        type.name = text();
        ++p_;
        return type;
    }
    return std::nullopt;
}

// `struct NAME { TYPE MEMBER; … };` of the language's own.
std::optional<Type> Parser::legacy_structure(std::string_view declaration) {
    const std::vector<MacroToken> t = macro_tokens(declaration);
    if (const auto known = structure_named(t[1].text)) return known;
    Struct s;
    s.name = t[1].text;
    for (std::size_t k = 3; k + 2 < t.size(); k += 3)
        if (const auto member = builtin_type(t[k].text)) s.members.push_back({t[k + 1].text, *member});
    u_.structs.push_back(std::move(s));
    return structure_named(t[1].text);
}

std::optional<Type> Parser::structure_named(std::string_view name) const {
    const auto found = ranges::find(u_.structs, name, &Struct::name);
    if (found == u_.structs.end()) return std::nullopt;
    Type type;
    type.base = Base::structure;
    type.structure = static_cast<std::int32_t>(found - u_.structs.begin());
    type.name = name;
    return type;
}

std::optional<Type> Parser::structure() {
    ++p_;
    Type type;
    type.base = Base::structure;
    Struct s;
    if (token().kind == Kind::identifier) {
        s.name = text();
        ++p_;
    }
    type.name = s.name;
    type.structure = static_cast<std::int32_t>(u_.structs.size());
    u_.structs.push_back(std::move(s));
    if (!is("{")) return type;
    if (depth_ > 100) {
        skip_balanced();
        return type;
    }
    ++depth_;
    members(type.structure, nullptr);
    --depth_;
    return type;
}

// Members between braces, from `{` to behind `}`.
void Parser::members(int structure, std::vector<std::pair<int, int>>* tokens) {
    ++p_;
    while (!at_end() && !is("}")) {
        const int first = p_;
        qualifiers();
        const std::optional<Type> type = type_specifier();
        if (!type) {
            skip_to_semicolon();
            if (p_ == first) ++p_;
            continue;
        }
        Type base = *type;
        dimensions(base, nullptr);
        while (token().kind == Kind::identifier) {
            Member m{text(), base};
            ++p_;
            dimensions(m.type, nullptr);
            u_.structs[static_cast<std::size_t>(structure)].members.push_back(m);
            if (!accept(",")) break;
        }
        skip_to_semicolon();
        if (tokens) tokens->emplace_back(first, p_ - 1);
        if (p_ == first) ++p_;
    }
    accept("}");
}

// Array dimensions; added to the type, and to `written` as they stand.
int Parser::dimensions(Type& type, std::string* written) {
    int count = 0;
    while (is("[")) {
        const int open = p_;
        ++p_;
        std::int32_t size = -1;
        if (!is("]")) {
            const Expression e = expression();
            emit(Op::drop);
            if (e.value.size() == 1 && e.value[0] >= 0 && e.value[0] < 1e6)
                size = static_cast<std::int32_t>(e.value[0]);
        }
        if (!is("]")) {
            p_ = open;
            skip_balanced();
        } else {
            ++p_;
        }
        if (written)
            for (int k = open; k < p_; ++k) *written += u_.now(k);
        if (count++ == 0) type.size = size;
        if (type.dims < 8) ++type.dims;
    }
    return count;
}

void Parser::block(const Qualifiers& q, int first) {
    Block b;
    b.qualifiers = q;
    b.first = first;
    b.name = text();
    ++p_;
    b.open = p_;
    Struct s;
    s.name = u_.keep("{" + std::string(b.name) + "}");  // never found as a type
    const auto structure = static_cast<std::int32_t>(u_.structs.size());
    u_.structs.push_back(s);
    members(structure, &b.member_tokens);
    b.close = p_ - 1;
    b.members = u_.structs[static_cast<std::size_t>(structure)].members;
    Type type;
    type.base = Base::structure;
    type.structure = structure;
    if (token().kind == Kind::identifier) {
        b.instance = text();
        ++p_;
        b.arrayed = dimensions(type, nullptr) > 0;
        if (b.arrayed) give_up();
        b.variable = variable(type);
        declare(b.instance, {type, -1, b.variable, false, false, {}});
    } else {
        b.variable = static_cast<int>(u_.code.variables.size());
        for (const Member& m : b.members) declare(m.name, {m.type, -1, variable(m.type), false, false, {}});
    }
    skip_to_semicolon();
    b.last = p_ - 1;
    u_.blocks.push_back(std::move(b));
}

void Parser::external() {
    const int first = p_;
    if (accept(";")) {  // belongs to nothing; not every version allows it
        u_.replace(first, "");
        return;
    }
    if (is("precision")) return skip_to_semicolon();
    const Qualifiers q = qualifiers();
    if (is(";")) {  // layout(…) in;
        ++p_;
        u_.layouts.push_back({q, p_ - 1});
        return;
    }
    const bool interface = q.storage == Storage::in || q.storage == Storage::out || q.storage == Storage::uniform ||
                           q.storage == Storage::buffer;
    if (interface && token().kind == Kind::identifier && is("{", 1) && !is("struct")) return block(q, first);
    if (p_ > first && (q.invariant || q.precise) && token().kind == Kind::identifier && (is(";", 1) || is(",", 1))) {
        skip_to_semicolon();
        u_.redeclared.emplace_back(first, p_ - 1);  // invariant gl_Position;
        return;
    }
    Group group;
    group.first = first;
    group.type_first = p_;
    group.defines_struct = is("struct");
    std::optional<Type> type = type_specifier();
    if (!type && is("main") && is("(", 1)) {
        diagnostics_.warning("untyped-main", u_.span(p_), "main wants 'void' before it");
        u_.edit(p_).before = "void ";
        return function(make_type(Base::none), p_, p_);
    }
    if (!type) return skip_declaration(first);
    group.type_last = p_ - 1;
    Type base = *type;
    if (is("[")) {
        dimensions(base, nullptr);
        group.type_last = p_ - 1;
    }
    if (accept(";")) {  // struct X { … };
        if (group.defines_struct) u_.erase(first, group.type_first - 1);
        return;
    }
    if (token().kind == Kind::identifier && is("(", 1)) return function(base, first, p_);
    declarators(q, base, group, true);
}

}  // namespace snell::glsl
