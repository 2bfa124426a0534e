#include "src/document/history.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <set>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "src/plan/values/numbers.h"

namespace snell {

namespace {

constexpr double one_gesture = .5;  // seconds between changes of one gesture

std::string numbers(const Control& control, const std::string& text) {
    const std::vector<double> value = read_numbers(text);
    if (control.widget == Widget::check_box) return text == "0" ? "off" : "on";
    if (value.size() > 4) return fmt::format("{} numbers", value.size());
    std::string words;
    for (const double number : value) words += fmt::format("{}{:.6g}", words.empty() ? "" : " ", number);
    return value.size() > 1 ? "(" + words + ")" : words;
}

std::string range_words(const std::string& text) {
    const std::vector<double> range = read_numbers(text);
    return range.size() == 2 ? fmt::format("{:.6g} to {:.6g}", range[0], range[1]) : text;
}

bool of_view(std::string_view key) { return key.starts_with(view_option) || key == axes_option; }

// What was changed of the view.
std::string view_words(const std::set<std::string_view>& changed, const View& now) {
    if (changed.size() == 1 && *changed.begin() == axes_option)
        return now.axes ? "axes hidden \u2192 shown" : "axes shown \u2192 hidden";
    for (const char* part : {"background", "projection"})
        if (changed.contains(std::string(view_option) + part)) return part;
    return "view";
}

Setup all_of(const Scene& scene, const Controls& controls, const View& view) {
    Setup setup = setup_of(scene, controls);
    setup.merge(setup_of(view));
    return setup;
}

// Whether the text has put its own number in the place of the user's.
bool replaces(const Control& old, const Control& now) {
    return old.value != old.initial && now.value == now.initial && old.value != now.value &&
           old.value.size() == now.value.size();
}

// The user's values that a text does not have any more.
struct Lost {
    std::size_t replaced = 0, dropped = 0;
    std::string last_replaced, last_dropped;

    // Texts of the numbers.
    void replace(const std::string& name, const Control& control, const std::string& before, const std::string& now) {
        ++replaced;
        last_replaced =
            fmt::format("{} {} was replaced by the file's {}", name, numbers(control, before), numbers(control, now));
    }
    void drop(const std::string& name, const Control& control, const std::string& value) {
        ++dropped;
        last_dropped = fmt::format("{} {} was dropped", name, numbers(control, value));
    }

