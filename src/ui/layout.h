// Where things are in the window: window coordinates, from the top left.
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

// The widgets of one frame by name ("Glass.uEta", "axes"), so that a test can put the mouse on one.
struct Placed {
    std::string name;
    Rect rect;
    bool visible = false;  // not scrolled away
};

class Layout {
public:
    // Only a listener pays for the names.
    explicit Layout(bool listening) : listening_(listening) {}
    void clear() { items_.clear(); }
    // The last item of Dear ImGui.
    void note(std::string_view name);
    void note(std::string_view first, std::string_view second);
    // What is no item.
    void place(std::string_view name, const Rect& rect);
    const std::vector<Placed>& items() const { return items_; }

private:
    bool listening_;
    std::vector<Placed> items_;
};

}  // namespace snell::ui
