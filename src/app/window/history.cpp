#include "src/app/window/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "src/app/open/write_copy.h"
#include "src/document/save_values.h"
#include "src/plan/objects.h"
#include "src/ui/kit/numbers.h"

namespace snell {

namespace {

constexpr double one_gesture = .5;  // seconds between changes of one gesture

std::vector<std::pair<std::string, std::string>> chosen_rungs(const Scene& scene, const Rungs& rungs) {
    std::vector<std::pair<std::string, std::string>> chosen;
    for (std::size_t i = 0; i < scene.ladders.size() && i < rungs.size(); ++i)
        chosen.emplace_back(scene.ladders[i].name, scene.ladders[i].rungs[rungs[i]]);
    return chosen;
}

// The mouse's position is an input of the scene, and not what the user arranges.
View without_mouse(View view) {
    view.mouse_x = view.mouse_y = 0;
    return view;
}

std::string numbers(const Control& control, const std::vector<double>& value) {
    if (control.widget == Widget::check_box) return value[0] == 0 ? "off" : "on";
    if (value.size() > 4) return fmt::format("{} numbers", value.size());
    std::string text;
    for (const double number : value) text += fmt::format("{}{:.6g}", text.empty() ? "" : " ", number);
    return value.size() > 1 ? "(" + text + ")" : text;
}

std::string what_differs(const View& a, const View& b) {
    if (a.axes != b.axes && view_text(a) == view_text(b))
        return b.axes ? "axes hidden \u2192 shown" : "axes shown \u2192 hidden";
    if (a.background != b.background) return "background";
    return a.projection != b.projection ? "projection" : "view";
}

bool set_rung(const Scene& scene, Rungs& rungs, const std::string& ladder, const std::string& rung) {
    Diagnostics ignored;
    return rungs.size() == scene.ladders.size() && choose_rung(rungs, scene, ladder + "=" + rung, ignored);
}

std::string exchange(const SavedFile& file, bool forward) {
    if (forward) return write_saved({file});
    std::string error = revert_saved({file});
    std::error_code none;
    if (error.empty() && file.before.empty()) std::filesystem::remove(file.path, none);
    return error;
}

}  // namespace

std::size_t History::Step::bytes() const {
    std::size_t sum = sizeof(Step);
    for (const auto& change : values)
        sum += sizeof(change) + change.name.size() + (change.before.value.size() + change.after.value.size()) * 8;
    for (const auto& change : rungs) sum += sizeof(change) + change.name.size() + 64;
    if (view) sum += (view->before.objects.size() + view->after.objects.size()) * 128;
    return sum + file.before.size() + file.after.size();
}

bool History::Step::extends(const Step& last) const {
    const auto same = [](const auto& a, const auto& b) { return a.name == b.name; };
    return presses == last.presses && time < last.time + one_gesture && last.snapshot == 0 &&
           view.has_value() == last.view.has_value() && ranges::equal(values, last.values, same) &&
           ranges::equal(rungs, last.rungs, same);
}

bool History::Step::merge(Step&& later) {
    const auto moved = [](const auto& change) { return change.before != change.after; };
    for (std::size_t i = 0; i < values.size(); ++i) values[i].after = std::move(later.values[i].after);
    for (std::size_t i = 0; i < rungs.size(); ++i) rungs[i].after = std::move(later.rungs[i].after);
    if (view) view->after = std::move(later.view->after);
    time = later.time;
    return ranges::any_of(values, moved) || ranges::any_of(rungs, moved) || (view && moved(*view));
}

void History::begin(const Scene& scene, const Controls& controls, const View& view) {
    controls_ = controls;
    names_ = control_names(scene, controls);
    rungs_ = chosen_rungs(scene, controls.rungs);
    view_ = view;
    open_ = false;
    name_objects(scene, view);
}

void History::name_objects(const Scene& scene, const View& view) {
    if (objects_.empty() && !view.objects.empty()) objects_ = object_names(scene);
}

// The text moved this value with its own: steps to or from the text's value lead to the new one.
void History::follow_text(const std::string& name, const Control& old, const Control& control) {
    for (Step& step : steps_)
        for (auto& change : step.values)
            for (State* state : {&change.before, &change.after})
                if (change.name == name && state->value == old.initial)
                    *state = {control.initial, control.initial_min, control.initial_max};
}

void History::reread(const Scene& scene, const Controls& controls, const View& view) {
    Controls now = controls;
    const std::vector<std::string> names = control_names(scene, controls);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = ranges::find(names_, names[i]);
        if (found == names_.end()) continue;
        const Control& old = controls_.items[static_cast<std::size_t>(found - names_.begin())];
        Control& control = now.items[i];
        // What the text did not list had no value of its own there.
        const bool followed = old.value != control.value || (control.listed && !old.listed);
        if (old.initial != control.initial && followed) follow_text(names[i], old, control);
        if (old.initial != control.initial || old.value == control.value) continue;
        control.value = old.value;  // a change that is not a step yet
        control.min = old.min;
        control.max = old.max;
    }
    View before = view_;
    if (!objects_.empty()) {
        std::vector<std::string> objects = object_names(scene);
        for (Step& step : steps_) {
            if (!step.view) continue;
            carry_objects(objects_, objects, step.view->before);
            carry_objects(objects_, objects, step.view->after);
        }
        carry_objects(objects_, objects, before);
        objects_ = std::move(objects);
    }
    begin(scene, now, before);
    name_objects(scene, view);
}