    std::string words() const {
        std::string said = last_replaced;
        if (replaced > 1) said = fmt::format("{} were replaced by the file's", counted(replaced, "value"));
        if (dropped == 0) return said;
        if (replaced > 0) said += "; ";
        said += dropped == 1 ? last_dropped : fmt::format("{} were dropped", counted(dropped, "value"));
        return said + ": which program of the name is which is not known";
    }
};

const std::string& at(const Setup& setup, const std::string& key) {
    static const std::string initial;
    const auto found = setup.find(key);
    return found == setup.end() ? initial : found->second;
}

}  // namespace

std::string lost_values(const Remembered& memory, const Scene& scene, const Controls& controls) {
    const Renaming renaming(memory.written, memory.chosen, scene);
    const std::vector<std::string> names = control_names(scene, controls);
    Lost lost;
    for (const auto& [key, value] : memory.chosen) {
        if (!key.starts_with(set_option)) continue;
        const std::string old = key.substr(set_option.size()), name = renaming.name(old);
        const auto found = ranges::find(names, name);
        const bool unclear = renaming.unclear(old);
        if (!unclear && found == names.end()) continue;  // it may come back
        const Control& control =
            found == names.end() ? Control{} : controls.items[static_cast<std::size_t>(found - names.begin())];
        if (unclear)
            lost.drop(old, control, value);
        else if (at(memory.written, key) != numbers_text(control.initial) && value != numbers_text(control.value))
            lost.replace(name, control, value, numbers_text(control.value));
    }
    return lost.words();
}

std::size_t History::Step::bytes() const {
    std::size_t sum = sizeof(Step);
    for (const auto& [key, change] : changes)
        sum += sizeof(change) + 2 * key.size() + change.before.size() + change.after.size();
    for (const SavedFile& file : files) sum += file.before.size() + file.after.size();
    return sum;
}

// All of the view counts as one.
bool History::Step::extends(const Step& last) const {
    const auto same = [](const Step& a, const Step& b) {
        return ranges::all_of(a.changes, [&](const auto& change) {
            return b.changes.contains(change.first) ||
                   (of_view(change.first) &&
                    ranges::any_of(b.changes, [](const auto& other) { return of_view(other.first); }));
        });
    };
    return presses == last.presses && time < last.time + one_gesture && last.files.empty() && same(*this, last) &&
           same(last, *this);
}

void History::carry_changes(const std::vector<std::string>& from, const std::vector<std::string>& to, Step& step) {
    const std::string object = std::string(view_option) + "object";
    for (auto& [key, change] : std::exchange(step.changes, {})) {
        unsigned index = 0;
        const char* const end = key.data() + key.size();
        const bool moved = key.starts_with(object);
        const char* const rest = moved ? std::from_chars(key.data() + object.size(), end, index).ptr : end;
        const Index found = moved ? carried(from, to, index) : 0;
        if (found != none)
            step.changes[moved ? fmt::format("{}{}{}", object, found, std::string(rest, end)) : key] = change;
    }
}

bool History::Step::merge(Step&& later) {
    for (auto& [key, change] : later.changes) {
        const auto [place, fresh] = changes.try_emplace(key, change);
        if (!fresh) place->second.after = std::move(change.after);
    }
    time = later.time;
    return ranges::any_of(changes, [](const auto& change) { return change.second.before != change.second.after; });
}

void History::begin(const Scene& scene, const Controls& controls, const View& view) {
    controls_ = controls;
    names_ = control_names(scene, controls);
    setup_ = all_of(scene, controls, view);
    view_ = view;
    open_ = false;
    name_objects(scene, view);
}

void History::name_objects(const Scene& scene, const View& view) {
    if (objects_.empty() && !view.objects.empty()) objects_ = object_names(scene);
}

// The text moved this value with its own: steps to or from the text's value lead to the new one.
void History::follow_text(const std::string& name, const Control& old, const Control& control) {
    const auto follow = [this](const std::string& key, const std::string& before, const std::string& now) {
        for (Step& step : steps_)
            if (const auto change = step.changes.find(key); change != step.changes.end())
                for (std::string* value : {&change->second.before, &change->second.after})
                    if (*value == before) *value = now;
    };
    follow(std::string(set_option) + name, numbers_text(old.initial), numbers_text(control.initial));
    follow(std::string(range_option) + name, numbers_text({old.initial_min, old.initial_max}),
           numbers_text({control.initial_min, control.initial_max}));
}

std::map<std::string, const Control*> History::carry_programs(const Scene& scene) {
    for (const auto& setting : setup_)
        if (setting.first.starts_with(program_option)) programs_.insert(setting);
    Setup used;
    for (const Step& step : steps_)
        for (const auto& [key, change] : step.changes) used[key];
    for (const std::string& name : names_) used[std::string(set_option) + name];  // another may have its name now
    const Renaming renaming(programs_, used, scene);
    const Setup before = programs_;
    renaming.note(programs_);
    std::map<std::string, const Control*> unclear;
    for (std::size_t i = 0; i < names_.size(); ++i) {
        const Control& control = controls_.items[i];
        if (control.value != control.initial && renaming.unclear(names_[i])) unclear[names_[i]] = &control;
        names_[i] = renaming.name(names_[i]);
    }
    for (Step& step : steps_) {
        std::map<std::string, Change> changes;
        if (step.by_number && programs_ != before) step.changes.clear();
        for (auto& [key, change] : step.changes)
            if (!renaming.loses(key)) changes[renaming.key(key)] = std::move(change);
        step.changes = std::move(changes);
    }
    return unclear;
}

std::string History::reread(const Scene& scene, const Controls& controls, const View& view,
                            std::span<const Animated> moving, Follow follow) {
    before_ = {};
    const std::map<std::string, const Control*> unclear = carry_programs(scene);
    Controls now = controls;
    rest(scene, now, moving);
    const std::vector<std::string> names = control_names(scene, controls);
    Step step;
    Lost lost;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto found = ranges::find(names_, names[i]);
        if (found == names_.end()) continue;
        const Control& old = controls_.items[static_cast<std::size_t>(found - names_.begin())];
        Control& control = now.items[i];
        if (follow == Follow::memory) {
            if (old.value != control.value && old.value.size() == control.value.size())
                take_value(old, control, follow);  // a change that is not a step yet
            continue;
        }
        // What the text did not list had no value of its own there.
        const bool followed = old.value != control.value || (control.listed && !old.listed);
        if (old.initial != control.initial && followed) {
            follow_text(names[i], old, control);
            if (replaces(old, control) && ranges::none_of(moving, [&](const Animated& motion) {
                    return motion.program == control.program && motion.name == control.name;
                })) {
                const Change change{numbers_text(old.value), numbers_text(control.value)};
                lost.replace(names[i], control, change.before, change.after);
                step.changes[std::string(set_option) + names[i]] = change;
            }
        }
        if (old.initial != control.initial || old.value == control.value) continue;
        control.value = old.value;  // a change that is not a step yet
        control.min = old.min;
        control.max = old.max;
    }
    for (const auto& [name, old] : unclear) {
        const std::string value = numbers_text(old->value);
        lost.drop(name, *old, value);
        const auto found = ranges::find(names, name);
        if (found == names.end()) continue;
        const Control& control = now.items[static_cast<std::size_t>(found - names.begin())];
        if (control.value.size() == old->value.size())
            step.changes[std::string(set_option) + name] = {value, numbers_text(control.value)};
    }
    begin(scene, now, carried_view(scene));
    name_objects(scene, view);
    const std::string said = lost.words();
    const std::size_t count = step.changes.size();
    step.by_number = lost.dropped > 0;
    if (count == 0) return said;
    push(std::move(step));
    open_ = false;
    if (lost.dropped > 0) return said + "; Ctrl+Z sets them by their numbers";
    return said + (count > 1 ? "; Ctrl+Z brings them back" : "; Ctrl+Z brings it back");
}

