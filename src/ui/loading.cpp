#include "src/ui/loading.h"

#include <imgui.h>

#include <algorithm>

#include "src/ui/kit/widgets.h"

namespace snell::ui {

void loading(const std::string& text, double share) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(30 * em, all.x), 0});
    ImGui::Begin("##loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
    fitted(text, ImGui::GetContentRegionAvail().x);
    ImGui::ProgressBar(static_cast<float>(std::clamp(share, 0., 1.)), {-1, .5F * em}, "");
    ImGui::End();
}

}  // namespace snell::ui
