// Walks one stage as it would run, from main(), with what is known of each value.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/glsl/read/token.h"
#include "src/lint/lint.h"
#include "src/lint/value.h"

namespace snell::lint {

// What the scene says that bears on a program's shaders.
struct Surroundings {
    struct Uniform {
        Range range;                    // of the slider or the value
        std::optional<double> current;  // of a single number
        Span span;                      // in the scene
    };
    std::map<std::string, Uniform, std::less<>> uniforms;  // that the scene sets
    std::set<std::string, std::less<>> mipmapped;          // samplers on such textures
    double eye_turn = 0;                                   // degrees that LookAt turns the eye by, at most
    bool cube_faces = false;                               // it draws into the faces of a cube map
    double far_turn = 0;  // degrees by which rounding turns differences of positions in the world, at most
};

using Varyings = std::map<std::string_view, Value>;

class Walker {
public:
    // A finding: the tokens it is at, and one line.
    using Report = std::function<void(Rule rule, int first, int last, std::string message, std::vector<Note> notes)>;

    // `given`: outputs of the vertex stage, for the fragment stage; nothing where other stages are between.
    Walker(const glsl::Unit& unit, const Surroundings& around, const Varyings* given, Report report);
    // Outputs, as main leaves them.
    Varyings run();

private:
    struct Slot {
        Value value;
        bool constant = false;
    };
    struct Expr {
        Value v;
        int slot = -1;  // the variable it is, or is a part of
        bool whole = true;
        int first = -1, last = -1;  // tokens
        Cosine factor = {};         // its last factor is 1 plus such a cosine,
        int factor_first = -1;      // which begins at this token
    };
    // What the branches of the program so far have left.
    struct State {
        std::vector<Slot> slots;
        bool dead = false;      // behind return, discard, break, continue
        bool returned = false;  // behind return
    };

    // statements (walker.cpp)
    void statement();
    void block();
    void branch();
    void loop();
    void do_loop();
    void returns();
    void local_declaration();
    bool starts_declaration() const;
    void forget_assigned(int first, int last);
    void forget(int slot);
    State merge(State a, const State& b) const;
    void condition_on(int first, int last);
    int statement_end(int from) const;
    int body_end(int from) const;
    bool of_interest(int first, int last) const;

    // how often loops go round (loops.cpp)
    bool leaves(int first, int last) const;
    bool assigned(std::string_view name, int first, int last) const;
    double step_of(std::string_view name, int first, int last) const;
    double body_step(std::string_view name, int first, int last) const;
    struct Loop {
        int condition, condition_end;  // first token, and one behind the last
        int step = 0, step_end = 0;    // of `for`; none: the body steps
        int body, body_end;            // first and last token
        bool at_least_once = false;
    };
    bool stays(std::string_view name, const Loop& loop) const;
    double rounds_of(const Loop& loop);
    void go_round(double rounds, int first, int last);

    // expressions (expressions.cpp)
    Expr expression();
    Expr assignment();
    Expr ternary();
    Expr binary(int least);
    Expr unary();
    Expr postfix();
    Expr primary();
    Expr name();
    Expr number();
    void assign(Expr& target, const Expr& value, std::string_view op);
    void select(Expr& e, std::string_view member);
    Value combine(const Value& a, const Value& b, std::string_view op);
    Value add(const Value& a, const Value& b, bool minus);
    Value multiply(const Value& a, const Value& b);
    Value negate(const Value& v);
    static void note_difference(Value& v, const Expr& a, const Expr& b);
    Value built_in(std::string_view name) const;
    Value constructed(const glsl::Type& type, const std::vector<Expr>& given);

    // calls (calls.cpp, optics.cpp)
    Expr call();
    std::vector<Expr> arguments();
    Value call_user(const glsl::Function& f, const std::vector<Expr>& given);
    const glsl::Function* find_function(int name, std::size_t arguments) const;
    Value call_builtin(std::string_view name, const std::vector<Expr>& given, int first, int last);
    std::optional<Value> call_number(std::string_view name, const std::vector<Expr>& given);
    Value call_dot(const std::vector<Expr>& given);
    Value call_reflect(const std::vector<Expr>& given);
    Value call_refract(const std::vector<Expr>& given);
    Value call_texture(std::string_view name, const std::vector<Expr>& given, int first, int last);
    void want_width(const std::vector<Expr>& given, int first, int last);
    void want_near(const Expr& left, const Expr& right);
    void note_factor(Expr& left, const Expr& right);
    void call_pow(const std::vector<Expr>& given, int first, int last);
    bool compared(int first, int last) const;
    void want_unit(const Expr& e, std::string_view function, std::string_view role);
    void want_ratio(const std::vector<Expr>& given);
    void note_channel(const Value& v, std::string_view channel, int token);
    void finish();

    // names
    int find(std::string_view name) const;
    void declare(std::string_view name, Value value);
    Value seed(const glsl::Global& global) const;
    int fresh() { return ++ids_; }
    std::string words(int first, int last) const;  // the text of tokens, for messages
    Span span(int first, int last) const;          // of their text
    void report(Rule rule, int first, int last, std::string message, std::vector<Note> notes = {});

    std::string_view text(int ahead = 0) const { return token(ahead).text; }
    const glsl::Token& token(int ahead = 0) const;
    bool is(std::string_view t, int ahead = 0) const { return text(ahead) == t; }
    bool accept(std::string_view t) {
        if (!is(t)) return false;
        ++p_;
        return true;
    }
    bool at_end() const { return token().kind == glsl::Kind::end; }
    int matching(int open) const;  // the closing bracket's token

    const glsl::Unit& u_;
    const Surroundings& around_;
    const Varyings* given_;
    Report report_;
    int p_ = 0;
    int depth_ = 0;
    int budget_ = 300'000;  // tokens looked at: calls are walked anew each time
    int ids_ = 0;
    State state_;
    std::vector<std::map<std::string_view, int>> scopes_;
    std::size_t frame_ = 1;                       // the first scope of the function being walked
    std::vector<const glsl::Function*> calling_;  // from main on
    std::map<int, int> overloads_;                // Unit::functions that calls mean, by their name's token
    std::optional<Value> result_;                 // of the function being walked, so far
    std::optional<State> ended_;                  // what main left where it returned early
    std::set<int> unstable_;                      // global variables that functions assign
    double rounds_ = 0, weight_ = 1;              // of all loops so far; of those around
    bool told_rounds_ = false;
    int perhaps_ = 0;     // branches, and loops of unknown rounds, around: what stands there may never run
    int nonuniform_ = 0;  // branches around that only some fragments take
    std::multiset<std::string_view> conditions_;  // names in conditions around, or behind which some path ended

    struct Schlick {
        int first, last;
        Cosine cosine;
    };
    std::vector<Schlick> schlicks_;
    std::map<int, int> incident_;  // vectors that point at the surface (1) or away from it (-1), by id
    struct Channel {
        Bend bend;
        int token;
    };
    std::map<int, std::map<char, Channel>> channels_;  // by base of the bend
    struct Unread {
        int first, last;
    };
    std::map<int, Unread> made_;  // locals of interest by their name's token
};

}  // namespace snell::lint
