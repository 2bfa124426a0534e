// How far the picture is from the best that the scene's ladders give, and what the others would cost.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/plan/controls.h"
#include "src/ui/layout.h"

namespace snell::ui {

struct Facts;

// A choice of rungs that was drawn.
struct AccuracyPoint {
    enum class Standing : std::uint8_t { visited, front, saves_none, dominated };  // visited: not compared with others
    std::string name;  // the rung of the ladder that is plotted; of choices that differ elsewhere, all that differ
    std::optional<std::size_t> rung;             // of that ladder; none: others differ too
    double milliseconds = 0, low = 0, high = 0;  // median, and where it lies
    double error = 0;                            // root mean square; 0 is exact
    Standing standing = Standing::visited;
    std::string by;  // what it is dominated by, or no cheaper than
    bool chosen = false;
};

struct AccuracyFacts {
    std::string note;  // why there is nothing to compare with; empty otherwise
    int samples = 0, wanted = 1;
    double milliseconds = 0;                  // of a picture; 0: not known yet
    std::string_view clock;                   // what measured them
    double error = 0, psnr = 0, largest = 0;  // of `samples`, if not 0
    std::size_t nonfinite = 0;                // pixels that are no numbers
    std::vector<AccuracyPoint> points;
    std::optional<double> measured;  // 0..1, while all rungs are being measured
    std::string remark;              // on what was measured; empty: none
};

struct AccuracyMemory {
    enum class Show : std::uint8_t { picture, split, heat };
    bool open = false;
    Show show = Show::picture;
    float divider = .5F;     // of the picture's width: left of it the chosen rungs, right the reference
    std::size_t ladder = 0;  // that is plotted
    bool hold_time = true;   // of an animated scene, while the panel is open
};

// The errors that the heat map tells apart, from black to white, as powers of ten.
inline constexpr double coldest = -3, hottest = 0;
// Colours for 0..1, from black over violet and orange to nearly white; darker is always less.
struct Heat {
    float red = 0, green = 0, blue = 0;
};
Heat heat(double fraction);

// True: all rungs of the ladder are to be measured; or, while they are, no more.
bool accuracy_section(const Facts& facts, Controls& controls, AccuracyMemory& memory, Layout& layout);

std::string milliseconds_text(double milliseconds);
std::string error_text(double error);                   // ".0031"
std::string standing_text(const AccuracyPoint& point);  // "worth its time"; empty when it was not compared

// The plot, as wide as there is room.
void accuracy_plot(const std::vector<AccuracyPoint>& points, Layout& layout);

// The divider over the picture. `scene` in window coordinates.
void accuracy_divider(const Rect& scene, AccuracyMemory& memory, Layout& layout);

}  // namespace snell::ui
