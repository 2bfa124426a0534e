// One picture of a report that needs no explanation: error against time, and what the errors look like. Values in,
// files out; no GL.
#pragma once

#include <cstdint>
#include <optional>
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
