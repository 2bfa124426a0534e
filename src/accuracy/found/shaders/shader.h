// How changes of shaders are found: the stages of a scene, parsed, what can be asked of their expressions, and the
// makers of each kind of change.
#pragma once

#include <algorithm>
#include <array>
#include <deque>
#include <initializer_list>
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

// One stage of the programs that have it. Nodes are indices into `tree`, tokens into `unit`.
class Shader {
public:
    Shader(const Plan& plan, const glsl::StageInput& stage, Sources& sources, const glsl::Options& options);
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
    // The place of the tokens in the author's text. There may be macros between the first and the last one.
    std::optional<Span> place(int first, int last) const;
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
    // Whether the program may run the token, as far as calls and conditions of constants tell: not within a function
    // that main never reaches, nor in an arm that the chosen rungs leave out.
    bool runs(int token) const { return !idle_[static_cast<std::size_t>(token)]; }
    // The names that mean a variable, and where it is declared (-1: a parameter, or not known).
    const std::vector<int>& uses(int variable) const { return uses_[static_cast<std::size_t>(variable)]; }
    int declarator(int variable) const { return declarators_[static_cast<std::size_t>(variable)]; }
    // Whether something is stored where the name stands.
    bool written(int name) const;
    // Whether something is stored in the variable behind its declaration.
    bool changes(int variable) const { return changed_[static_cast<std::size_t>(variable)]; }
    // The statement around a node; the loop, or the node itself if it is one; -1: there is none.
    int statement(int node) const;
    int loop_around(int node) const;
    const glsl::Function& function(int index) const { return unit.functions[static_cast<std::size_t>(index)]; }
    // The expressions within functions that were understood, in the order of the text, outermost first.
    const std::vector<int>& expressions() const { return expressions_; }
    // Whether all of an expression was understood.
    bool understood(int node) const { return depths_[static_cast<std::size_t>(node)] > 0; }
    // A place ahead of the function, for declarations; nothing if it is not in the author's text.
    std::optional<Span> ahead_of(int function) const;
    bool fragment() const { return unit.stage == Stage::fragment; }

    const Plan& plan;
    std::set<Index> programs;
    Sources& sources;
    glsl::Unit unit;
    glsl::Tree tree;
    std::vector<glsl::Define> defines;  // of ladders
    std::vector<FileId> files;          // for each of Unit::files, the first of the same name and text
    std::vector<bool> library;          // for each of Unit::files: snell's own, or not to be edited

private:
    void link();
    void link_expressions();
    void link_calls();
    std::vector<int> parents_, functions_, declarators_, expressions_, depths_;
    std::vector<std::vector<int>> uses_;
    std::vector<bool> free_, changed_, idle_;
};

// An expression of a shader; none where something in it was not understood.
class Expression {
public:
    Expression() = default;
    Expression(const Shader& shader, int node) : s_(&shader), node_(shader.understood(node) ? node : -1) {}
    // The outermost one that begins with the token.
    static Expression at(const Shader& shader, int token);

    explicit operator bool() const { return node_ >= 0; }
    int node() const { return node_; }
    int first() const { return *this ? s_->at(node_).first : -1; }
    int last() const { return *this ? s_->at(node_).last : -1; }
    glsl::Type type() const { return *this ? s_->at(node_).type : glsl::Type(); }
    // The name, number or operator, the function of a call or the member of a selection, as written.
    std::string_view text() const;
    std::size_t size() const { return *this ? s_->parts(node_).size() : 0; }
    Expression operator[](std::size_t part) const;  // none if there are fewer
    // What is within the brackets around it.
    Expression bare() const { return *this ? Expression(*s_, s_->bare(node_)) : *this; }
    // What it has as its value, if it is a local variable in which nothing else is ever stored; none otherwise.
    Expression initial() const;
    // Where that leads to, at most four times; otherwise itself. Without brackets.
    Expression resolved() const;

