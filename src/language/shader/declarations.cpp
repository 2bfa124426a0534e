// The names: what is a declaration, and of what.
#include "src/language/shader/resolver.h"

#include "src/glsl/read/words.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Role = ShaderToken::Role;

}  // namespace

void Resolver::identifier(ShaderToken& token) {
    const std::string_view text = o_.word(token);
    if (text == "struct") return struct_word();
    if (text == "for" || text == "while") for_ = true;
    if (token.role == Role::word) return qualifier(text);
    if (previous() == ".") {
        token.role = Role::member;
        return;
    }
    const bool continues = std::exchange(another_, false) && previous() == ",";
    if (continues) return declare(token, declaring_.type);
    if (const auto type = type_before()) return declare(token, *type);
    if (qualified_.any() && next() == "{" && current_ == 0 && instance_ < 0) return block_name(token);
    use(token);
}

void Resolver::qualifier(std::string_view text) {
    if (text == "uniform" || text == "buffer") qualified_.uniform = true;
    if (text == "in" || text == "inout") qualified_.in = true;
    if (text == "out") qualified_.out = true;
    if (text == "varying") qualified_.varying = true;
    if (text == "attribute") qualified_.attribute = true;
    if (text == "const") qualified_.constant = true;
}

void Resolver::struct_word() {
    const std::size_t name = after(i_);
    structure_ = Opening::structure;
    structure_owner_ = -1;
    if (name >= o_.tokens.size() || o_.tokens[name].kind != glsl::Kind::identifier) return;
    structure_owner_ = add(name, Kind::structure, {}, current_ > 0);
    if (current_ > 0) show(structure_owner_);
    previous_ = i_;
    i_ = name;
}

void Resolver::block_name(ShaderToken& token) {
    structure_owner_ = add(i_, Kind::block, {}, false);
    token.role = Role::global;
    structure_ = Opening::block;
}

bool Resolver::is_type(std::size_t token) const {
    if (token == nothing_ || o_.tokens[token].kind != glsl::Kind::identifier) return false;
    const std::string_view text = word(token);
    if (glsl::builtin_type(text) || !glsl::foreign_type(text).empty() || text == "void") return true;
    if (o_.tokens[token].role == Role::word || o_.tokens[token].role == Role::member) return false;
    if (o_.tokens[token].declares) return false;
    const std::size_t left = before(token);
    if (left == nothing_) return true;
    const std::string_view boundary = word(left);
    return boundary == ";" || boundary == "{" || boundary == "}" || boundary == ")" || boundary == "(" ||
           boundary == "," || glsl::is_qualifier(boundary);
}

// The type that is the word before this one, with its dimensions.
std::optional<std::string_view> Resolver::type_before() const {
    if (previous_ == nothing_) return std::nullopt;
    if (previous() == "}" && instance_ >= 0) return declaration(instance_).name;
    std::size_t first = previous_;
    if (previous() == "]") {
        for (int steps = 0; first != nothing_ && word(first) != "["; first = before(first))
            if (word(first) == ";" || word(first) == "{" || ++steps > most_dimension_steps_) return std::nullopt;
        first = before(first);
    }
    if (!is_type(first)) return std::nullopt;
    const std::uint32_t begin = o_.tokens[first].begin;
    const bool known = o_.tokens[first].role == Role::word;
    const std::uint32_t until = known ? o_.tokens[previous_].end : o_.tokens[i_].begin;
    if (o_.text.substr(begin, until - begin).find('\n') != std::string_view::npos) return std::nullopt;
    return o_.text.substr(begin, o_.tokens[previous_].end - begin);
}

Kind Resolver::kind_here() const {
    const Scope& here = scopes_[static_cast<std::size_t>(current_)];
    if (here.kind == Scope::Kind::structure && !here.members_global) return Kind::member;
    if (here.kind == Scope::Kind::function) return Kind::parameter;
    if (current_ > 0 && here.kind != Scope::Kind::structure)
        return qualified_.constant ? Kind::constant : Kind::variable;
    const Qualified& q = here.kind == Scope::Kind::structure ? here.qualified : qualified_;
    if (q.uniform) return Kind::uniform;
    if (q.varying) return Kind::varying;
    if (q.attribute || q.in) return Kind::input;
    if (q.out) return Kind::output;
    return q.constant ? Kind::constant : Kind::variable;
}

void Resolver::declare(ShaderToken& token, std::string_view type) {
    if (next() == "(" && current_ == 0 && !declaring_.active) {
        function_ = add(i_, Kind::function, type, false);
        return;
    }
    const Kind kind = kind_here();
    const bool local = current_ > 0 && scope().kind != Scope::Kind::structure;
    if (kind == Kind::member) token.role = Role::member;
    declaring_ = {kind != Kind::parameter, kind, type, brackets_.size(), current_};
    if (local && same_scope(token)) return;
    const int index = add(i_, kind, type, local);
    declaration(index).array = next() == "[" || type.ends_with(']');
    if (kind == Kind::member && scope().owner >= 0) declaration(index).owner = declaration(scope().owner).name;
    if (local) pending_.push_back(index);
    if (kind == Kind::parameter) flush();
}

// Another branch of a conditional declared the same name: both mean one variable.
bool Resolver::same_scope(ShaderToken& token) {
    const auto found = locals_.find(o_.word(token));
    if (found == locals_.end() || found->second.empty()) return false;
    const int index = found->second.back();
    if (scope_of_[static_cast<std::size_t>(index)] != current_) return false;
    token.role = Role::local;
    token.declares = true;
    token.declaration = index;
    return true;
}

int Resolver::add(std::size_t at, Kind kind, std::string_view type, bool local) {
    ShaderToken& token = o_.tokens[at];
    const int index = static_cast<int>(o_.declarations.size());
    o_.declarations.push_back({.kind = kind,
                               .local = local,
                               .name = o_.word(token),
                               .type = type,
                               .token = static_cast<std::uint32_t>(at),
                               .begin = statement_ == none_ ? token.begin : std::min(statement_, token.begin),
                               .end = token.end,
                               .visible_from = token.end,
                               .visible_to = static_cast<std::uint32_t>(o_.text.size())});
    token.declares = true;
    token.declaration = index;
    if (kind != Kind::member) token.role = local ? Role::local : Role::global;
    scope_of_.push_back(local ? current_ : -1);
    if (local) scope().declarations.push_back(index);
    return index;
}

// A name is visible behind its initialiser.
void Resolver::flush() {
    for (const int index : pending_) {
        if (previous_ != nothing_)
            declaration(index).visible_from = std::max(declaration(index).visible_from, o_.tokens[previous_].end);
        declaration(index).end = declaration(index).visible_from;
        show(index);
    }
    pending_.clear();
}

void Resolver::use(ShaderToken& token) {
    if (current_ == 0) return;
    const auto found = locals_.find(o_.word(token));
    if (found == locals_.end()) return;
    const std::uint32_t first = scope().function_begin;
    for (auto it = found->second.rbegin(); it != found->second.rend(); ++it) {
        if (declaration(*it).visible_from < first) return;
        if (!encloses(scope_of_[static_cast<std::size_t>(*it)])) continue;
        token.role = Role::local;
        token.declaration = *it;
        return;
    }
}

bool Resolver::encloses(int wanted) const {
    int at = current_;
    while (at > wanted) at = scopes_[static_cast<std::size_t>(at)].parent;
    return at == wanted;
}

}  // namespace snell::language
