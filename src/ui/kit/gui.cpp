#include "src/ui/kit/gui.h"

#include <algorithm>
#include <cfloat>
#include <cstring>
#include <string>

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "src/ui/kit/input.h"
#include "src/ui/kit/kit.h"

namespace snell::ui {

// Text that is handed out must outlive the call. Dear ImGui copies it at once, so one string per context is enough.
struct Gui::Clipboard {
    Window* window;
    std::string text;
};

namespace {

const char* get_clipboard(void* data) {
    auto& clipboard = *static_cast<Gui::Clipboard*>(data);
    clipboard.text = clipboard.window->clipboard();
    return clipboard.text.c_str();
}

void set_clipboard(void* data, const char* text) { static_cast<Gui::Clipboard*>(data)->window->set_clipboard(text); }

// FNV-1a over words of eight bytes.
void mix(std::uint64_t& hash, const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; i += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes + i, std::min<std::size_t>(8, size - i));
        hash = (hash ^ word) * 1099511628211U;
        hash ^= hash >> 29;
    }
}

std::uint64_t hash_of(const ImDrawData& data) {
    std::uint64_t hash = 14695981039346656037U;
    mix(hash, &data.DisplaySize, sizeof data.DisplaySize);
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        mix(hash, list.VtxBuffer.Data, static_cast<std::size_t>(list.VtxBuffer.size_in_bytes()));
        mix(hash, list.IdxBuffer.Data, static_cast<std::size_t>(list.IdxBuffer.size_in_bytes()));
        for (const ImDrawCmd& command : list.CmdBuffer) {
            mix(hash, &command.ClipRect, sizeof command.ClipRect);
            mix(hash, &command.ElemCount, sizeof command.ElemCount);
            mix(hash, &command.TextureId, sizeof command.TextureId);
        }
    }
    return hash;
}

}  // namespace

Gui::Gui(Window* window) : context_(ImGui::CreateContext()), kit_(std::make_unique<Kit>()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.UserData = kit_.get();
    io.IniFilename = nullptr;
    io.ConfigInputTextCursorBlink = false;  // a blinking cursor would need a frame every half second
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
    io.MousePos = {-FLT_MAX, -FLT_MAX};
    map_keys();
    if (window) {
        clipboard_ = std::make_unique<Clipboard>(Clipboard{window, {}});
        io.ClipboardUserData = clipboard_.get();
        io.GetClipboardTextFn = get_clipboard;
        io.SetClipboardTextFn = set_clipboard;
    }
}

Gui::~Gui() { ImGui::DestroyContext(context_); }

bool Gui::input(const Screen& screen, double seconds, std::span<const Event> events) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    const bool new_fonts = !fonts_.text || screen.scale != screen_.scale || screen.density != screen_.density;
    if (new_fonts) {
        fonts_ = load_fonts(screen.scale, screen.density);
        io.Fonts->Build();
    }
    if (new_fonts || screen.theme != screen_.theme) apply_style(screen.scale, screen.theme);
    screen_ = screen;
    io.DisplaySize = {screen.width, screen.height};
    io.DisplayFramebufferScale = {screen.density, screen.density};
    io.DeltaTime = static_cast<float>(std::max(seconds, 1e-5));
    feed(events);
    return new_fonts;
}

void Gui::begin() {
    begin_kit();
    ImGui::NewFrame();
}

double Gui::due() const { return tip_due(); }

std::uint64_t Gui::end() {
    end_kit();
    ImGui::Render();
    return hash_of(*ImGui::GetDrawData());
}

bool Gui::pressed() const { return ImGui::IsAnyMouseDown(); }
bool Gui::busy() const { return ImGui::IsAnyItemActive() || ImGui::IsAnyMouseDown(); }

Cursor Gui::cursor() const {
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            return Cursor::text;
        case ImGuiMouseCursor_Hand:
            return Cursor::hand;
        case ImGuiMouseCursor_ResizeEW:
            return Cursor::resize_horizontal;
        case ImGuiMouseCursor_ResizeNS:
            return Cursor::resize_vertical;
        default:
            return Cursor::arrow;
    }
}

Painter::Painter() { ImGui_ImplOpenGL3_Init("#version 330 core"); }

Painter::~Painter() { ImGui_ImplOpenGL3_Shutdown(); }

void Painter::upload_fonts() {
    ImGui_ImplOpenGL3_NewFrame();  // its first call makes the shaders and the fonts' texture
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Painter::paint() { ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData()); }

}  // namespace snell::ui