    bool is(glsl::Form form, std::string_view text = {}) const {
        return *this && s_->at(node_).form == form && (text.empty() || this->text() == text);
    }
    bool name() const { return is(glsl::Form::name); }
    bool infix(std::string_view op) const { return is(glsl::Form::infix, op); }
    bool call() const { return is(glsl::Form::call) || is(glsl::Form::built_in) || is(glsl::Form::construct); }
    bool call(std::string_view name, std::size_t arguments) const {
        return call() && text() == name && size() == arguments;
    }
    // A call of one of these functions.
    bool calls(std::initializer_list<std::string_view> names) const {
        return call() && std::find(names.begin(), names.end(), text()) != names.end();
    }
    std::optional<double> number() const;
    // The same tokens, brackets around them aside.
    bool same(const Expression& other) const;

private:
    const Shader* s_ = nullptr;
    int node_ = -1;
};
// Calls `each` for the expression and all within it, outermost first.
template <class Each>
void for_each(const Expression& expression, const Each& each) {
    each(expression);
    for (std::size_t part = 0; part < expression.size(); ++part) for_each(expression[part], each);
}

// That of one kind; null if there is none.
const Shader* stage_of(const std::vector<const Shader*>& stages, Stage stage);

// A scene with the stages of all its programs that can be read, equal ones once. `sources` gets the texts of included
// shaders.
struct Reading {
    Reading(const Plan& plan, Files& files, Sources& sources);
    // Those of a program, in the order of the pipeline.
    std::vector<const Shader*> stages(Index program) const;

    const Plan& plan;
    Files& files;
    Sources& sources;
    std::deque<Shader> shaders;
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

using Edits = std::vector<Edit>;

// Collects changes, each once.
class Offers {
public:
    // At most `most` changes are added.
    Offers(const Files& files, const Sources& sources, std::vector<Change>& changes, std::size_t most);

    // The first of the places that are shown is that of the change. Returns false, and adds nothing, if an edit is of a
    // text that is not the author's, edits overlap or change nothing, or the same were offered before.
    bool add(ChangeKind kind, const std::vector<Span>& shown, Edits edits, std::string_view lint = {});
    bool add(ChangeKind kind, const Span& where, Edits edits, std::string_view lint = {}) {
        return add(kind, std::vector<Span>{where}, std::move(edits), lint);
    }
    // One that is complete but for its order.
    void add(Change change);
    // No more are taken: a text that has as many is not looked at to its end.
    bool full() const { return left_ == 0; }

    // The same place in the first of several readings of the file.
    Span first_reading(Span span) const { return {accuracy::first_reading(span.file, sources_), span.begin, span.end}; }
    std::string_view text(Span span) const {
        return sources_.text(span.file).substr(span.begin, span.end - span.begin);
    }
    const Sources& sources() const { return sources_; }

private:
    const Sources& sources_;
    std::vector<Change>& changes_;
    std::size_t left_;
    std::set<std::string, std::less<>> names_;  // of texts that belong to the scene
    std::set<std::string> known_;
};

inline bool real_vector(const glsl::Type& t) { return t.base == glsl::Base::real && t.cols == 1 && t.dims == 0; }
inline Edit insertion(const Span& at, std::uint32_t offset, std::string text) {
    return {{at.file, offset, offset}, std::move(text)};
}
inline Edit before(const Span& at, std::string text) { return insertion(at, at.begin, std::move(text)); }
inline Edit after(const Span& at, std::string text) { return insertion(at, at.end, std::move(text)); }
// Whether the text needs no parentheses, whatever stands next to it.
bool closed(const glsl::Node& node);
// A number as GLSL writes it for the type: 32, 32u, 32.
std::string literal(double value, const glsl::Type& type);

// How a stage declares a varying: by `direction`, in or out, or as old shaders do.
std::string_view varying_word(const Shader& shader, std::string_view direction);

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

// The parts of find_changes. Shaders: those that make shaders cheaper.
void add_scene_changes(const Reading& reading, std::vector<Change>& changes);
void add_better_changes(const Reading& reading, std::vector<Change>& changes);
void add_shader_changes(const Reading& reading, std::vector<Change>& changes);
void add_omissions(const Reading& reading, std::vector<Change>& changes);

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

// Whether all of the variable was certainly written on every path from the function's begin to the token, which is
// outside of brackets. What only a call writes is not known.
bool surely_written(const glsl::Unit& unit, const glsl::Function& function, std::string_view name, int token);
// Whether without the assignment, a statement that begins with the token, its variable has as much of a value as
// before. `updates`: it reads what it changes, as += does.
bool can_go(const glsl::Unit& unit, const glsl::Function& function, int first, bool updates);

}  // namespace snell::accuracy
