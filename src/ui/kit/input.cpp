#include "src/ui/kit/input.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <utility>

#include "src/ui/kit/kit.h"

namespace snell::ui {

namespace {

bool is_press(const Event& event) { return event.kind == Event::Kind::button || event.kind == Event::Kind::key; }

// Two presses are a double click by when they happened, however long the frames between them took: if they may be close
// together, and cannot be a second apart. Of presses during a longer frame nobody knows. They are two clicks, because
// what two clicks do can be undone, and a double click takes back the first one and opens a field that gets the next
// keys. Dear ImGui compares the times of frames, so it is told to take any press or none; it knows how many pixels lie
// between them.
void count_click(const Event& event) {
    constexpr double longest = .3, apart = 1;  // seconds
    ClickMemory& last = kit().click;
    const double until = event.known ? event.since : event.seen;
    const double least = event.since - last.until, most = until - last.since;
    const bool soon = last.button == event.button && least < longest && most <= apart;
    ImGui::GetIO().MouseDoubleClickTime = soon ? 1e6F : -1;
    last = {event.button, event.since, until};
}

}  // namespace

std::size_t batch(std::span<const Event> events) {
    if (events.empty()) return 0;
    std::size_t count = 1;
    if (is_press(events[0])) {
        // The character of a key press follows directly.
        while (count < events.size() && events[count].kind == Event::Kind::text) ++count;
    } else {
        while (count < events.size() && !is_press(events[count])) ++count;
    }
    return count;
}

bool pressed(Key key, bool repeat) { return ImGui::IsKeyPressed(static_cast<int>(key), repeat); }

bool plain(Key key) { return pressed(key) && !ImGui::GetIO().KeyCtrl; }

bool any_pressed() {
    for (int key = 0; key < static_cast<int>(Key::count_); ++key)
        if (static_cast<Key>(key) != Key::other && pressed(static_cast<Key>(key))) return true;
    return false;
}

void take(Key key) {
    // A key that was pressed some time ago is held, not pressed.
    ImGui::GetIO().KeysDownDuration[static_cast<int>(key)] = FLT_MIN;
}

void map_keys() {
    static constexpr std::array<std::pair<ImGuiKey_, Key>, 21> table{{
        {ImGuiKey_LeftArrow, Key::left},
        {ImGuiKey_RightArrow, Key::right},
        {ImGuiKey_UpArrow, Key::up},
        {ImGuiKey_DownArrow, Key::down},
        {ImGuiKey_PageUp, Key::page_up},
        {ImGuiKey_PageDown, Key::page_down},
        {ImGuiKey_Home, Key::home},
        {ImGuiKey_End, Key::end},
        {ImGuiKey_Insert, Key::insert},
        {ImGuiKey_Delete, Key::delete_},
        {ImGuiKey_Backspace, Key::backspace},
        {ImGuiKey_Space, Key::space},
        {ImGuiKey_Enter, Key::enter},
        {ImGuiKey_Escape, Key::escape},
        {ImGuiKey_KeyPadEnter, Key::keypad_enter},
        {ImGuiKey_A, Key::a},
        {ImGuiKey_C, Key::c},
        {ImGuiKey_V, Key::v},
        {ImGuiKey_X, Key::x},
        {ImGuiKey_Y, Key::y},
        {ImGuiKey_Z, Key::z},
    }};
    ImGuiIO& io = ImGui::GetIO();
    io.KeyMap[ImGuiKey_Tab] = -1;  // the values have their own order, see focusable()
    for (const auto& [imgui, key] : table) io.KeyMap[imgui] = static_cast<int>(key);
}

void feed(std::span<const Event> events) {
    ImGuiIO& io = ImGui::GetIO();
    for (const Event& event : events) {
        switch (event.kind) {
            case Event::Kind::move:
                io.MousePos = {static_cast<float>(event.x), static_cast<float>(event.y)};
                break;
            case Event::Kind::leave:
                // While a button is down, the drag continues outside of the window.
                if (std::none_of(std::begin(io.MouseDown), std::end(io.MouseDown), [](bool down) { return down; }))
                    io.MousePos = {-FLT_MAX, -FLT_MAX};
                break;
            case Event::Kind::button:
                io.MouseDown[static_cast<int>(event.button)] = event.down;
                if (event.down) count_click(event);
                break;
            case Event::Kind::wheel:
                io.MouseWheelH += static_cast<float>(event.x);
                io.MouseWheel += static_cast<float>(event.y);
                break;
            case Event::Kind::key:
                if (event.key != Key::other) io.KeysDown[static_cast<int>(event.key)] = event.down;
                break;
            case Event::Kind::text:
                io.AddInputCharacter(static_cast<unsigned>(event.text));
                break;
            case Event::Kind::focus:
                io.AddFocusEvent(event.down);
                break;
            case Event::Kind::resize:
            case Event::Kind::refresh:
                break;
        }
        if (is_press(event)) {
            if (event.down) kit().late = event.seen - event.since;
            io.KeyShift = event.modifiers.shift;
            io.KeyCtrl = event.modifiers.ctrl;
            io.KeyAlt = event.modifiers.alt;
        }
    }
}

}  // namespace snell::ui
