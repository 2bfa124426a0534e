// One picture of a report that needs no explanation: error against time, and what the errors look like. Values in,
// files out; no GL.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/accuracy/report/report.h"
#include "src/content/plot/plot.h"

namespace snell::accuracy {

// The part of a picture that is magnified, in its pixels.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
};

// A rung whose picture is shown.
struct SlideColumn {
    std::string name;
    double error = 0, milliseconds = 0;            // a time of 0 is unknown
    bool own = false;                              // as the scene sets it
    bool equal_time = false, equal_error = false;  // to that of the scene's own rung
    content::Ink ink = content::Ink::own;          // that of its point
    content::Image picture = {}, map = {};         // of the window: the rung, and its FLIP from the reference
};

struct Slide {
    std::string title, note;
    // The times are the ratios to the scene's own rung in their own tables, times one time of the scene. The stamp says
    // why there is no front, and what is left out.
    content::Plot plot;
    std::vector<SlideColumn> columns;
    content::Image reference = {.width = 0};  // in the window
    content::Image whole = {.width = 0};      // the reference, reduced
    Window window;                            // in the pixels of `whole`, rounded
    double scale = 1;                         // the FLIP that has the last colour of the maps
};

// Where pictures differ most, and what of them is shown there.

// For each pixel, by how much the display values of the pictures differ from each other; of a single picture, from the
// reference. All have the same size. Between 0 and 1.
std::vector<float> disagreement(std::span<const Picture* const> pictures, const Picture& reference);

// The window of this size, or of the picture's if that is smaller, in which the sum of the values is largest; of equal
// ones the first by rows. There are width × height values.
Window largest_window(const std::vector<float>& values, int width, int height, int window_width, int window_height);

// The window's pixels as they are shown.
content::Image crop(const Picture& picture, const Window& window);
// FLIP in the window, as flip_map computes it for the whole pictures.
std::vector<float> flip_in(const Picture& picture, const Picture& reference, const Window& window);
// In the colours of content::heat.
content::Image colored(std::span<const float> values, const Window& window, double scale);

// What can be said of the report. Shown are all rungs of a scene, found ones too, whose errors are from one reference:
// that of the ladder in which the scene's own rung has the largest error. If nothing but found rungs was measured, they
// are compared with the scene as it is. What is unknown is left out; without anything, the slide has no points and no
// columns.
Slide slide_of(const Report& report);

inline constexpr int slide_width = 1920, slide_height = 1080;
// Everything on the slide, in the order in which it is drawn.
std::vector<content::Mark> slide_marks(const Slide& slide, const content::TextWidth& width);

enum class SlideFormat : std::uint8_t { png, svg, pdf };
// By the ending of the file's name, in any case; nullopt for others.
std::optional<SlideFormat> slide_format(std::string_view path);

struct SlideFile {
    std::string bytes;
    std::string error;  // why it could not be drawn; empty if it was
};
// Equal slides give equal bytes.
SlideFile draw_slide(const Slide& slide, SlideFormat format);
// An <svg> element for a page of HTML; empty if there is nothing to show.
std::string slide_element(const Slide& slide);

}  // namespace snell::accuracy
