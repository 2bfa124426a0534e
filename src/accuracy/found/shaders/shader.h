// How changes of shaders are found: a stage that is drawn, parsed, and the makers of each kind of change.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/found/change.h"
#include "src/glsl/read/token.h"
#include "src/glsl/read/tree.h"

namespace snell::accuracy {

// At most this many changes of shaders are offered for a scene. Where there are more, the kinds that have most lose
// those that come last in the texts.
inline constexpr std::size_t most_shader_changes = 200;
// At most this many expressions of a scene may be replaced by their means: each is drawn to find the mean.
inline constexpr std::size_t most_expression_means = 8;
// Programs with a longer stage, which no one has written, are left alone.
inline constexpr std::size_t most_tokens = 200'000;

// One stage of a program. Nodes are indices into `tree`, tokens into `unit`.
class Shader {
public:
    Shader(const Plan& plan, Index program, const glsl::StageInput& stage, Sources& sources,
           const glsl::IncludeReader& include);
    Shader(const Shader&) = delete;
    Shader& operator=(const Shader&) = delete;

    const glsl::Node& at(int node) const { return tree[static_cast<std::size_t>(node)]; }
    const glsl::Token& token(int token) const { return unit.at(token); }
    int parent(int node) const { return parents_[static_cast<std::size_t>(node)]; }
    std::vector<int> parts(int node) const { return glsl::parts(tree, node); }
    int nodes() const { return static_cast<int>(tree.size()); }
    // The node within parentheses.
    int bare(int node) const;

    // Whether the text from the first to the last token is the author's own, and is written there as it is read: no
    // macro, no directive and nothing of another file is in it.
    bool own(int first, int last) const;
    bool own(int node) const { return own(at(node).first, at(node).last); }
    Span span(int first, int last) const;
    Span span(int node) const { return span(at(node).first, at(node).last); }
    std::string text(const Span& span) const;
    std::string text(int node) const { return text(span(node)); }
    // The same tokens, whatever is between them.
    bool alike(int a, int b) const;
    // The function whose body holds the token, as an index into Unit::functions; -1: none.
    int function_of(int token) const;
    // The function main with its body, as function_of; -1: there is none.
    int main() const;
    // Whether a loop around the token may go round for ever if a number changes.
    bool in_free_loop(int token) const { return free_[static_cast<std::size_t>(token)]; }
    // The names that mean a variable, and where it is declared (-1: a parameter, or not known).
    const std::vector<int>& uses(int variable) const { return uses_[static_cast<std::size_t>(variable)]; }
    int declarator(int variable) const { return declarators_[static_cast<std::size_t>(variable)]; }
    // Whether something is stored where the name stands.
    bool written(int name) const;
    // Whether something is stored in the variable behind its declaration.
    bool changes(int variable) const { return changed_[static_cast<std::size_t>(variable)]; }
    // A place ahead of the function, for declarations; nothing if it is not in the author's text.
    std::optional<Span> ahead_of(int function) const;
    bool fragment() const { return unit.stage == Stage::fragment; }

