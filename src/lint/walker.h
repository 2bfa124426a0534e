// Walks one stage as it would run, from main(), with what is known of each value. Everything unknown is the default.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/glsl/read/token.h"
#include "src/glsl/read/tree.h"
#include "src/lint/lint.h"

namespace snell::lint {

enum class Length : std::uint8_t { unknown, unit, other };
enum class Why : std::uint8_t { none, interpolated, position, sum };  // of Length::other
enum class Space : std::uint8_t { unknown, any, object, world, eye };
enum class Varies : std::uint8_t { unknown, no, yes };  // between the fragments of one draw

// Bounds of every component. A bound is `real` where values near it do occur; else it is only not exceeded.
struct Range {
    double lo = -std::numeric_limits<double>::infinity(), hi = std::numeric_limits<double>::infinity();
    bool real_lo = false, real_hi = false;
    bool operator==(const Range&) const = default;
};

inline Range exactly(double v) { return {v, v, true, true}; }
inline Range between(double lo, double hi) { return {lo, hi, true, true}; }
Range sum(const Range& a, const Range& b);
Range negative(const Range& a);
Range product(const Range& a, const Range& b, bool square);
Range larger(const Range& a, const Range& b);
Range smaller(const Range& a, const Range& b);
Range either(const Range& a, const Range& b);

// sign * dot(first, second), of vectors by identity.
struct Cosine {
    int first = 0, second = 0, sign = 0;
    bool operator==(const Cosine&) const = default;
};

// refract() with eta = base + shift, base by identity.
struct Bend {
    int base = 0;
    double shift = 0;
    int first = -1, last = -1;  // tokens of the eta that refract() was given
    bool operator==(const Bend& o) const { return base == o.base && shift == o.shift; }
};

// The difference of two things that no constant is among, perhaps times or over what keeps one sign.
struct Difference {
    int first = -1, last = -1;  // tokens
    bool turned = false;        // its negative
    bool operator==(const Difference&) const = default;
};

struct Value {
    glsl::Type type;
    int id = 0;             // equal for copies of one value
    int opposite = 0;       // the id that this is the negative of
    std::string_view name;  // of the varying or attribute that it came from

    // vectors
    Length length = Length::unknown;
    Why why = Why::none;
    Space space = Space::unknown;
    bool point = false;      // a position, or the direction to it from the origin of its space
    bool plain = false;      // not multiplied by anything that was computed
    bool refracted = false;  // made from a result of refract()
    bool from_eye = false;   // a result of reflect() or refract() of a position in eye coordinates
    int mirrored = 0;        // the direction that reflect() was given, by id
    int mirrored_opposite = 0;

    // matrices
    Space from = Space::unknown, to = Space::unknown;

    // numbers
    Range range;
    Difference difference;
    int uniform = -1;         // it is that uniform itself: Unit::globals
    Cosine cosine, one_plus;  // it is such a cosine; 1 plus such a cosine
    Bend eta, bend;           // it is such an eta; a direction or a colour got with such an eta

    Varies varies = Varies::unknown;
};

// What is known when it may be either.
Value either(const Value& a, const Value& b);
Varies together(Varies a, Varies b);
// A direction or a position, as far as is known; a colour is not.
bool spatial(const Value& v);

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

// Nobody goes round so often to count.
constexpr double very_many = 1e6;
constexpr double endless = std::numeric_limits<double>::infinity();

// Whether a comparison holds.
bool holds(double left, std::string_view op, double right);

class Walker {
public:
    // A finding: the tokens it is at, and one line.
    using Report = std::function<void(Rule rule, int first, int last, std::string message, std::vector<Note> notes)>;

    // `given`: outputs of the vertex stage, for the fragment stage; nothing where other stages are between.
    // The unit has its tree.
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
        int slot = -1;  // Code::variables: the one it is, or is a part of
        bool whole = true;
        int first = -1, last = -1;  // tokens
        Cosine factor = {};         // its last factor is 1 plus such a cosine,
        int factor_first = -1;      // which begins at this token
    };
    // What the branches of the program so far have left.
    struct State {
        std::vector<Slot> slots;  // by Code::variables
        bool dead = false;        // behind return, discard, break, continue
        bool returned = false;    // behind return
    };

    // Parameters named `node` are indices into the unit's tree.

    // statements (walker.cpp)
    void statement(int node);
    void branch(int node);
    void loop(int node);
    void do_loop(int node);
    void returns(int node);
    void local(int node);
    void forget_stored(int first, int last);
    void forget(int slot);
    bool of_interest(int first, int last) const;
    State merge(State a, const State& b) const;
    std::vector<const glsl::Node*> conditioned(int first, int last) const;
    void condition_on(int first, int last, bool counts = false);
    void conditions_end(int node);
    void note_reasons(int variable, int value);

    // how often loops go round (loops.cpp)
    struct Counter;
    bool leaves(int node, bool breaks) const;
    bool may_discard(std::string_view function, std::set<std::string_view>& seen) const;
    bool calls_discard(int node) const;
    void apart(const std::function<void()>& walk);
    bool stored(int variable, int node) const;
    using Update = glsl::Update;
    struct Loop {
        int condition, step, body;  // nodes; step: of `for`; -1: the body steps
    };
    std::optional<glsl::Comparison> comparison(const Loop& loop) const;
    bool stored(int variable, const Loop& loop) const;
    std::optional<std::vector<Update>> updates_of(int variable, const Loop& loop);
    bool take_shortest(Update& update, int variable, const Loop& loop);
    static double counted_rounds(double value, std::string_view op, double bound, const std::vector<Update>& updates,
                                 glsl::Base base);
    bool stays_true(const Loop& loop);
    bool moves(int bound, const Loop& loop) const;
    // 0: it is not known.
    double rounds_of(const Loop& loop);
    void go_round(std::optional<double> rounds, const Counter& own, int first, int last);

