// Any bytes as values of --set, one a line, one after the other: shared by the fuzzer and the replay of its corpus.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/plan/values/controls.h"

namespace snell::fuzz {

// Two programs, with a uniform of every kind; names with points in them; one that no program uses.
struct Settable {
    Scene scene;
    Controls controls;

    Settable() {
        scene.programs.resize(2);
        scene.programs[0].name = "Glass";
        scene.programs[1].name = "two.parts";
        add(0, "uEta", ValueType::float_, 1, 1, Widget::slider);
        add(1, "uEta", ValueType::float_, 1, 1, Widget::slider);
        add(0, "uCount", ValueType::int_, 1, 1, Widget::slider);
        add(0, "uUnsigned", ValueType::uint_, 2, 1, Widget::none);
        add(0, "uOn", ValueType::bool_, 1, 1, Widget::check_box);
        add(0, "uColor", ValueType::float_, 4, 1, Widget::color);
        add(1, "uLight.color", ValueType::float_, 3, 1, Widget::none);
        add(1, "uMatrix", ValueType::matrix, 4, 1, Widget::none);
        add(1, "uList", ValueType::int_, 2, 3, Widget::none);
        add(1, "uUnit", ValueType::sampler, 1, 1, Widget::none);
        add(1, "uDouble", ValueType::double_, 1, 1, Widget::slider);
        add(1, "uUnused", ValueType::float_, 1, 1, Widget::slider);
        controls.items.back().active = false;
    }

private:
    void add(Index program, std::string name, ValueType type, int components, int array, Widget widget) {
        Control control;
        control.program = program;
        control.name = std::move(name);
        control.type = type;
        control.components = components;
        control.array_size = array;
        control.widget = widget;
        control.value.assign(static_cast<std::size_t>(components * array), 0);
        control.initial = control.value;
        controls.items.push_back(std::move(control));
    }
};

inline bool holds(ValueType type, double value) {
    const auto within = [value](auto least, auto most) {
        return value >= static_cast<double>(least) && value <= static_cast<double>(most) && value == std::round(value);
    };
    switch (type) {
        case ValueType::bool_:
            return within(0, 1);
        case ValueType::int_:
            return within(std::numeric_limits<int>::min(), std::numeric_limits<int>::max());
        case ValueType::uint_:
            return within(0, std::numeric_limits<unsigned>::max());
        case ValueType::sampler:
            return within(0, std::numeric_limits<int>::max());
        case ValueType::double_:
            return std::isfinite(value);
        case ValueType::float_:
        case ValueType::matrix:
            return std::isfinite(static_cast<float>(value));
    }
    return false;
}

// Empty when all is well, else what is wrong with a control.
inline std::string check_control(const Control& control) {
    if (control.value.size() != static_cast<std::size_t>(control.components * control.array_size))
        return "another number of values";
    for (const double value : control.value)
        if (!holds(control.type, value)) return "a value that the uniform can't have";
    if (control.widget != Widget::slider) return {};
    if (!std::isfinite(control.min) || !std::isfinite(control.max) || !std::isfinite(control.max - control.min) ||
        control.min > control.max)
        return "a range that is none";
    return {};
}

inline std::string check_assignment(Settable& settable, std::string_view assignment) {
    const auto before = values_of(settable.controls);
    Diagnostics diagnostics;
    const bool done = set_control(settable.controls, settable.scene, assignment, diagnostics);
    if (done == diagnostics.has_errors()) return done ? "done, with an error" : "not done, and no error";
    if (!done && values_of(settable.controls) != before) return "not done, and something changed";
    const Sources sources;
    for (const char c : render(diagnostics, sources))
        if (static_cast<unsigned char>(c) < 0x20 && c != '\n') return "a control character in the diagnostics";
    for (const Control& control : settable.controls.items)
        if (std::string wrong = check_control(control); !wrong.empty()) return control.name + ": " + wrong;
    // The same again changes nothing more.
    const auto after = values_of(settable.controls);
    Diagnostics again;
    if (set_control(settable.controls, settable.scene, assignment, again) != done) return "another answer";
    return values_of(settable.controls) == after ? "" : "set twice is another value";
}

inline std::string check_settings(std::string_view bytes) {
    Settable settable;
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        if (std::string wrong = check_assignment(settable, bytes.substr(0, end)); !wrong.empty()) return wrong;
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    return {};
}

}  // namespace snell::fuzz
