// What the names of a shader mean, in one walk over its tokens.
#include <optional>

#include "src/glsl/read/words.h"
#include "src/language/shader/outline.h"

namespace snell::language {

namespace {

using Kind = ShaderDeclaration::Kind;
using Role = ShaderToken::Role;

struct Qualified {
    bool uniform = false, in = false, out = false, varying = false, attribute = false, constant = false;
    bool any() const { return uniform || in || out || varying || attribute || constant; }
};

struct Scope {
    enum class Kind : std::uint8_t { global, function, block, loop, structure };
    Kind kind = Kind::global;
    int parent = -1;
    bool header_done = false;          // of a function or a loop: its parentheses are closed
    std::size_t depth = 0;             // of brackets around the header
    std::uint32_t function_begin = 0;  // of the outermost scope that is not global
    int owner = -1;                    // of a function, a structure or a block: its declaration
    bool members_global = false;       // of a block without an instance
    Qualified qualified;               // of a structure or a block: the qualifiers before it
    std::vector<int> declarations;
};

// What a comma continues.
struct Declaring {
    bool active = false;
    ShaderDeclaration::Kind kind = ShaderDeclaration::Kind::variable;
    std::string_view type;
    std::size_t depth = 0;
    int scope = 0;
};

// Where #if begins, and what #else goes back to.
struct Saved {
    int scope = 0;
    std::vector<char> brackets;
    Qualified qualified;
};

class Resolver {
public:
    explicit Resolver(Outline& outline) : o_(outline), scopes_(1) { scope_of_.assign(o_.declarations.size(), -1); }

    void run();

private:
    using Kind = ShaderDeclaration::Kind;

    static constexpr std::uint32_t none_ = ~std::uint32_t{0};
    static constexpr std::size_t nothing_ = ~std::size_t{0};
    // Of a look back over the dimensions of an array, and ahead over a block, however odd the text.
    static constexpr int most_dimension_steps_ = 50, most_block_steps_ = 1000;

    Scope& scope() { return scopes_[static_cast<std::size_t>(current_)]; }
    const ShaderDeclaration& declaration(int index) const { return o_.declarations[static_cast<std::size_t>(index)]; }
    ShaderDeclaration& declaration(int index) { return o_.declarations[static_cast<std::size_t>(index)]; }

    std::string_view word(std::size_t token) const;
    std::string_view previous() const { return word(previous_); }
    std::size_t before(std::size_t token) const;
    std::size_t after(std::size_t token) const;
    std::string_view next() const { return word(after(i_)); }

    void in_directive(ShaderToken& token);

    // ---- scopes
    void open_scope(Scope::Kind kind, std::uint32_t begin, int owner = -1);
    void close_scope(std::uint32_t at);
    void end_statement();
    void close_loops(std::uint32_t at);

    // ---- brackets
    void punctuation(const ShaderToken& token);
    void pop_bracket(char open);
    void open_parenthesis(const ShaderToken& token);
    void close_parenthesis(const ShaderToken& token);
    void layout();
    void open_brace(const ShaderToken& token);
    void close_brace(const ShaderToken& token);
    void comma();
    void semicolon(const ShaderToken& token);

    // ---- structures and blocks
    bool instance_follows() const;
    void open_structure(const ShaderToken& token);
    void close_structure(const ShaderToken& token);

    // ---- names
    void identifier(ShaderToken& token);
    void qualifier(std::string_view text);
    void struct_word();
    void block_name(ShaderToken& token);
    bool is_type(std::size_t token) const;
    std::optional<std::string_view> type_before() const;
    Kind kind_here() const;
    void declare(ShaderToken& token, std::string_view type);
    bool same_scope(ShaderToken& token);
    int add(std::size_t at, Kind kind, std::string_view type, bool local);
    void flush();
    void show(int index) { locals_[declaration(index).name].push_back(index); }
    void use(ShaderToken& token);
    bool encloses(int wanted) const;

