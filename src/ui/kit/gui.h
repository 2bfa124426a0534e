// Dear ImGui's context and frames, without GL, and the painter that draws them with GL.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "src/platform/window.h"
#include "src/ui/kit/style.h"

struct ImGuiContext;

namespace snell::ui {

struct Screen {
    float width = 0, height = 0;  // in window coordinates
    float density = 1;            // pixels per window coordinate
    float scale = 1;              // factor for text and widgets, in window coordinates
    Theme theme = Theme::light;
    bool operator==(const Screen&) const = default;
};

class Gui {
public:
    // Uses the clipboard of `window`, if it is not null.
    explicit Gui(Window* window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    // Passes the input for a frame that begins `seconds` after the last one. Returns true if the fonts were rebuilt and
    // must be uploaded first.
    bool input(const Screen& screen, double seconds, std::span<const Event> events);
    // The screen of the last call of input().
    const Screen& screen() const { return screen_; }
    // Begin and end of a frame; panels are drawn in between. end() returns a hash of the frame: equal hashes mean equal
    // pictures.
    void begin();
    std::uint64_t end();

    const Fonts& fonts() const { return fonts_; }
    Cursor cursor() const;
    // True while a mouse button is down.
    bool pressed() const;

    struct Clipboard;

private:
    ImGuiContext* context_;
    std::unique_ptr<Clipboard> clipboard_;
    Screen screen_;
    Fonts fonts_;
};

// Draws Dear ImGui's frames with GL. The context that was current when it was made must be current for every call, and
// a Gui must exist.
class Painter {
public:
    Painter();
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    // Must be called if Gui::input returns true.
    void upload_fonts();
    // Draws over the contents of the bound framebuffer.
    void paint();
};

}  // namespace snell::ui
