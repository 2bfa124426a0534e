// Changes of a scene's texts that snell proposes: each makes the picture cheaper or better, or leaves out what may have
// no effect; by which number it is asked for, and the texts that have it. What is measured, shown and written is the
// same edit of the author's own text. No GL; nothing is written.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "parser/text/source.h"
#include "src/plan/plan.h"
#include "src/plan/values/write_back.h"

namespace snell::accuracy {

enum class Aim : std::uint8_t {
    cheaper,  // less work, and an error that must be worth it
    better,   // what the picture lacks, and what that costs
    unused,   // something is left out, to see whether any pixel changes
};
std::string_view name(Aim aim);

enum class ChangeKind : std::uint8_t {
    // cheaper, in shaders
    fewer_rounds,
    without_term,
    lookup_mean,
    expression_mean,
    polynomial,
    per_vertex,
    per_frame,
    lower_levels,
    // cheaper, in the scene
    smaller_noise,
    fewer_texels,
    fewer_cells,
    fewer_slices,
    culled,
    less_filtered,
    // better, in shaders
    unit_length,
    derivatives_outside,
    more_rounds,
    exact_fresnel,
    both_interfaces,
    box_projection,
    lint_fix,
    // better, in the scene
    finer_cells,
    more_slices,
    filtered,
    decoded,
    // left out
    no_draw,
    no_texture,
    no_uniform,
    no_statement,
    count,
};

struct KindFacts {
    ChangeKind kind;
    Aim aim;
    std::string_view name;  // in reports, such as "fewer-rounds"
    std::string_view doc;   // one line for people
};
const KindFacts& facts(ChangeKind kind);

// The blue of pixels that show an expression.
inline constexpr double probe_mark = 12345;

struct Change {
    ChangeKind kind = ChangeKind::count;
    Span where;                 // the expression or statement that changes, for file:line:column
    std::string before, after;  // one line each, shortened
    std::vector<Edit> edits;    // by file and place; none overlaps another
    std::string lint = {};      // the code of the lint that knows the mistake; empty: none
    // Not empty: the edit lacks a number, which fill_averages (search.h) finds by drawing the scene with these edits.
    // Each draws two components of the expression and probe_mark.
    std::vector<std::vector<Edit>> probes = {};
    std::string refused = {};  // why these could not be drawn; empty: they were, or were not tried
};

// True if the edits of the two do not touch each other, so that both can be made.
bool compatible(const Change& a, const Change& b);

// The texts with all edits made, by their names (Sources::name), which are paths; texts without an edit are left out.
// The changes must be compatible.
std::map<std::string, std::string> changed_texts(std::span<const Change* const> changes, const Sources& sources);

// An excerpt for Change::before and after: one line, blanks folded, cut in the middle if it is longer than `most`
// bytes.
std::string excerpt(std::string_view text, std::size_t most = 60);

// A float as GLSL writes it.
std::string real_literal(double value, int digits = 9);

// What a rung with the change is called: a few words, such as "8 slices" or "uRoom as its mean". Two changes may have
// the same.
std::string words(const Change& change);

// All changes that make sense for the scene, in a fixed order: by file (the scene first), place, and kind. Their
// positions in this list are the rungs' names, from 1, in every run. `sources` gets the texts of included shaders.
std::vector<Change> find_changes(const Plan& plan, Files& files, Sources& sources);

// Changes that are made together, named by their numbers: "3" or "3+7".
struct Chosen {
    std::vector<std::size_t> numbers;  // from 1, ascending
    // In this order. Each text has one FileId, however often it was included, and edits have its line ends.
    std::vector<Change> changes;
};

// Reads a name such as "3+7", as parse_rung() does. Returns nullopt and sets `error` if there is no such change, or two
// change the same text.
std::optional<Chosen> choose_changes(std::string_view name, std::span<const Change> changes, const Sources& sources,
                                     std::string& error);

// Such as "glass.frag:12:5".
std::string change_place(const Change& change, const Sources& sources);

// Edits at other places than the first, such as "glass.frag:14:12: 8. → 4.".
std::vector<std::string> other_edits(const Change& change, const Sources& sources);

// Such as "glass.frag:12:5: i < 8 → i < 4". Other edits follow on lines of their own.
std::string change_line(const Change& change, const Sources& sources);

// The first of several readings of a text: a shader that several others include is read once for each.
FileId first_reading(FileId file, const Sources& sources);

// The line end of a text: that of its first line, "\n" if it has only one line.
std::string_view line_end_of(std::string_view text);

}  // namespace snell::accuracy