    Outline& o_;
    std::vector<Scope> scopes_;
    std::vector<int> scope_of_;  // of Outline::declarations; -1: global, or a macro's
    std::unordered_map<std::string_view, std::vector<int>> locals_;
    int current_ = 0;
    std::size_t i_ = 0, previous_ = nothing_;
    std::uint32_t statement_ = none_;  // where the current one begins
    std::vector<char> brackets_;
    Qualified qualified_;
    Declaring declaring_;
    std::vector<int> pending_;
    std::vector<Saved> conditionals_;
    int function_ = -1;     // whose parentheses come next
    bool for_ = false;      // or while: a loop's parentheses come next
    bool another_ = false;  // a comma: another name of the same type comes next
    enum class Opening : std::uint8_t { none, structure, block };
    Opening structure_ = Opening::none;  // what the next brace opens
    int structure_owner_ = -1;
    int instance_ = -1;  // the structure or block that was closed in this statement
};

}  // namespace

// The walk: scopes by brackets, statements by semicolons, branches of conditionals.

void Resolver::run() {
    for (i_ = 0; i_ < o_.tokens.size(); ++i_) {
        ShaderToken& token = o_.tokens[i_];
        if (token.in_directive) {
            in_directive(token);
            continue;
        }
        if (statement_ == none_) statement_ = token.begin;
        if (token.kind == glsl::Kind::identifier)
            identifier(token);
        else if (token.kind == glsl::Kind::punct)
            punctuation(token);
        previous_ = i_;
    }
    flush();
    while (current_ > 0) close_scope(static_cast<std::uint32_t>(o_.text.size()));
}

std::string_view Resolver::word(std::size_t token) const {
    return token < o_.tokens.size() ? o_.word(o_.tokens[token]) : std::string_view();
}

std::size_t Resolver::before(std::size_t token) const {
    while (token != nothing_ && token > 0)
        if (!o_.tokens[--token].in_directive) return token;
    return nothing_;
}

std::size_t Resolver::after(std::size_t token) const {
    for (++token; token < o_.tokens.size(); ++token)
        if (!o_.tokens[token].in_directive) return token;
    return o_.tokens.size();
}

void Resolver::in_directive(ShaderToken& token) {
    if (token.role == Role::global && i_ > 0 && o_.tokens[i_ - 1].in_directive && word(i_ - 1) == ".")
        token.role = Role::member;
    if (token.role != Role::directive) return;
    const std::string_view name = o_.word(token);
    if (name == "if" || name == "ifdef" || name == "ifndef") {
        conditionals_.push_back({current_, brackets_, qualified_});
    } else if ((name == "else" || name == "elif") && !conditionals_.empty()) {
        flush();
        current_ = conditionals_.back().scope;
        brackets_ = conditionals_.back().brackets;
        qualified_ = conditionals_.back().qualified;
        declaring_ = {};
    } else if (name == "endif" && !conditionals_.empty()) {
        conditionals_.pop_back();
    }
}

void Resolver::open_scope(Scope::Kind kind, std::uint32_t begin, int owner) {
    Scope made;
    made.kind = kind;
    made.parent = current_;
    made.function_begin = current_ > 0 ? scope().function_begin : begin;
    made.owner = owner;
    made.depth = brackets_.size();
    current_ = static_cast<int>(scopes_.size());
    scopes_.push_back(std::move(made));
}

void Resolver::close_scope(std::uint32_t at) {
    flush();
    for (const int index : scope().declarations) declaration(index).visible_to = at;
    if (scope().kind == Scope::Kind::function && scope().owner >= 0 && scope().header_done)
        declaration(scope().owner).end = at;
    current_ = scope().parent;
}

void Resolver::end_statement() {
    flush();
    declaring_ = {};
    qualified_ = {};
    statement_ = none_;
    for_ = false;
}

// The loops whose only statement ends here.
void Resolver::close_loops(std::uint32_t at) {
    while (scope().kind == Scope::Kind::loop && scope().header_done && next() != "else") close_scope(at);
}

void Resolver::punctuation(const ShaderToken& token) {
    if (token.end - token.begin != 1) return;
    switch (o_.text[token.begin]) {
        case '(':
            return open_parenthesis(token);
        case ')':
            return close_parenthesis(token);
        case '[':
            return brackets_.push_back('[');
        case ']':
            return pop_bracket('[');
        case '{':
            return open_brace(token);
        case '}':
            return close_brace(token);
        case ',':
            return comma();
        case ';':
            return semicolon(token);
        default:
            return;
    }
}

void Resolver::pop_bracket(char open) {
    if (!brackets_.empty() && brackets_.back() == open) brackets_.pop_back();
}

void Resolver::open_parenthesis(const ShaderToken& token) {
    if (previous() == "layout") return layout();
    if (function_ >= 0) {
        declaration(function_).parameters_begin = token.end;
        declaration(function_).parameters_end = token.end;
        open_scope(Scope::Kind::function, token.begin, function_);
        function_ = -1;
        qualified_ = {};
        declaring_ = {};
    } else if (for_) {
        open_scope(Scope::Kind::loop, token.begin);
        for_ = false;
    }
    brackets_.push_back('(');
}

void Resolver::close_parenthesis(const ShaderToken& token) {
    pop_bracket('(');
    Scope& here = scope();
    const bool header = !here.header_done && brackets_.size() == here.depth;
    if (header && here.kind == Scope::Kind::loop) {
        flush();
        here.header_done = true;
        declaring_ = {};
        qualified_ = {};
    } else if (header && here.kind == Scope::Kind::function) {
        declaration(here.owner).parameters_end = token.begin;
        declaration(here.owner).end = token.end;
        here.header_done = next() == "{";
        declaration(here.owner).body = here.header_done;
        if (!here.header_done) close_scope(token.end);
    }
}

// layout(location = N): words of the language, but for what they are set to.
void Resolver::layout() {
    std::size_t depth = 1;
    while (depth > 0) {
        const std::size_t at = after(i_);
        if (at >= o_.tokens.size() || word(at) == ";" || word(at) == "{") return;
        previous_ = i_;
        i_ = at;
        if (word(at) == "(") ++depth;
        if (word(at) == ")") --depth;
        if (o_.tokens[at].kind == glsl::Kind::identifier && previous() != "=") o_.tokens[at].role = Role::word;
    }
}

void Resolver::open_brace(const ShaderToken& token) {
    if (structure_ != Opening::none) return open_structure(token);
    const std::string_view behind = previous();
    if (declaring_.active && (behind == "=" || behind == "," || behind == "{" || behind == "(")) {
        brackets_.push_back('{');
        return;
    }
    end_statement();
    instance_ = -1;
    brackets_.clear();
    open_scope(Scope::Kind::block, token.begin);
}

void Resolver::close_brace(const ShaderToken& token) {
    if (!brackets_.empty() && brackets_.back() == '{') return brackets_.pop_back();
    brackets_.clear();
    const Scope::Kind kind = scope().kind;
    if (kind == Scope::Kind::structure) return close_structure(token);
    end_statement();
    if (kind == Scope::Kind::loop || (kind == Scope::Kind::function && !scope().header_done)) {
        while (current_ > 0 && scope().kind != Scope::Kind::block) close_scope(token.end);  // a broken text
    }
    if (current_ > 0) close_scope(token.end);
    if (scope().kind == Scope::Kind::function) close_scope(token.end);
    close_loops(token.end);
}

void Resolver::comma() {
    if (declaring_.active && brackets_.size() == declaring_.depth && current_ == declaring_.scope) {
        flush();
        another_ = true;
    } else if (scope().kind == Scope::Kind::function && !scope().header_done) {
        qualified_ = {};
    }
}

void Resolver::semicolon(const ShaderToken& token) {
    if (scope().kind == Scope::Kind::loop && !scope().header_done) {
        flush();
        declaring_ = {};
        return;
    }
    if (scope().kind == Scope::Kind::function && !scope().header_done) close_scope(token.begin);  // a broken text
    brackets_.clear();
    end_statement();
    structure_ = Opening::none;
    instance_ = -1;
    close_loops(token.end);
}

bool Resolver::instance_follows() const {
    std::size_t at = after(i_);
    for (int steps = 0; at < o_.tokens.size() && word(at) != "}"; at = after(at))
        if (++steps > most_block_steps_) return false;
    at = after(at);
    return at < o_.tokens.size() && o_.tokens[at].kind == glsl::Kind::identifier;
}

void Resolver::open_structure(const ShaderToken& token) {
    const bool global = std::exchange(structure_, Opening::none) == Opening::block && !instance_follows();
    open_scope(Scope::Kind::structure, token.begin, structure_owner_);
    scope().members_global = global;
    scope().qualified = qualified_;
    brackets_.clear();
    end_statement();
}

void Resolver::close_structure(const ShaderToken& token) {
    instance_ = scope().owner;
    const Qualified qualified = scope().qualified;
    if (instance_ >= 0) declaration(instance_).end = token.end;
    end_statement();
    close_scope(token.end);
    qualified_ = qualified;
}

// The names: what is a declaration, and of what.

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

void resolve_names(Outline& outline) { Resolver(outline).run(); }

}  // namespace snell::language
