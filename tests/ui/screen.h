// The panels on a screen that is only memory: events in, values and places out.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "src/ui/kit/gui.h"
#include "src/ui/shell.h"

namespace snell::ui {

class UiTest : public ::testing::Test {
protected:
    UiTest() {
        scene_.cameras.push_back({});
        add_program("Glass");
    }

    void add_program(const std::string& name) {
        Program program;
        program.name = name;
        scene_.programs.push_back(program);
        linked_.push_back(1);
    }

    Control& add_slider(const std::string& name, double min, double value, double max,
                        ValueType type = ValueType::float_) {
        Control control;
        control.program = static_cast<Index>(scene_.programs.size() - 1);
        control.name = name;
        control.type = type;
        control.widget = Widget::slider;
        control.min = control.initial_min = min;
        control.max = control.initial_max = max;
        control.value = control.initial = {value};
        controls_.items.push_back(control);
        return controls_.items.back();
    }

    // The events of a frame are seen when it begins.
    void frame(std::vector<Event> events = {}, double seconds = .02) {
        clock_ += seconds;
        for (Event& event : events)
            if (event.seen == 0) event.since = event.seen = clock_;
        std::span<const Event> rest(events);
        do {
            const std::size_t count = batch_of(rest);
            gui_.input(screen_, std::exchange(seconds, 0), rest.first(count));
            gui_.begin();
            facts_.scene = no_scene_ ? nullptr : &scene_;
            facts_.linked = linked_;
            requests_ = shell(facts_, controls_, view_, memory_, gui_.fonts(), layout_);
            picture_ = gui_.end();
            rest = rest.subspan(count);
        } while (!rest.empty());
    }

    static Event move(double x, double y) { return {.kind = Event::Kind::move, .x = x, .y = y}; }
    static Event button(bool down, MouseButton button = MouseButton::left, Modifiers modifiers = {}) {
        return {.kind = Event::Kind::button, .button = button, .down = down, .modifiers = modifiers};
    }
    static Event wheel(double steps) { return {.kind = Event::Kind::wheel, .y = steps}; }
    static Event key(Key key, bool down) { return {.kind = Event::Kind::key, .key = key, .down = down}; }

    // The place of a widget after the frames that Dear ImGui needs to settle.
    Rect place(const std::string& name) {
        for (int i = 0; i < 3; ++i) frame();
        for (const Placed& placed : layout_.items())
            if (placed.name == name) return placed.rect;
        ADD_FAILURE() << "no widget " << name;
        return {};
    }
    bool has(const std::string& name) {
        for (int i = 0; i < 3; ++i) frame();
        for (const Placed& placed : layout_.items())
            if (placed.name == name) return true;
        return false;
    }

    void click(const Rect& at, MouseButton which = MouseButton::left, double fraction = .5, Modifiers modifiers = {}) {
        frame({move(at.x + at.width * fraction, at.y + at.height / 2)});
        frame({button(true, which, modifiers)});
        frame({button(false, which)});
        frame({}, 1);  // the next click is no double click
    }

    // An entry of one of the toolbar's menus: "open", "save" or "view".
    void choose(const std::string& menu, const std::string& item) {
        click(place("menu." + menu));
        click(place(item));
    }

    void type(const std::string& text) {
        std::vector<Event> events;
        for (char c : text) events.push_back({.kind = Event::Kind::text, .text = static_cast<char32_t>(c)});
        frame(events);
        frame({key(Key::enter, true)});
        frame({key(Key::enter, false)});
    }

    Scene scene_;
    bool no_scene_ = false;
    std::vector<char> linked_;
    Controls controls_;
    View view_;
    Memory memory_;
    Layout layout_{true};
    Facts facts_;
    Requests requests_;
    Screen screen_{1280, 800, 1, 1};
    std::uint64_t picture_ = 0;
    double clock_ = 0;
    Gui gui_{nullptr};

private:
    static std::size_t batch_of(std::span<const Event> events);
};

}  // namespace snell::ui