    const Plan& plan;
    Index program;
    Sources& sources;
    glsl::Unit unit;
    glsl::Tree tree;
    std::vector<glsl::Define> defines;  // of ladders
    std::vector<FileId> files;          // for each of Unit::files, the first of the same name and text
    std::vector<bool> library;          // for each of Unit::files: snell's own, or not to be edited

private:
    void link();
    std::vector<int> parents_, functions_, declarators_;
    std::vector<std::vector<int>> uses_;
    std::vector<bool> free_, changed_;
};

// A loop that counts: for( init; name < bound; step ). What shrinks is `target`, down to `base`.
struct Counter {
    int comparison = -1;         // nodes
    int target = -1, base = -1;  // target: the bound, or the initial value where it counts down
    int advance = -1;            // ++, +=, …
    int variable = -1;           // Code::variables
    double step = 1;
    bool includes = false;  // <= or >=
};
// By its header, and by `if( name >= bound ) break;` in its body.
std::vector<Counter> counters(const Shader& shader, int loop);

// Collects changes, each once.
class Offers {
public:
    Offers(Sources& sources, std::vector<Change>& changes) : sources_(sources), changes_(changes) {}
    // The first of the places that are shown is that of the change. Insertions at one place are joined in their order.
    // Nothing is added if an edit is not possible, changes nothing, or was offered before.
    void add(ChangeKind kind, const std::vector<Span>& shown, std::vector<Edit> edits);
    void add(ChangeKind kind, const Span& where, std::vector<Edit> edits) {
        add(kind, std::vector<Span>{where}, std::move(edits));
    }
    // One that is complete but for its order.
    void add(Change change);
    // No more are taken: a text that has as many is not looked at to its end.
    bool full() const { return known_.size() >= 10 * most_shader_changes; }

private:
    Sources& sources_;
    std::vector<Change>& changes_;
    std::set<std::string> known_;
};

inline bool real_vector(const glsl::Type& t) { return t.base == glsl::Base::real && t.cols == 1 && t.dims == 0; }
inline Edit insertion(const Span& at, std::uint32_t offset, std::string text) {
    return {{at.file, offset, offset}, std::move(text)};
}
// Whether the text needs no parentheses, whatever stands next to it.
bool closed(const glsl::Node& node);
// A number as GLSL writes it for the type: 32, 32u, 32.
std::string literal(double value, const glsl::Type& type);

// Whether the author's main can be called by another one: its text can be edited.
bool has_own_main(const Shader& shader);
// What the colour is written to: a variable with four components; empty: that is not certain.
std::string colour_output(const Shader& fragment);
// Adds the edits that give the shader another main, which calls the author's, and then executes the statement.
void add_behind_main(const Shader& shader, const std::string& statement, std::vector<Edit>& edits);

// Means of textures from files, decoded once.
class Means {
public:
    Means(const Plan& plan, Files& files) : plan_(plan), files_(files) {}
    // Nothing if the texture has no files, is drawn to, or cannot be read.
    const std::optional<std::array<double, 4>>& of(Index texture);

private:
    const Plan& plan_;
    Files& files_;
    ImageCache cache_;
    std::map<Index, std::optional<std::array<double, 4>>> known_;
};

void add_rounds(const Shader& shader, Offers& offers);
void add_lower_levels(const Shader& control, Offers& offers);
void add_shorter_sums(const Shader& fragment, Offers& offers);
void add_lookups(const Shader& fragment, Means& means, Offers& offers);
// Until there are most_expression_means in all, those of the stage that take most work. `changes`: known ones, which
// have the means of textures. Their numbers are missing (Change::probes).
void add_expression_means(const Shader& fragment, const std::vector<Change>& changes, Offers& offers);
void add_polynomials(const Shader& fragment, Offers& offers);
void add_vertex_work(const Shader& vertex, const Shader& fragment, Offers& offers);

// The text of a polynomial: a GLSL function of that name and type, float or vec2 to vec4, behind a comment that states
// formula, range and bound. `function`: sin, cos, exp, acos, asin, atan or atan2.
struct Polynomial {
    std::string_view function;
    double from, to;  // the range of its argument for which the bound holds
    double bound;     // of the absolute error
    std::string_view text;
};
std::span<const Polynomial> polynomials();
std::string polynomial_text(std::string_view function, std::string_view name, std::string_view type);
// The same for pow with a constant exponent, for arguments from 0 to 1; and for exponents of at least 8 (`exponent`
// empty), which are the second argument. `bound` is 0 for exact products. Empty if there is none.
struct Power {
    std::string text;
    double bound = 0;
};
Power power_text(std::optional<double> exponent, std::string_view name, std::string_view type);

// Whether variables have a value where a statement is left out.

// Whether all of the variable was certainly written on every path from the function's begin to the token, which is
// outside of brackets. What only a call writes is not known.
bool surely_written(const glsl::Unit& unit, const glsl::Function& function, std::string_view name, int token);
// Whether without the assignment, a statement that begins with the token, its variable has as much of a value as
// before. `updates`: it reads what it changes, as += does.
bool can_go(const glsl::Unit& unit, const glsl::Function& function, int first, bool updates);

}  // namespace snell::accuracy
