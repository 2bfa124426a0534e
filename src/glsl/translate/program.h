// The steps from parsed stages to translated ones; translate.cpp runs them in the order of this file.
#pragma once

#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/glsl/read/token.h"
#include "src/glsl/read/tree.h"

namespace snell::glsl {

// A built-in variable that passes from the vertex to the fragment shader, as a member of a block.
struct LegacyVarying {
    std::string name, declaration;
    int size = 0;  // of an array
};

// All stages of one program while they are translated.
struct Program {
    const Options& options;
    Sources& sources;
    Diagnostics& diagnostics;
    std::vector<Unit> units;  // in the order of the pipeline
    std::vector<UniformDefault> defaults;
    std::vector<RenamedUniform> renamed;
    std::vector<LegacyVarying> legacy_varyings;  // set by replace_legacy where lines are widened
    std::vector<DeclaredUniform> declared = {};
    std::vector<Settled> settled = {};  // those of Options::settle that decide something
    std::map<Stage, Tree> trees = {};   // of the stages whose loops are asked about

    const Target& target() const { return options.target; }
    Unit* find(Stage stage) {
        for (Unit& u : units)
            if (u.stage == stage) return &u;
        return nullptr;
    }
    Unit* before(const Unit& unit) {
        Unit* found = nullptr;
        for (Unit& u : units)
            if (u.stage < unit.stage) found = &u;
        return found;
    }
    // One warning for each kind of forgiveness and place.
    void warn(const Unit& u, int token, std::string_view code, std::string message, std::string help = {}) {
        diagnostics.warning(code, u.span(token), std::move(message), std::move(help));
    }
};

// An error where the tree of expressions and statements is deeper than drivers can bear.
void refuse_deep_nesting(const Program& program, const Unit& unit);
// Before the parse: words that became reserved, words that mean nothing here, odd numbers.
void mend_words(Program& program, Unit& unit);
void rename_words(Program& program);
// Structures without a name get one, and those declared inside structures move ahead of them.
void lift_structures(Unit& unit);

// A stage that the pipeline needs and the program lacks, as source text; empty if none is missing.
std::string default_vertex_shader(Program& program);
std::string default_fragment_shader();

// After the parse, before anything is replaced. See Translation::plain_depth.
bool has_plain_depth(Program& program);
// See Translation::placed_by.
std::string placed_by(Program& program);

// The name stands among its tokens.
bool mentions(const Unit& unit, std::string_view name);

// Functions that a variable is named like get another name.
void separate_functions(Unit& unit);
// Prototypes of functions that are called above their definition.
void declare_functions(Program& program, Unit& unit);
// Copies of inputs and uniforms that are assigned.
void copy_assigned(Program& program, Unit& unit);
// Arrays without a size get that of the largest index, where the target wants one.
void size_arrays(Program& program);
// Uniforms of one name agree in type and initialiser; values of initialisers are recorded.
void unify_uniforms(Program& program);
// The uniforms of the texts and their uses. After the interfaces are matched and the attributes assigned, but before
// the outputs are.
std::vector<DeclaredUniform> declared_uniforms(Program& program);
// Blocks that pass between shaders become single variables where the target has none.
void flatten_blocks(Program& program);
bool flattens_blocks(const Program& program);
// The same for one block, whatever the target has.
void flatten_block(const Program& program, Unit& unit, const Block& block);
// The variable that a member of a block becomes then.
std::string variable_of(const Program& program, std::string_view block, std::string_view member);
// Inputs of each stage meet outputs of the stage before.
void match_interfaces(Program& program);
// Returns the attribute that the name or the location of a vertex input means.
std::optional<Attribute> attribute_of(const Global& input);
// Vertex inputs get the attribute that they mean.
void assign_attributes(Program& program, Unit& vertex);
// What a stage may leave without a value is zero: on some drivers it is what another program has left in a register.
void give_outputs(const Program& program, Unit& unit);
// Colour outputs of the fragment shader.
void assign_outputs(Program& program, Unit& fragment);
// Vertices of the primitives that a geometry shader reads: those of a triangle, if its text does not say.
int vertices_in(const Unit& geometry);
// Layouts that an old geometry shader leaves to the application.
void complete_geometry(Program& program, Unit& geometry);
// Levels of tessellation that are indexed by what may differ between invocations are set by a function.
void choose_levels(Unit& control);
// Functions that the target lacks, or that leave results undefined, where they are called: noise1 … noise4, fma,
// smoothstep; and those that undefined operands are marked with.
void provide_helpers(const Target& target, Unit& unit);
// gl_… to snell_….
void replace_legacy(Program& program);
// As Options::placed says. True: there was something to do, or would be.
bool place_in_picture(Program& program);
// Whether a geometry stage of ours will stand between the two of the program.
bool widens_lines(const Program& program);
// Its text; makes the shaders on both sides give and take what it hands on. Nothing where it isn't wanted or,
// with a warning, not possible.
std::optional<std::string> widen_lines(Program& program);
// Replaces stages of a translated program, as Options::without_stages says.
void emulate_stages(Program& program, Translation& translation);
void emulate_tessellation(Program& program, Translation& translation);
void emulate_geometry(Program& program, Translation& translation);
// Stages hand on what OpenGL ES does not pass between them; as numbers, once only two stages are left.
bool passes_numbers(const Program& program);
void pass_numbers(Program& program, Translation& translation);
// Stages of OpenGL ES 3.2 that lack, unless it has extensions, what the program wants of them.
bool lacks_of_stages(Program& program);
// OpenGL ES has no other point size than the one that shaders write.
void give_point_size(Unit& vertex);
// Asks Options::settle, after declared_uniforms.
void choose_settled(Program& program);
// What the settled uniforms decide is written as decided, and the other marks go (read/marks.cpp).
void resolve_marks(Program& program);
// What settled uniforms decide is written as this, its value, " : ", the expression, and ")".
inline constexpr std::string_view decided_text = "(true ? ";
// One of Translation::long_loops; after resolve_marks. `bounded`: loops that may never end are left after most_rounds.
std::optional<LongLoops> long_loops(Unit& unit, bool bounded);
// As Options::constant says; Program::settled has it if every stage does.
void write_constant(Program& program);
// The function that marks call, for each type that it takes: snell_divisor or snell_value.
void provide_mark(Unit& unit, std::string_view function);
// Initialisers that are no constants move to the start of main.
void move_initialisers(Program& program, Unit& unit);
// Qualifiers and types as the target wants them; rewrites the declarations marked dirty.
void write_declarations(Program& program, Unit& unit);

// The text of a stage.
std::string emit(const Program& program, Unit& unit);
// Tokens first … last as they will be written, without what leads the first.
std::string render(const Unit& unit, int first, int last);

// Leaves the members of a block their types, precisions and names.
void unqualify_members(Unit& unit, const Block& block);

// Declares `in`, `out` or the like in the header unless the text does so itself.
void declare_once(Unit& unit, std::string_view name, std::string_view declaration);
// The unit's main has code to run before the user's; false if there is no main. `declared`: the token where the
// variable that it sets is declared, which may be behind main.
bool at_main_start(Unit& unit, std::string_view statement, int declared = -1);
// Runs a statement when main has returned.
void at_main_end(Unit& unit, std::string_view statement);
// Declares behind the user's text, and runs statements before anything that main does.
void declare_before_main(Unit& unit, std::string_view declarations, std::string_view statements);
const Function* find_main(const Unit& unit);
bool user_function(const Unit& unit, std::string_view name);
// "vec3(x)" and the like: the value `text` of one type as another; empty if there is no way.
std::string converted(std::string_view text, const Type& from, const Type& to);
// Statements that set a variable of any type to zero, member by member and element by element.
std::string set_zero(const Unit& unit, const std::string& variable, const Type& type);

}  // namespace snell::glsl

