// Values of pixels: of the one under the pointer while I is held, and counts of pixels whose values a picture of bytes
// cannot hold.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "src/runtime/flags.h"
#include "src/ui/kit/layout.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/text.h"
#include "src/ui/kit/widgets.h"

namespace snell {
struct Inspection;
}

namespace snell::ui {

struct Facts;

struct PixelFacts {
    const Inspection* inspection = nullptr;  // set while PixelMemory::inspecting
    std::string statement, place;            // the draw that the pixel shows; empty if none covers it
    std::optional<FlagCounts> flags;         // set while PixelMemory::flags
    std::string note;                        // why there are no flags; empty if there are
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
// Draws a legend with the counts of flagged pixels over the picture.
void flags_legend(const Facts& facts, const Rect& scene, const PixelMemory& memory, Layout& layout);
// Draws the pixel's values next to the pointer.
void inspector(const Facts& facts, const Rect& scene, const PixelMemory& memory, const Fonts& fonts, Layout& layout);

}  // namespace snell::ui