    // loops whose bounds depend on the counters of those around (nests.cpp)
    struct Counter {
        int variable = -1;           // -1: it is not known which
        bool counts = false;         // it is known how
        std::optional<double> from;  // what it begins with,
        int begin = -1;              // or the expression of that
        int bound = -1;
        std::string_view op, name;
        glsl::Base base = glsl::Base::unknown;
        std::vector<Update> updates;
        double rounds = 0;   // where they depend on no other; 0: they do
        int serial = 0;      // of what was met so far
        bool moved = false;  // in the round that is walked
        double value = 0;    // while rounds are summed
    };
    struct Definition {
        int node;
        int serial;  // it may mean the counters of loops that were around
    };
    void define(int variable, int node);
    Counter counter_of(const Loop& loop, int begins);
    std::optional<double> rounds_in(Counter& own, const Loop& loop);
    bool never_ends_somewhere(const Counter& own, std::set<int> needed);
    bool enters(const Counter& own);
    void add_needed(int node, std::set<int>& needed) const;
    // Where the sliders are.
    enum class Place : std::uint8_t { low, current, high };
    struct Sliders {
        Place all;
        int moved = -1;  // the uniform that is elsewhere: Unit::globals
        Place to = Place::current;
    };
    std::optional<double> number_at(int node, const Sliders& sliders, int serial);
    std::optional<double> number_of_name(const glsl::Node& node, const Sliders& sliders, int serial);
    bool begins_at(const Counter& counter, const Sliders& sliders);
    std::optional<double> rounds_at(const Counter& counter, const Sliders& sliders);
    std::optional<double> first_of(const Counter& counter, const Sliders& sliders);
    std::optional<double> summed(std::size_t level, const Counter& own, const std::set<int>& needed,
                                 const Sliders& sliders);

    // expressions (expressions.cpp)
    Expr evaluate(int node);
    Expr result(int node);
    Expr choose(const std::vector<int>& parts);
    Expr index(const std::vector<int>& parts);
    Expr number(const glsl::Node& node);
    Expr name(const glsl::Node& node);
    void assign(Expr& target, const Expr& value, std::string_view op);
    void select(Expr& e, const glsl::Node& node);
    Value combine(const glsl::Type& type, const Value& a, const Value& b, std::string_view op);
    Value add(const glsl::Type& type, const Value& a, const Value& b, bool minus);
    Value multiply(const Value& a, const Value& b);
    Value negate(const Value& v);
    static void note_difference(Value& v, const Expr& a, const Expr& b);
    Value built_in(std::string_view name) const;
    Value constructed(const glsl::Type& type, const std::vector<Expr>& given);

    // calls (calls.cpp, optics.cpp)
    Expr call(int node);
    Value call_user(const glsl::Function& f, const std::vector<Expr>& given);
    const glsl::Function* find_function(const glsl::Node& call, std::size_t arguments) const;
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
    Value seed(const glsl::Global& global) const;
    int fresh() { return ++ids_; }
    std::string words(int first, int last) const;  // the text of tokens, for messages
    Span span(int first, int last) const;          // of their text
    void report(Rule rule, int first, int last, std::string message, std::vector<Note> notes = {});

    const glsl::Node& at(int node) const { return (*u_.tree)[static_cast<std::size_t>(node)]; }
    std::vector<int> parts(int node) const { return glsl::parts(*u_.tree, node); }
    Slot& slot(int variable) { return state_.slots[static_cast<std::size_t>(variable)]; }

    const glsl::Unit& u_;
    const Surroundings& around_;
    const Varyings* given_;
    Report report_;
    int depth_ = 0;
    int budget_ = 500'000;  // nodes looked at: calls are walked anew each time
    int ids_ = 0;
    State state_;
    std::vector<const glsl::Function*> calling_;  // from main on
    std::optional<Value> result_;                 // of the function being walked, so far
    std::optional<State> ended_;                  // what main left where it returned early
    std::set<int> unstable_;                      // global variables that functions assign
    double rounds_ = 0, weight_ = 1;              // of all loops so far; of those around
    std::vector<Counter> counters_;               // of the loops around that go round a known number of times
    std::map<int, Definition> defined_;           // what variables have that nothing assigned since
    std::set<int> stored_;                        // variables that anything assigns
    int sums_ = 1'000'000;                        // steps of summing rounds: it is left then
    bool slides_ = false;                         // sliders at their ends were counted with
    bool told_rounds_ = false;
    int perhaps_ = 0;     // branches, and loops of unknown rounds, around: what stands there may never run
    int nonuniform_ = 0;  // branches around that only some fragments take
    std::multiset<std::string_view> conditions_;  // names in conditions around, or behind which some path ended
    std::map<int, std::vector<const glsl::Node*>> reasons_;  // names in what a bool was ever set to, by variable

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