View History::carried_view(const Scene& scene) {
    View view = view_;
    if (objects_.empty()) return view;
    std::vector<std::string> objects = object_names(scene);
    for (Step& step : steps_) carry_changes(objects_, objects, step);
    carry_objects(objects_, objects, view);
    objects_ = std::move(objects);
    return view;
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
    const auto same = [](const Control& a, const Control& b) {
        return a.value == b.value && a.min == b.min && a.max == b.max;
    };
    if (view == view_ && controls.rungs == controls_.rungs && same_uniforms(controls, controls_) &&
        ranges::equal(controls.items, controls_.items, same))
        return step;
    const Setup now = all_of(scene, controls, view);
    const auto compare = [&](const std::string& key) {
        const std::string &before = at(setup_, key), &after = at(now, key);
        if (key.starts_with(program_option)) return;
        const bool both = setup_.contains(key) && now.contains(key);  // what the scene lacks is no change
        if (before != after && (both || of_view(key))) step.changes[key] = {before, after};
    };
    for (const Setup* setup : {&setup_, &now})
        for (const auto& [key, value] : *setup) compare(key);
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
        if (before_.presses != gesture.presses) note_before(gesture.presses);
        push(std::move(step), gesture.undone);
    }
    const bool held = std::exchange(held_, false), open = open_ && !held;  // a drag ends with its button
    if (!moved && same) return false;
    begin(scene, controls, view);
    open_ = open;
    return moved;
}

void History::note_before(std::uint64_t presses) {
    const auto undone = steps_.begin() + static_cast<std::ptrdiff_t>(done_);
    before_ = {presses, {undone, steps_.end()}, setup_, controls_, names_, view_};
}

void History::take_back(std::uint64_t presses) {
    Before before = std::exchange(before_, {});
    if (before.presses == 0 || before.presses + 1 != presses) return;
    forget_redo();
    for (; !steps_.empty() && steps_.back().presses == before.presses; steps_.pop_back())
        bytes_ -= steps_.back().bytes();
    done_ = steps_.size();
    for (Step& step : before.undone) {
        bytes_ += step.bytes();
        steps_.push_back(std::move(step));
    }
    setup_ = std::move(before.setup);
    controls_ = std::move(before.controls);
    names_ = std::move(before.names);
    view_ = std::move(before.view);
    open_ = false;
}

