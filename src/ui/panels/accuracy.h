// The accuracy panel: the error of the shown picture compared with the reference (the last rung of every ladder), error
// and cost of the other rungs, and the rungs that snell finds by itself.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/scene.h"
#include "src/content/plot/plot.h"
#include "src/plan/values/controls.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/text.h"
#include "src/ui/panels/found.h"

namespace snell::ui {

struct Facts;
struct Requests;

// Error and cost of one choice of rungs that was drawn.
struct AccuracyPoint {
    // visited: was drawn, but not compared with others.
    enum class Standing : std::uint8_t { visited, front, saves_none, unsure, dominated };
    std::string name;  // the rung of the plotted ladder; if rungs of other ladders differ too, all that differ
    std::optional<std::size_t> rung;             // index into the plotted ladder; nullopt if other ladders differ too
    double milliseconds = 0, low = 0, high = 0;  // median, and its confidence interval
    double error = 0;                            // root mean square; 0 is exact
    Standing standing = Standing::visited;
    std::string by;  // the point that dominates this one, or that is more exact
    bool chosen = false;
    bool reference = false;  // the last rung of every ladder
    bool operator==(const AccuracyPoint&) const = default;
};

struct AccuracyFacts {
    std::string note;       // why there is nothing to compare with; empty if there is
    std::string reduced;    // the pictures that are compared have fewer pixels than the window's; empty if they do not
    bool of_scene = false;  // a found rung is shown, and the reference is the scene as it is
    int samples = 0, wanted = 1;
    std::string_view clock;                   // the clock that measured the points, by one sample per pixel
    double error = 0, psnr = 0, largest = 0;  // of the light, in the mean of `samples` pictures, if `samples` is not 0
    double of_display = 0;                    // the error of the display values
    std::size_t nonfinite = 0;                // number of pixels with NaN or infinite values
    bool unknown = false;                     // the heat map has pixels whose difference is NaN or infinite
    std::vector<AccuracyPoint> points;
    std::optional<double> measured;  // progress 0..1 while all rungs are being measured
    std::string remark;              // a note on the measurement; may be empty
};

// The plot as it was drawn last: it is drawn anew only where it changed, so that a drag allocates nothing.
struct AccuracyPlot {
    std::vector<AccuracyPoint> points;
    std::array<float, 3> at{};  // of its left upper corner, and its width
    float letters = 0;          // the size of the font
    float height = 0;
    std::vector<content::Mark> marks;
    std::vector<std::size_t> shown;                 // indices of those points that have a place
    std::vector<std::pair<double, double>> places;  // of these
};

// The two states that are shown side by side.
struct StateFacts {
    struct Choice {
        std::string name, text;  // as in AccuracyMemory; as displayed
    };
    struct Side {
        std::string name, label;  // what differs: "now: uIndex 1.33"
        bool failed = false;      // the label says why it is not shown, or only as it was
        bool blank = false;       // there is no picture of it
    };
    std::vector<Choice> choices;
    std::array<Side, 2> sides;
    bool fixed = false;                                   // neither follows the sliders
    std::string example = "values, such as uIndex=1.33";  // of what can be typed
};

struct AccuracyMemory {
    enum class Show : std::uint8_t { picture, split, heat };
    bool open = false;
    Show show = Show::picture;
    // The states on the left and on the right by their names, see src/app/open/states.h. Empty: as it is now, and the
    // reference, or as it is saved if there are no ladders.
    std::string left, right;
    std::array<char, 256> settings{};  // what is typed as the name of a state
    bool entered = false;              // its list is open until that state is there, or has failed
    float divider = .5F;               // between them, as a fraction of the picture's width
    float grabbed = .5F;               // where it was when its drag began
    std::size_t ladder = 0;            // index of the ladder that is plotted: the one changed last
    Rungs rungs;                       // of the last frame
    bool hold_time = true;             // whether time is paused while the panel is in sight
    AccuracyPlot plot;
    FoundMemory found;
};

// The range of errors that the heat map distinguishes, from black to white, as powers of ten.
inline constexpr double coldest = -3, hottest = 0;
// Where either picture has no number, in a colour that the heat map has not.
inline constexpr std::array<float, 3> no_number{.1F, .75F, .9F};

// Plots the ladder that was changed since the last frame. Call it in every frame, whether the panel is in sight or not.
void follow_ladder(const Rungs& rungs, AccuracyMemory& memory);
// Draws the panel. `moves`: time or values change by themselves, unless they are paused.
void accuracy_section(const Facts& facts, Controls& controls, bool moves, AccuracyMemory& memory, Requests& requests,
                      Layout& layout);

std::string milliseconds_text(double milliseconds);
// How the times of rungs and that of the window's picture are meant, which are not to be compared.
Text basis_text(const Facts& facts);
std::string error_text(double error);  // ".0031"; "none" if it is only rounding, "unknown" if it is NaN
// Of the picture that is shown; if it is that of a found rung, with the rung's own, where they differ.
Text error_line(double error, const FoundRow* rung);
// One sentence, with what else is known of the error.
std::string error_tip(const AccuracyFacts& facts);
std::string standing_text(const AccuracyPoint& point);  // such as "worth its time"; empty if the point was not compared

// Draws error over cost, as wide as the panel.
void accuracy_plot(const std::vector<AccuracyPoint>& points, AccuracyPlot& plot, Layout& layout);

// Draws the names of the two states, by which others are chosen, with buttons that swap them and show the heat map, and
// returns where it begins. Without two states that is the end of the picture.
float state_bar(const Facts& facts, const Rect& scene, AccuracyMemory& memory, Layout& layout);
// Shows two states side by side, or one picture again.
void switch_split(AccuracyMemory& memory);
// Covers a half that there is no picture of, and says so.
void blank_halves(const Facts& facts, const Rect& scene, const AccuracyMemory& memory);
// Draws the divider over the picture and lets the user drag it. `scene` is in window coordinates.
void accuracy_divider(const Rect& scene, AccuracyMemory& memory, Layout& layout);

}  // namespace snell::ui
