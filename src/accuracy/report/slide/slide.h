// One picture of a report that needs no explanation: error against time, and what the errors look like. Values in,
// files out; no GL.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/accuracy/report/report.h"

namespace snell::accuracy {

// RGB, top row first.
struct Raster {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
};

// The part of a picture that is magnified, in its pixels.
struct Window {
    int x = 0, y = 0, width = 0, height = 0;
};

inline constexpr std::size_t no_column = std::numeric_limits<std::size_t>::max();

struct SlidePoint {
    std::string name;
    double error = 0;  // 0: equal to the reference; infinite: pixels that are not finite
    // The ratio to the scene's own rung in its own table, and its interval, times one time of the scene.
    double milliseconds = 0, low = 0, high = 0;
    bool front = false;
    bool own = false;                // as the scene sets it
    std::size_t column = no_column;  // where its picture is shown

    bool has_interval() const { return low > 0 && std::isfinite(high); }
};

// A rung whose picture is shown.
struct SlideColumn {
    std::string name;
    double error = 0, milliseconds = 0;  // a time of 0 is unknown
    bool own = false;
    bool equal_time = false, equal_error = false;  // to that of the scene's own rung
    Raster picture, map;                           // of the window: the rung, and its FLIP from the reference
};

struct Slide {
    std::string title, note;
    std::string clock;  // what the times are of
    std::string stamp;  // why there is no front, and what is left out; empty if there is one of all
    std::vector<SlidePoint> points;
    double floor = 0;  // errors below it can't be told apart; 0 if it is unknown
    std::vector<SlideColumn> columns;
    Raster reference;  // in the window
    Raster whole;      // the reference, reduced
    Window window;     // in the pixels of `whole`, rounded
    double scale = 1;  // the FLIP that has the last colour of the maps
};

// What can be said of the report. Shown are all rungs of a scene, found ones too, whose errors are from one reference:
// that of the ladder in which the scene's own rung has the largest error. If nothing but found rungs was measured, they
// are compared with the scene as it is. What is unknown is left out; without anything, the slide has no points and no
// columns.
Slide slide_of(const Report& report);

inline constexpr int slide_width = 1920, slide_height = 1080;
enum class SlideFormat : std::uint8_t { png, svg, pdf };
// By the ending of the file's name, in any case; nullopt for others.
std::optional<SlideFormat> slide_format(std::string_view path);

struct SlideFile {
    std::string bytes;
    std::string error;  // why it could not be drawn; empty if it was
};
// Equal slides give equal bytes.
SlideFile draw_slide(const Slide& slide, SlideFormat format);
// An <svg> element for a page of HTML; empty if it could not be drawn, or there is nothing to show.
std::string slide_element(const Slide& slide, std::string& error);

}  // namespace snell::accuracy
