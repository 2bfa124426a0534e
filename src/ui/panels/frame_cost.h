// The frame cost panel: a plot of the last frames' times, and the times of the passes and draws of a frame.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "src/ui/kit/kit.h"

namespace snell::ui {

struct Facts;
struct Memory;

// The time of a pass; rows of its draws follow it.
struct CostRow {
    std::string name, place;
    double milliseconds = 0;  // median
    bool draw = false;
};

struct FrameCostFacts {
    std::span<const float> frames;    // of the last pictures, in milliseconds as Facts::frame_ms, oldest first
    float median = 0, high = 0;       // `high` is the 95th percentile
    std::span<const CostRow> passes;  // of the frames that were drawn, by the GPU's clock; empty if it has none
    std::span<const CostRow> apart;   // measured on request, in additional frames
    std::string_view apart_clock;
    double apart_plain = 0;           // a whole one of these frames, without waits or queries between its draws
    std::optional<double> measuring;  // progress 0..1 while the additional frames are drawn
};

// Draws Facts::frame_ms. Every panel with the time of the window's picture says it so.
void last_picture(const Facts& facts, Layout& layout);

// Draws the section; Memory::frame_cost says whether it is open. Returns true if the user starts measuring passes and
// draws, or stops it while it runs.
bool frame_cost_section(const Facts& facts, Memory& memory, Layout& layout);

}  // namespace snell::ui
