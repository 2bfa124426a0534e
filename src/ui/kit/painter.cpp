#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "src/ui/kit/gui.h"

namespace snell::ui {

Painter::Painter() { ImGui_ImplOpenGL3_Init("#version 330 core"); }

Painter::~Painter() { ImGui_ImplOpenGL3_Shutdown(); }

void Painter::upload_fonts() {
    ImGui_ImplOpenGL3_NewFrame();  // its first call makes the shaders and the fonts' texture
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Painter::paint() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

}  // namespace snell::ui
