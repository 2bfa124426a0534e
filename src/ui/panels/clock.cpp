#include "src/ui/panels/clock.h"

#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "src/platform/window.h"

namespace snell::ui {

namespace {

constexpr double step = 1. / 25;  // seconds per picture, the default of `snell render --frames`

}  // namespace

void clock_panel(const Facts& facts, Memory& memory, Layout& layout) {
    if (!facts.scene || !facts.animated) return;
    Clock& clock = memory.clock;
    if (ImGui::Button(clock.paused ? "Play" : "Pause")) clock.paused = !clock.paused;
    layout.note("play");
    follow(button_width("Step"));
    if (ImGui::Button("Step")) {
        clock.paused = true;
        clock.time = (std::floor(clock.time / step + 1e-6) + 1) * step;
    }
    layout.note("step");
    follow(button_width("0"));
    if (ImGui::Button("0")) clock.time = 0;
    layout.note("rewind");
    follow(ImGui::CalcTextSize("speed").x + 5 * ImGui::GetFontSize());
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("speed");
    ImGui::SameLine();
    number("##speed", clock.speed, false, 1, -FLT_MIN);
    clock.speed = std::clamp(clock.speed, -1e3, 1e3);
    layout.note("speed");

    const double period = std::max(facts.scene->timer_period, 1e-3);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("t =");
    ImGui::SameLine();
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
    if (facts.animated && ImGui::IsKeyPressed(static_cast<int>(Key::space), false))
        memory.clock.paused = !memory.clock.paused;
}

}  // namespace snell::ui
