// What a user has changed in a scene, as text in the syntax of `snell render`: values, ranges of sliders, rungs, the
// view. Everything that keeps it, goes back to it or hands it on does so in this one form, so it outlives the text that
// it was set in: a reload, a program that is broken for a while, another scene, the end of the program.
#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "src/plan/values/controls.h"
#include "src/plan/view.h"

namespace snell {

// By option and name: "--set Glass.uEta" is "1.3", "--range Glass.uEta" "0,2", "--ladder FRESNEL" "exact",
// "--view eye.x" "-2", "--axes" "on". Of the view it has what differs from View{}, which an empty value means.
// "--program 0" is what tells the first of the scene's programs from others of its name: in another text, "Glass#2" may
// be the first of that name. "--fold Glass" is "open" or "folded", as its section in the window. Commands have no such
// options.
using Setup = std::map<std::string, std::string>;

inline constexpr std::string_view set_option = "--set ", range_option = "--range ", ladder_option = "--ladder ",
                                  view_option = "--view ", axes_option = "--axes", program_option = "--program ",
                                  fold_option = "--fold ";

// The numbers of a value, such as "1,0.5,0". They read back to the same bits.
std::string numbers_text(const std::vector<double>& numbers);
// Returns no numbers if the text is not such a list.
std::vector<double> read_numbers(std::string_view text);

// Gives programs the names that they have in another text. Those that it does not have, and of which `used` has a
// value or a fold, are named behind its own.
class Renaming {
public:
    // `programs` has what told them apart; without that, names stay.
    Renaming(const Setup& programs, const Setup& used, const Scene& scene);

    // Of a uniform, such as "Glass.uEta" for "Glass#2.uEta".
    std::string name(std::string_view control) const;
    // Of a setting, such as "--set Glass.uEta".
    std::string key(const std::string& key) const;
    // Without what unclear programs had: it would come back in any of them.
    Setup operator()(const Setup& setup) const;
    // Whether that leaves this setting out.
    bool loses(std::string_view key) const;
    // Whether the program of a uniform may be one that the text has, but nobody can tell which; by its old name.
    bool unclear(std::string_view control) const;
    // What tells the scene's programs apart, and those that it does not have.
    void note(Setup& setup) const;

private:
    std::vector<ProgramId> programs_;
    std::map<std::string, std::string, std::less<>> names_;  // by the old ones
    std::set<std::string, std::less<>> unclear_;             // old names
};

// All values, ranges and rungs, or as the scene's text says them.
Setup setup_of(const Scene& scene, const Controls& controls);
Setup written_setup(const Scene& scene, Controls controls);
// What differs from the scene's text.
Setup changed_setup(const Scene& scene, const Controls& controls);
// Of the mouse there is nothing.
Setup setup_of(const View& view);

// Sets what the setup has. Returns the number of values and rungs that the scene does not have, or that do not fit.
std::size_t apply_setup(const Setup& setup, const Scene& scene, Controls& controls);
// Only rungs, before the programs are compiled for them.
std::size_t apply_setup(const Setup& setup, const Scene& scene, Rungs& rungs);
void apply_setup(const Setup& setup, View& view);

// One setting a line, such as "--set Glass.uEta=1.3". Other lines are skipped.
std::string setup_text(const Setup& setup);
Setup read_setup(std::string_view text);
// Those of one option, as it takes them, such as "Glass.uEta=1.3".
std::vector<std::string> arguments_of(const Setup& setup, std::string_view option);
// The arguments of `--set` for the values that differ from the text, for set_control() in this order. Programs of one
// name are told apart; `brief`: without the program's name if no other program has such a uniform.
std::vector<std::string> set_arguments(const Scene& scene, const Controls& controls, bool brief = false);
// Removes those of an option.
void erase(Setup& setup, std::string_view option);

// The view that the user has set, as the argument of one option.

// Formats the values that differ from their initial state, such as "rotate_x=30,rotate_y=-12.5,scale=1.2,x=.1". Names
// of other transformations begin with "eye.", "texture." and "object3."; further values are "projection=ortho" and
// "background=.3". "" if nothing differs. The text reads back to the same bits. Axes and mouse are not included.
std::string view_text(const View& view);

// Returns "" or the error.
std::string parse_view(std::string_view text, View& view);

// What was chosen, and what the text said then. Both have the same settings; the latter has the programs, too.
struct Remembered {
    Setup chosen, written;
    bool operator==(const Remembered&) const = default;
};

// Notes what differs from the scene, and forgets what no longer does. What the scene does not have stays, and so does
// the value of a uniform that the program still uses but its line no longer lists. With `all`, the scene's own values
// are noted too.
void remember(const Scene& scene, const Controls& controls, Remembered& memory, bool all = false);

// Sets the values that are remembered. Returns true if that changed any.
bool recall(const Remembered& memory, const Scene& scene, Controls& controls, Follow follow = Follow::text);
// Sets the rungs, before programs are compiled for them.
bool recall(const Remembered& memory, const Scene& scene, Rungs& rungs, Follow follow = Follow::text);

}  // namespace snell