std::size_t History::old_index(std::size_t index, const std::vector<std::string>& names) const {
    if (names.empty()) return index;
    return static_cast<std::size_t>(ranges::find(names_, names[index]) - names_.begin());
}

void History::rest(const Scene& scene, Controls& controls, std::span<const Animated> moving) const {
    if (moving.empty()) return;
    const bool same = same_uniforms(controls_, controls);
    const std::vector<std::string> names = same ? std::vector<std::string>{} : control_names(scene, controls);
    for (const Animated& motion : moving) {
        Control* const control = controls.find(motion.program, motion.name);
        if (!control) continue;
        const std::size_t old = old_index(static_cast<std::size_t>(control - controls.items.data()), names);
        if (old == names_.size() || motion.component >= controls_.items[old].value.size()) continue;
        if (motion.component < control->value.size())
            control->value[motion.component] = controls_.items[old].value[motion.component];
    }
}

History::Step History::difference(const Scene& scene, const Controls& controls, const View& view) const {
    Step step;
    const bool same = same_uniforms(controls_, controls);
    const std::vector<std::string> names = same ? std::vector<std::string>{} : control_names(scene, controls);
    for (std::size_t i = 0; i < controls.items.size(); ++i) {
        const std::size_t old = old_index(i, names);
        if (old == names_.size() || controls.items[i].type == ValueType::sampler) continue;
        const Control &before = controls_.items[old], &after = controls.items[i];
        if (before.value != after.value || before.min != after.min || before.max != after.max)
            step.values.push_back({names_[old], state_of(before), state_of(after)});
    }
    if (controls.rungs != controls_.rungs) {
        const auto rungs = chosen_rungs(scene, controls.rungs);
        for (const auto& [ladder, rung] : rungs)
            for (const auto& [old_ladder, old_rung] : rungs_)
                if (ladder == old_ladder && rung != old_rung) step.rungs.push_back({ladder, old_rung, rung});
    }
    if (view != view_) step.view = {"view", without_mouse(view_), without_mouse(view)};
    return step;
}

bool History::follow(const Scene& scene, const Controls& controls, const View& view, const Gesture& gesture) {
    held_ |= gesture.busy;
    if (gesture.busy) return false;
    view_.mouse_x = view.mouse_x;
    view_.mouse_y = view.mouse_y;
    if (gesture.moving.empty()) return take(scene, controls, view, gesture);
    at_rest_ = controls;
    rest(scene, at_rest_, gesture.moving);
    return take(scene, at_rest_, view, gesture);
}

bool History::take(const Scene& scene, const Controls& controls, const View& view, const Gesture& gesture) {
    Step step = difference(scene, controls, view);
    const bool moved = !step.empty(), same = same_uniforms(controls_, controls);
    if (moved) {
        step.presses = gesture.presses;
        step.time = gesture.now;
        name_objects(scene, view);
        push(std::move(step));
    }
    const bool held = std::exchange(held_, false), open = open_ && !held;  // a drag ends with its button
    if (!moved && same) return false;
    begin(scene, controls, view);
    open_ = open;
    return moved;
}

