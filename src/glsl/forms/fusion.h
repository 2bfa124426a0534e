// Stages as functions of one vertex shader, for contexts that have only that stage and the fragment stage.
#pragma once

#include <initializer_list>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/glsl/translate/program.h"

namespace snell::glsl {

// What shaders of every context may hand to transform feedback, in slots of four components.
inline constexpr int most_slots = 15;

// What passes between two stages, by one key on both sides: the name, or "block.member".
struct Port {
    std::string key, name, qualifiers, location;
    Type type;
    bool patch = false;  // one for all vertices of a patch
};
const Port* port_of(const std::vector<Port>& ports, const Port& other);

// A number in a variable, and in the variable that it is handed on to.
struct Number {
    std::string from, to;
    Base base;
};

std::string number(int n);
// The element of an array of variables, or of blocks: "block.member" → "block[index].member".
std::string element_of(const std::string& name, const std::string& index);
// The text with values in the place of their names.
std::string filled(std::string_view text, std::initializer_list<std::pair<std::string_view, std::string_view>> values);

// Two stages of a translated program as one text. The first one runs for each vertex of a primitive; what it outputs
// are elements of the second one's inputs.
class Fusion {
protected:
    Fusion(Program& program, Translation& translation)
        : program_(program), out_(translation), options_(program.options) {}

    StageOutput* stage(Stage which);
    void fail(std::string message);
    // Where the author's text of the stage first has the name.
    void cannot_pass(Stage which, std::string_view name);

    // Reads what was translated, with macros expanded: those of one stage must not meet the other. `apart`: as a part
    // of one text, whose source strings begin with `first_file`.
    Unit read_again(const StageOutput& from, bool apart, std::size_t first_file = 0);
    // Reads both; `second` may be null.
    void read(const StageOutput& first, const StageOutput* second);
    void add_files(const StageOutput& from);

    // Both stages become one text: what only one of them means gets a name of its own where the other has that word,
    // and what both declare is declared once.
    void separate_names();
    void share_declarations();

    // Variables in the place of inputs and outputs. Those of each vertex are arrays of `count` elements.
    static std::vector<Port> ports(const Unit& u, Storage storage);
    static void leave_redeclarations(Unit& u);
    static void make_plain(Unit& u, Global& g, int count);
    static void make_plain(Unit& u, const Block& b, const std::string& prefix, int count);
    // All inputs or outputs of the second stage.
    void make_plain(Storage storage, int count, const std::string& prefix);
    void take_first();
    // Fails where the second stage reads what the first one does not give.
    void take_inputs();

    // The two stages that are left, read once more; and as they are then.
    std::vector<Unit>& take_both();
    void put_both();

    // Statements that give variables at global scope what they begin with.
    static std::string resets(const Unit& u, const std::string& indent);

    // Of dimensions such as "[2][3]": "[0][0]", "[0][1]" … Empty if a size is not known.
    static std::vector<std::string> indices_of(const Unit& u, std::string_view dims);
    // Adds a number for each component of the variable; false if there is no way.
    static bool add_numbers(const Unit& u, Type type, const std::string& from, const std::string& to,
                            std::vector<Number>& numbers);
    // An input of the fragment stage becomes a variable that gets its numbers at the start of main. Returns statements
    // for the end of the stage before, which give them from `from`; `declared` is what they are passed in. Empty if
    // there is no way.
    static std::string pass_as_numbers(Unit& fragment, Global& input, const std::string& from, std::string& declared);
    static std::string own_type_name(const Unit& u, const Type& type);

    // The number of the primitive becomes a variable that the stage before gives; false if the fragment stage does not
    // read it.
    static bool take_number(Unit& fragment);

    // Of a layout; -1 where it is not known.
    static int value_of(const Unit& u, std::string_view text);

    // ---- texts

    std::string head() const;
    // Once both are as they shall be.
    void write_both();
    // Declares what the stages read, and then `own`, ahead of both.
    std::string beginning(std::string_view own) const;
    // Runs the first stage for all vertices of the primitive `snell_primitive`.
    std::string run_first() const;

    Program& program_;
    Translation& out_;
    Options options_;
    Span reference_;
    bool ok_ = true;
    Sources sources_;
    Diagnostics quiet_;
    Program quiet_program_{options_, sources_, quiet_, {}, {}, {}, {}};
    Unit first_, second_;
    int corners_ = 3;                    // vertices of a primitive
    std::set<std::string_view> common_;  // structures of both stages
    std::vector<Port> given_;            // outputs of the first stage
    std::string extensions_, fetches_, copies_;
    std::vector<FileId> files_;
    std::vector<Stage> written_in_;  // the author's stage of each of them

private:
    std::size_t second_file_ = 0;
    std::string both_;

    std::string apart(std::string_view text, std::size_t first_file);
    std::string text_of(Unit& u, std::size_t first_file) const;
    static std::string fetch(const Global& g, const std::string& name);
};

}  // namespace snell::glsl
