#include "src/app/window/past.h"

#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/write_copy.h"
#include "src/plan/setup.h"
#include "src/plan/view.h"

namespace snell {

namespace {

// The scene's controls as its text says.
Controls as_written(const Controls& controls, const Rungs& rungs) {
    Controls plain = controls;
    for (Control& control : plain.items) {
        control.value = control.initial;
        control.min = control.initial_min;
        control.max = control.initial_max;
    }
    if (rungs.size() == plain.rungs.size()) plain.rungs = rungs;
    return plain;
}

bool same_values(const Controls& a, const Controls& b) {
    return a.rungs == b.rungs && ranges::equal(a.items, b.items, {}, &Control::value, &Control::value);
}

ui::Folds folds_in(const Setup& setup) {
    ui::Folds folds;
    for (const auto& [key, value] : setup)
        if (key.starts_with(fold_option)) folds[key.substr(fold_option.size())] = value == "open";
    return folds;
}

Setup setup_of(const ui::Folds& folds) {
    Setup setup;
    for (const auto& [program, open] : folds) setup[std::string(fold_option) + program] = open ? "open" : "folded";
    return setup;
}

Setup programs_in(Setup setup) {
    std::erase_if(setup, [](const auto& setting) { return !setting.first.starts_with(program_option); });
    return setup;
}

std::string object_key(unsigned index) { return fmt::format("{}object{}", view_option, index); }

// Sets the view that was kept. Objects are found again by their names.
void set_view(const Remembered& kept, const Scene& scene, View& view) {
    View found;
    found.axes = view.axes;
    apply_setup(kept.chosen, found);
    const std::map<unsigned, Transformation> objects = std::exchange(found.objects, {});
    const std::vector<std::string> names = objects.empty() ? std::vector<std::string>{} : object_names(scene);
    for (const auto& [index, transformation] : objects) {
        const auto name = kept.written.find(object_key(index));
        if (name == kept.written.end()) continue;
        const auto there = ranges::find(names, name->second, utf8::printable);
        if (there != names.end()) found.objects[static_cast<unsigned>(there - names.begin())] = transformation;
    }
    view = std::move(found);
}

}  // namespace

Remembered Past::read(const std::string& scene) {
    kept_ = read_kept(folder_, scene);
    Remembered values = kept_;
    for (Setup* setup : {&values.chosen, &values.written})
        for (const std::string_view option : {view_option, axes_option, fold_option}) erase(*setup, option);
    erase(values.chosen, program_option);  // those of folds
    return values;
}

std::string Past::begin(Session& session, View& view) {
    name_.clear();
    continued_ = false;
    moving_ = 0;
    folds_ = folds_in(kept_.chosen);
    fold_programs_ = programs_in(kept_.chosen);
    if (!session.document()) return {};
    const Document& document = *session.document();
    carry_folds(document.scene());
    name_ = kept_name(session.path());
    flat_ = flat_picture(document.scene());
    first_axes_ = !flat_ && axes_;
    view.axes = first_axes_;
    if (const auto axes = kept_.chosen.find(std::string(axes_option)); axes != kept_.chosen.end())
        view.axes = axes->second == "on";
    const View plain = view;
    set_view(kept_, document.scene(), view);
    const Controls written = as_written(document.controls, session.first_rungs());
    const bool values = !same_values(written, document.controls), looks = view != plain, first = history().empty();
    if (first)
        history().begin(document.scene(), written, plain);
    else
        history().reread(document.scene(), document.controls, view);
    const std::string lost = lost_values(kept_, document.scene(), document.controls);
    changed_ |= !lost.empty();  // it is said once
    if (!values && !looks) return lost;
    const std::string what = !values ? "view" : looks ? "values and view" : "values";
    return what + " of last time" + (first ? "; Ctrl+Z goes back to the scene as written" : "") +
           (lost.empty() ? "" : "; " + lost);
}

void Past::continue_with(Session& session, const View& view) {
    name_.clear();
    folds_ = folds_in(kept_.chosen);
    fold_programs_ = programs_in(kept_.chosen);
    continued_ = !session.document();
    if (continued_) return;
    carry_folds(session.document()->scene());
    name_ = kept_name(session.path());
    first_axes_ = view.axes;
    history().begin(session.document()->scene(), session.document()->controls, view);
    changed_ = true;
}

void Past::hear(std::span<const Event> events) {
    for (const Event& event : events) {
        if (event.kind == Event::Kind::button && event.down) ++presses_;
        if (event.kind != Event::Kind::key || event.key == Key::other) continue;
        const auto key = static_cast<std::size_t>(event.key);
        if (event.down && !down_[key]) ++presses_;  // otherwise it repeats
        down_[key] = event.down;
    }
}

void Past::follow(Session& session, const View& view, bool busy, std::span<const Animated> moving, double now,
                  bool undone) {
    const Document* document = session.document();
    if (name_.empty() || !document) return;
    if (moving.size() > moving_) before_motion_ = steps();
    moving_ = moving.size();
    changed_ |= history().follow(document->scene(), document->controls, view, {busy, presses_, now, moving, undone});
}

void Past::take_back(std::size_t moving) {
    if (name_.empty()) return;
    history().take_back(presses_);
    moving_ = moving;
}

void Past::finish(Session& session, const View& view) {
    ++presses_;
    follow(session, view, false, {}, 0);
}

std::string Past::reread(Session& session, View& view, std::span<const Animated> moving) {
    if (name_.empty() && !continued_) return begin(session, view);
    if (name_.empty()) {
        continue_with(session, view);
        return {};
    }
    changed_ = true;
    const Document* const document = session.document();
    if (!document) return {};
    carry_folds(document->scene());
    return history().reread(document->scene(), document->controls, view, moving, session.followed());
}

void Past::add(std::string what, std::vector<SavedFile> files, Session& session) {
    session.hold_values(files);
    history().add(std::move(what), std::move(files));
}

std::string Past::serve(const ui::Requests& requests, Session& session, View& view, std::span<const Animated> moving,
                        const std::function<void()>& follow_rungs) {
    Document* document = session.document();
    if (name_.empty() || !document || requests.undo == requests.redo) return {};
    const UserState state{document->scene(),
                          document->controls,
                          view,
                          follow_rungs,
                          moving,
                          [&](const std::vector<SavedFile>& files, bool forward) {
                              const std::string error = exchange_saved(files, forward);
                              if (error.empty()) session.hold_values(files);
                              return error;
                          }};
    changed_ = true;
    return requests.undo ? history().undo(state) : history().redo(state);
}

Remembered Past::state(Session& session, const View& view, bool axes) const {
    Remembered kept = session.remembered();
    for (auto& [key, value] : setup_of(view)) kept.chosen[key] = value;
    kept.chosen.merge(setup_of(folds_));
    if (!folds_.empty()) kept.chosen.insert(fold_programs_.begin(), fold_programs_.end());
    kept.chosen.erase(std::string(axes_option));
    if (axes) kept.chosen[std::string(axes_option)] = view.axes ? "on" : "off";
    const std::vector<std::string> names =
        view.objects.empty() ? std::vector<std::string>{} : object_names(session.document()->scene());
    for (const auto& [index, transformation] : view.objects)
        if (index < names.size()) kept.written[object_key(index)] = utf8::printable(names[index]);
    return kept;
}

void Past::fold(const ui::Folds& folds, Session& session) {
    if (folds == folds_) return;
    changed_ = true;
    folds_ = folds;
    if (session.document()) carry_folds(session.document()->scene());
}

// To the programs of this text.
void Past::carry_folds(const Scene& scene) {
    const Setup folds = setup_of(folds_);
    const Renaming renaming(fold_programs_, folds, scene);
    folds_ = folds_in(renaming(folds));
    renaming.note(fold_programs_);
}

void Past::write(Session& session, const View& view) {
    if (name_.empty() || !session.document()) return;
    if (!flat_) axes_ = view.axes;
    if (!std::exchange(changed_, false)) return;
    Remembered kept = state(session, view, kept_.chosen.contains(std::string(axes_option)) || view.axes != first_axes_);
    if (kept == kept_) return;
    // An error is ignored, because only comfort is lost.
    write_kept(folder_, name_, kept);
    kept_ = std::move(kept);
}

void Past::hand_on(Session& session, const std::string& scene, const View& view) {
    write_kept(folder_, scene, state(session, view, true));
}

}  // namespace snell
