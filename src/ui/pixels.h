// Pixels as numbers: the one under the pointer while I is held, and how many a picture of bytes can't show.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "src/runtime/flags.h"
#include "src/ui/layout.h"
#include "src/ui/style.h"
#include "src/ui/text.h"
#include "src/ui/widgets.h"

namespace snell {
struct Inspection;
}

namespace snell::ui {

struct Facts;

struct PixelFacts {
    const Inspection* inspection = nullptr;  // while PixelMemory::inspecting
    std::string statement, place;            // that drew it; empty: nothing did
    std::optional<FlagCounts> flags;         // while PixelMemory::flags
    std::string note;                        // why there are none
};

struct PixelMemory {
    bool inspecting = false;  // I is held, over the scene
    float x = 0, y = 0;       // there: window coordinates from the scene's upper left corner
    bool flags = false;       // the view of pixels that are no colours
};

// The shortest text that reads back as the same float; "NaN" and "inf" where it is none.
Text value_text(float value);

// I and N.
void pixel_keys(const Rect& scene, PixelMemory& memory);
void pixels_section(Titles& open, PixelMemory& memory, Layout& layout);
// What the view found: over the picture.
void flags_legend(const Facts& facts, const Rect& scene, const PixelMemory& memory, Layout& layout);
// Beside the pointer.
void inspector(const Facts& facts, const Rect& scene, const PixelMemory& memory, const Fonts& fonts, Layout& layout);

}  // namespace snell::ui
