#include "src/ui/panels/picture_out.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "src/platform/window.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

constexpr const char* title = "Save picture";
constexpr double most_pictures = 1e6, largest = 1e6;

void label(const char* text, const char* help = nullptr) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(text);
    if (help && ImGui::IsItemHovered()) ImGui::SetTooltip("%s", help);
    ImGui::SameLine(7 * ImGui::GetFontSize());
}

void whole(const char* id, double& value, double initial, Layout& layout, const char* name, double most) {
    number(id, value, true, initial, 5 * ImGui::GetFontSize());
    value = std::clamp(std::round(value), 1., most);
    layout.note(name);
}

void times(const char* id, double factor, PictureMemory& picture, const Rect& scene, double density) {
    follow(button_width(id));
    if (!ImGui::Button(id)) return;
    picture.width = std::max(1., std::round(scene.width * density * factor));
    picture.height = std::max(1., std::round(scene.height * density * factor));
}

void size_row(PictureMemory& picture, const Rect& scene, Layout& layout) {
    const double density = ImGui::GetIO().DisplayFramebufferScale.x;
    label("Size");
    whole("##width", picture.width, picture.width, layout, "picture width", largest);
    ImGui::SameLine();
    ImGui::TextUnformatted("\u00d7");
    ImGui::SameLine();
    whole("##height", picture.height, picture.height, layout, "picture height", largest);
    times("Window size", 1, picture, scene, density);
    layout.note("picture window size");
    times("\u00d7 4", 4, picture, scene, density);
    layout.note("picture times 4");
    label("Samples", "samples per pixel; more make edges smoother");
    whole("##samples", picture.samples, 4, layout, "picture samples", 64);
    follow(check_box_width("Transparent"), ImGui::GetFontSize());
    ImGui::Checkbox("Transparent", &picture.transparent);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Leaves out the background (PNG and EXR only)");
    layout.note("picture transparent");
}

void sequence_rows(PictureMemory& picture, Layout& layout) {
    label("Sequence", "numbered pictures of a time span");
    ImGui::Checkbox("##sequence", &picture.sequence);
    layout.note("picture sequence");
    if (!picture.sequence) return;
    const float field = 5 * ImGui::GetFontSize();
    label("Seconds");
    number("##from", picture.from, false, 0, field);
    layout.note("picture from");
    ImGui::SameLine();
    ImGui::TextUnformatted("to");
    ImGui::SameLine();
    number("##to", picture.to, false, 10, field);
    layout.note("picture to");
    label("Per second");
    number("##rate", picture.rate, false, 25, field);
    picture.rate = std::clamp(picture.rate, 1e-3, 1e5);
    layout.note("picture rate");
    const int count = picture_count(picture);
    const std::string told = fmt::format("{} picture{}, the last at {:.6g} s", count, count == 1 ? "" : "s",
                                         picture.from + (count - 1) / picture.rate);
    follow(ImGui::CalcTextSize(told.c_str()).x);
    ImGui::TextDisabled("%s", told.c_str());
}

void answers(PictureMemory& picture, Requests& requests, Layout& layout) {
    const bool asks = !picture.there.empty() && picture.there == picture.file.data();
    if (asks) ImGui::TextWrapped("%s exists. Replace it?", shortened(picture.there, 30 * ImGui::GetFontSize()).c_str());
    if (!picture.error.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
        ImGui::TextWrapped("%s", picture.error.c_str());
        ImGui::PopStyleColor();
        layout.note("picture error");
    }
    if (ImGui::Button(asks ? "Replace" : "Save"))
        requests.picture = asks ? PictureRequest::replace : PictureRequest::save;
    layout.note("picture save");
    follow(button_width("Copy command"));
    if (ImGui::Button("Copy command")) requests.picture = PictureRequest::command;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Copies the 'snell render' command that draws the same");
    layout.note("picture command");
    follow(button_width("Cancel"));
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(static_cast<int>(Key::escape), false)) picture.open = false;
    layout.note("picture cancel");
}

void progress_row(const PictureMemory& picture, Requests& requests, Layout& layout) {
    const float stop = button_width("Stop") + ImGui::GetStyle().ItemSpacing.x;
    const std::string percent = fmt::format("{:.0f} %", std::floor(*picture.progress * 100));
    ImGui::ProgressBar(static_cast<float>(*picture.progress), {-stop, 0}, percent.c_str());
    ImGui::SameLine();
    if (ImGui::Button("Stop") || ImGui::IsKeyPressed(static_cast<int>(Key::escape), false))
        requests.picture = PictureRequest::stop;
    layout.note("picture stop");
}

}  // namespace

int picture_count(const PictureMemory& picture) {
    if (!picture.sequence) return 1;
    return static_cast<int>(std::clamp(std::round((picture.to - picture.from) * picture.rate), 1., most_pictures));
}

void picture_button(Requests& requests, Layout& layout) {
    follow(button_width("Save picture\u2026"));
    if (ImGui::Button("Save picture\u2026")) requests.picture = PictureRequest::open;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Saves this picture in any size, or a sequence");
    layout.note("picture");
}

void picture_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    PictureMemory& picture = memory.picture;
    if (!picture.open || !facts.scene) return;
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(36 * em, all.x - em), 0});
    if (!ImGui::BeginPopupModal(title, nullptr,
                                ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize))
        return;
    ImGui::BeginDisabled(picture.progress.has_value());
    label("File", "The extension sets the format: .png, .bmp, .exr \u2026");
    ImGui::SetNextItemWidth(-FLT_MIN);
    ImGui::InputText("##file", picture.file.data(), picture.file.size());
    layout.note("picture file");
    size_row(picture, memory.scene, layout);
    if (facts.animated)
        sequence_rows(picture, layout);
    else
        picture.sequence = false;
    ImGui::EndDisabled();
    ImGui::Spacing();
    if (picture.progress)
        progress_row(picture, requests, layout);
    else
        answers(picture, requests, layout);
    if (!picture.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace snell::ui
