#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "src/ui/kit/input.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

constexpr double step = 1. / 25;  // seconds per picture, the default of `snell render --frames`

}  // namespace

void clock_panel(const Facts& facts, Memory& memory, Layout& layout) {
    if (!facts.scene || !facts.animated) return;
    Clock& clock = memory.clock;
    if (button(clock.paused ? "Play" : "Pause", layout, "play")) clock.paused = !clock.paused;
    if (next_button("Step", layout, "step")) {
        clock.paused = true;
        clock.time = (std::floor(clock.time / step + 1e-6) + 1) * step;
    }
    if (next_button("0", layout, "rewind")) clock.time = 0;
    follow(width_of("speed") + 5 * ImGui::GetFontSize());
    label("speed");
    number("##speed", clock.speed, false, 1, -FLT_MIN);
    clock.speed = std::clamp(clock.speed, -1e3, 1e3);
    layout.note("speed");

    const double period = std::max(facts.scene->timer_period, 1e-3);
    label("t =");
    if (number("##time", clock.time, false, 0, 6 * ImGui::GetFontSize())) clock.paused = true;
    layout.note("time");
    ImGui::SameLine();
    double within = clock.time - std::floor(clock.time / period) * period;
    SliderRange range{0, period};
    if (slider("##scrub", within, range, within, memory.slider)) {
        clock.paused = true;
        clock.time = within;
    }
    layout.note("scrub");
}

void clock_keys(const Facts& facts, Memory& memory) {
    if ((facts.animated || memory.animating()) && pressed(Key::space)) memory.clock.paused = !memory.clock.paused;
}

}  // namespace snell::ui
