// What frames cost: the last ones as a plot, and the passes and draws of one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/ui/layout.h"

namespace snell::ui {

struct Facts;
struct Memory;

// A pass or, below it, its draws.
struct CostRow {
    std::string name, place;
    double milliseconds = 0;  // median
    bool draw = false;
};

struct FrameCostFacts {
    std::string_view clock;           // of the frames and of `passes`
    std::span<const float> frames;    // milliseconds, the last one at the end
    float median = 0, high = 0;       // 95 of 100 take no longer
    std::span<const CostRow> passes;  // of the frames that were drawn; empty where there is no clock for them
    std::span<const CostRow> apart;   // measured on request, in frames of their own
    std::string_view apart_clock;
    std::optional<double> measuring;  // 0..1: these frames are being drawn
};

// Memory::frame_cost: open. True: passes and draws are to be measured; or, while they are, no more.
bool frame_cost_section(const Facts& facts, Memory& memory, Layout& layout);

}  // namespace snell::ui
