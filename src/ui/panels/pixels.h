// Values of pixels: of the one under the pointer while I is held, and counts of pixels whose values a picture of bytes
// cannot hold.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/runtime/inspect.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/text.h"
#include "src/ui/kit/widgets.h"

namespace snell {
struct Inspection;
}

namespace snell::ui {

struct Facts;

// Of what is seen of a picture.
struct Flagged {
    std::string half;  // as PixelFacts has it
    FlagCounts counts;
    bool operator==(const Flagged&) const = default;
};

struct PixelFacts {
    const Inspection* inspection = nullptr;  // set while PixelMemory::inspecting
    std::string at;                          // "pixel 12, 34"
    std::string half;                        // "right: as saved", where two states are shown
    std::string statement, place;            // what the pixel shows, and more of it; both empty if nothing covers it
    std::optional<double> difference;        // of light between two states, under their heat map
    std::vector<Flagged> flags;              // of each half, once they are there; empty while !PixelMemory::flags
    std::string note;                        // why there are no flags; empty if there are
    std::optional<double> drawn;             // how much of a picture with new flags, where that takes long
};

struct PixelMemory {
    bool inspecting = false;  // I is held while the pointer is over the scene
    float x = 0, y = 0;       // position of the pointer, in window coordinates from the scene's upper left corner
    bool flags = false;       // shows the view of pixels whose values are not colours
};

// The shortest text that reads back as the same float, or "NaN" or "inf".
Text value_text(float value);

// Handles I and N.
void pixel_keys(const Rect& scene, PixelMemory& memory);
void pixels_section(Titles& open, PixelMemory& memory, Layout& layout);
// Draws the counts of flagged pixels in a line for each half, or below each other if they are wider than `room`.
void flag_counts(std::span<const Flagged> halves, float room);
// Draws a legend with the counts of flagged pixels over the picture. Returns where it ends.
float flags_legend(const Facts& facts, const Rect& scene, const PixelMemory& memory, Layout& layout);
// Draws the values of a pixel next to the pointer, within `area` if there is room, and otherwise over all.
void inspector(const PixelFacts& pixels, const Rect& area, const Fonts& fonts, Layout& layout);
void inspector(const Facts& facts, const Rect& scene, const PixelMemory& memory, const Fonts& fonts, Layout& layout);

}  // namespace snell::ui
