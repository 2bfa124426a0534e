// For read_outline(): what the names of a shader mean, in one walk over its tokens.
#pragma once

#include <optional>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "src/language/shader/outline.h"

namespace snell::language {

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

// Finds the declarations outside of directives, and what every name means.
inline void resolve_names(Outline& outline) { Resolver(outline).run(); }

}  // namespace snell::language