namespace snell::glsl::folding {

// What is known of a stage's values without a driver: which a driver may find constant by the text, and which are sure
// while uniforms are settled.

struct Fold {
    // By the text alone.
    enum class Kind : unsigned char { live, constant };
    Kind kind = Kind::live;
    bool zero = false;                                        // a constant of which a component may be 0
    double value = std::numeric_limits<double>::quiet_NaN();  // of a scalar constant, where known
    bool cancels = false;  // made of what a driver drops with its inverse, as in exp2(log2(x)), where x may be negative

    // In every run of the stage, while the settled uniforms have their values.
    enum class Sure : unsigned char { nothing, number, anything };  // never given; always the same; not known
    Sure sure = Sure::anything;
    Base base = Base::unknown;
    double number = 0;
    bool exact = true;                                      // not rounded
    double most = std::numeric_limits<double>::infinity();  // no component is larger: surely neither infinite nor NaN
    std::uint64_t from = 0;                                 // the uniforms that it is known by, as bits
};

// Of a uniform that may be settled.
Fold free_number(Base base);
// Of a value that is not settled, but no component of which is larger.
Fold bounded(double most, std::uint64_t from);
// As GLSL writes the number, to the last bit of a float; empty if no text gives it on every driver.
std::string number_text(Base base, double value);
// Of a settled number or truth value.
Fold settled_number(Base base, double value, std::uint64_t from);

struct Decided {
    std::vector<bool> stay;         // by Unit::marks
    std::vector<std::string> text;  // what is there instead of an operand; empty: Mark::function is called
    std::uint64_t from = 0;         // the uniforms that decided
    bool possible = false;          // values of uniforms could
};

// The settled uniforms of which the sign of a zero may be seen, as 1 / -0 is another infinity than 1 / 0.
std::uint64_t signs(const Unit& unit, const std::map<std::string_view, Fold>& settled,
                    std::map<std::string_view, Fold>& passed);

// Which marks of the unit stay. `signs`: of all units; what they leave out by a weight of 0 keeps no sign. `free`:
// uniforms that may be settled, whether they are or not. `passed`: what is known of the stage's inputs; of its outputs
// when this returns.
Decided decide(const Unit& unit, const std::map<std::string_view, Fold>& settled,
               const std::map<std::string_view, Fold>& free, std::uint64_t signs,
               std::map<std::string_view, Fold>& passed);

}  // namespace snell::glsl::folding