void History::push(Step step, bool undone) {
    refused_.clear();
    if (undone) {
        bytes_ += step.bytes();
        steps_.insert(steps_.begin() + static_cast<std::ptrdiff_t>(done_++), std::move(step));
        for (; too_many() && steps_.size() > done_; steps_.pop_back()) bytes_ -= steps_.back().bytes();
        return;
    }
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
    for (; too_many(); steps_.pop_front()) bytes_ -= steps_.front().bytes();
    done_ = steps_.size();
    open_ = true;
}

void History::forget_redo() {
    for (; steps_.size() > done_; steps_.pop_back()) bytes_ -= steps_.back().bytes();
}

void History::add(std::string what, std::vector<SavedFile> files) {
    Step step;
    step.what = std::move(what);
    step.files = std::move(files);
    before_ = {};
    push(std::move(step));
    open_ = false;
}

std::string History::go(const UserState& state, bool forward) {
    open_ = false;
    before_ = {};
    rest(state.scene, state.controls, state.moving);
    const std::string refused = std::exchange(refused_, {});
    std::string again, without;
    std::vector<Step*> left;
    std::size_t at = done_;
    while (forward ? at < steps_.size() : at > 0) {
        Step& step = steps_[forward ? at++ : --at];
        if (step.left) {
            left.push_back(&step);
            continue;
        }
        const std::string error = step.files.empty() ? "" : state.exchange(step.files, forward);
        if (!error.empty()) {
            refused_ = (forward ? "not redone: " : "not undone: ") + error;
            if (again.empty() && refused_ == refused) {
                again = refused_;
                without = fmt::format("; {} is not {}", step.what, forward ? "redone" : "undone");
                left.push_back(&step);
                continue;
            }
            pass(forward ? at - 1 : at + 1, left);
            return refused_ + without;
        }
        const std::string said = apply(step, state, forward);
        if (said.empty()) continue;  // the scene has nothing of it any more, or is so already
        refused_.clear();
        pass(at, left);
        begin(state.scene, state.controls, state.view);
        return said + without;
    }
    if (!again.empty()) return again;  // there is nothing behind it
    pass(at, left);
    return forward ? "nothing to redo" : "nothing to undo";
}

void History::pass(std::size_t to, const std::vector<Step*>& left) {
    for (Step* step : left) step->left = !step->left;
    done_ = to;
}

std::string History::apply(const Step& step, const UserState& state, bool forward) {
    const char* const done = forward ? "redo: " : "undo: ";
    if (!step.files.empty()) return done + step.what;
    Setup wanted;
    for (const auto& [key, change] : step.changes) wanted[key] = change.at(forward);
    const Setup before = all_of(state.scene, state.controls, state.view);
    const Rungs rungs = state.controls.rungs;
    apply_setup(wanted, state.scene, state.controls.rungs);
    if (state.controls.rungs != rungs) state.follow_rungs();
    apply_setup(wanted, state.scene, state.controls);
    apply_setup(wanted, state.view);
    const std::string said = words_of(step, before, state);
    return said.empty() ? said : done + said;
}

std::string History::words_of(const Step& step, const Setup& before, const UserState& state) {
    const Setup now = all_of(state.scene, state.controls, state.view);
    const std::vector<std::string> names = control_names(state.scene, state.controls);
    std::string said;
    std::set<std::string_view> view, values;
    for (const auto& [key, change] : step.changes) {
        const std::string &from = at(before, key), &to = at(now, key);
        if (from == to) continue;  // the text has moved it there, or the scene does not have it any more
        if (of_view(key)) {
            view.insert(key);
            continue;
        }
        const std::string_view name = std::string_view(key).substr(key.find(' ') + 1);
        const bool range = key.starts_with(range_option);
        const auto control = ranges::find(names, name);
        values.insert(name);
        if (range)
            said = fmt::format("{} range {} \u2192 {}", name, range_words(from), range_words(to));
        else if (control == names.end())
            said = fmt::format("{} {} \u2192 {}", name, from, to);
        else {
            const Control& item = state.controls.items[static_cast<std::size_t>(control - names.begin())];
            said = fmt::format("{} {} \u2192 {}", name, numbers(item, from), numbers(item, to));
        }
    }
    if (values.size() > 1) said = counted(values.size(), "value");
    if (view.empty()) return said;
    return said + (said.empty() ? "" : ", ") + view_words(view, state.view);
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