void History::push(Step step) {
    forget_redo();
    if (open_ && !steps_.empty() && step.extends(steps_.back())) {
        bytes_ -= steps_.back().bytes();
        const bool moved = steps_.back().merge(std::move(step));
        if (moved)
            bytes_ += steps_.back().bytes();
        else
            steps_.pop_back();
        done_ = steps_.size();
        open_ = moved;
        return;
    }
    bytes_ += step.bytes();
    steps_.push_back(std::move(step));
    while (steps_.size() > most_steps || (bytes_ > most_bytes && steps_.size() > 1)) {
        bytes_ -= steps_.front().bytes();
        steps_.pop_front();
    }
    done_ = steps_.size();
    open_ = true;
}

void History::forget_redo() {
    for (; steps_.size() > done_; steps_.pop_back()) bytes_ -= steps_.back().bytes();
}

void History::add(int snapshot, SavedFile file) {
    Step step;
    step.snapshot = snapshot;
    step.file = std::move(file);
    push(std::move(step));
    open_ = false;
}

std::string History::go(const UserState& state, bool forward) {
    open_ = false;
    rest(state.scene, state.controls, state.moving);
    while (forward ? done_ < steps_.size() : done_ > 0) {
        const Step& step = steps_[forward ? done_++ : --done_];
        const std::string said = apply(step, state, forward);
        if (said.empty()) continue;  // the scene has nothing of it any more, or is so already
        begin(state.scene, state.controls, state.view);
        return said;
    }
    return forward ? "nothing to redo" : "nothing to undo";
}

std::string History::apply(const Step& step, const UserState& state, bool forward) {
    const char* const done = forward ? "redo: " : "undo: ";
    if (step.snapshot > 0) {
        const std::string error = exchange(step.file, forward);
        return error.empty() ? fmt::format("{}snapshot {}", done, step.snapshot)
                             : fmt::format("{}{}", forward ? "not redone: " : "not undone: ", error);
    }
    std::string said;
    std::size_t count = 0;
    for (const auto& change : step.rungs) {
        const Rungs before = state.controls.rungs;
        if (!set_rung(state.scene, state.controls.rungs, change.name, change.at(forward))) continue;
        if (state.controls.rungs == before) continue;
        ++count;
        said = fmt::format("{} {} \u2192 {}", change.name, change.at(!forward), change.at(forward));
    }
    if (count > 0) state.follow_rungs();
    if (const std::string value = apply_values(step, state, forward, count); !value.empty()) said = value;
    if (count > 1) said = ui::counted(count, "value");
    if (step.view && without_mouse(state.view) != step.view->at(forward)) {
        const View before = std::exchange(state.view, step.view->at(forward));
        state.view.mouse_x = before.mouse_x;
        state.view.mouse_y = before.mouse_y;
        said += (said.empty() ? "" : ", ") + what_differs(step.view->at(!forward), step.view->at(forward));
    }
    return said.empty() ? said : done + said;
}

std::string History::apply_values(const Step& step, const UserState& state, bool forward, std::size_t& count) {
    std::string said;
    if (step.values.empty()) return said;
    const std::vector<std::string> names = control_names(state.scene, state.controls);
    for (const auto& change : step.values) {
        const auto found = ranges::find(names, change.name);
        if (found == names.end()) continue;
        Control& control = state.controls.items[static_cast<std::size_t>(found - names.begin())];
        const State& wanted = change.at(forward);
        if (control.value.size() != wanted.value.size()) continue;
        const State before = state_of(control);
        control.value = wanted.value;
        if (control.widget == Widget::slider) {
            control.min = std::min(wanted.min, control.initial_min);
            control.max = std::max(wanted.max, control.initial_max);
        }
        const State after = state_of(control);
        if (after == before) continue;  // the text has moved it there
        said = after.value == before.value ? fmt::format("{} range {:.6g} to {:.6g} \u2192 {:.6g} to {:.6g}",
                                                         change.name, before.min, before.max, after.min, after.max)
                                           : fmt::format("{} {} \u2192 {}", change.name, numbers(control, before.value),
                                                         numbers(control, after.value));
        ++count;
    }
    return said;
}

History& Histories::use(const std::string& scene) {
    const auto found = ranges::find(used_, scene, &std::pair<std::string, History>::first);
    if (found == used_.end())
        used_.emplace_front(scene, History{});
    else
        used_.splice(used_.begin(), used_, found);
    if (used_.size() > most) used_.pop_back();
    return used_.front().second;
}

}  // namespace snell
