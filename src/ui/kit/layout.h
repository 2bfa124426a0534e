// Rectangles of the window's items, in window coordinates from the top left.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace snell::ui {

struct Rect {
    float x = 0, y = 0, width = 0, height = 0;
    bool operator==(const Rect&) const = default;
    bool contains(double px, double py) const { return px >= x && py >= y && px < x + width && py < y + height; }
};

// A widget of one frame, by name ("Glass.uEta", "axes"), so that a test can put the mouse on it.
struct Placed {
    std::string name;
    Rect rect;
    bool visible = false;  // not scrolled out of view
};

class Layout {
public:
    // Names are recorded only if `listening` is true, so that nothing is allocated otherwise.
    explicit Layout(bool listening) : listening_(listening) {}
    void clear() { items_.clear(); }
    // Records Dear ImGui's last item under this name.
    void note(std::string_view name);
    void note(std::string_view first, std::string_view second);
    // Records the window of Dear ImGui that is being drawn.
    void place_window(std::string_view name);
    // Records a rectangle that is not an item of Dear ImGui.
    void place(std::string_view name, const Rect& rect);
    const std::vector<Placed>& items() const { return items_; }

private:
    bool listening_;
    std::vector<Placed> items_;
};

}  // namespace snell::ui
