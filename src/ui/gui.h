// Dear ImGui's context and its frames, without any GL; and the painter that brings them onto the screen.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "src/platform/window.h"
#include "src/ui/style.h"

struct ImGuiContext;

namespace snell::ui {

struct Screen {
    float width = 0, height = 0;  // window coordinates
    float density = 1;            // pixels for one of them
    float scale = 1;              // of text and widgets, in window coordinates
    Theme theme = Theme::light;
    bool operator==(const Screen&) const = default;
};

class Gui {
public:
    // `window`, if any, lends its clipboard.
    explicit Gui(Window* window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    // Takes the input for a frame, `seconds` after the last one. True: the fonts are new, upload them first.
    bool input(const Screen& screen, double seconds, std::span<const Event> events);
    // Of the last input.
    const Screen& screen() const { return screen_; }
    // A frame: panels go between. The same number from two means the same picture.
    void begin();
    std::uint64_t end();

    const Fonts& fonts() const { return fonts_; }
    Cursor cursor() const;

    struct Clipboard;

private:
    ImGuiContext* context_;
    std::unique_ptr<Clipboard> clipboard_;
    Screen screen_;
    Fonts fonts_;
};

// Needs the GL context that was current when it was made, and a Gui.
class Painter {
public:
    Painter();
    ~Painter();
    Painter(const Painter&) = delete;
    Painter& operator=(const Painter&) = delete;

    // When Gui::input says so.
    void upload_fonts();
    // Over what the bound framebuffer shows.
    void paint();
};

}  // namespace snell::ui
