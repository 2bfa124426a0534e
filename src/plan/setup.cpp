#include "src/plan/setup.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "parser/text/number.h"
#include "parser/text/ranges.h"
#include "src/plan/values/declared.h"

namespace snell {

namespace {

constexpr std::size_t most_gone = 2000;  // settings of what the scene does not have

std::string key(std::string_view option, std::string_view name) { return std::string(option).append(name); }

// The name that follows the option, or nothing if it is another option.
std::optional<std::string_view> name_in(std::string_view key, std::string_view option) {
    if (!key.starts_with(option)) return std::nullopt;
    return key.substr(option.size());
}

void note(Setup& setup, const std::string& name, const Control& control) {
    setup[key(set_option, name)] = numbers_text(control.value);
    if (control.widget == Widget::slider) setup[key(range_option, name)] = numbers_text({control.min, control.max});
}

// As the scene's text says it.
Control written(Control control) {
    reset(control);
    return control;
}

void note_rungs(const Scene& scene, const Rungs& rungs, Setup& setup) {
    for (std::size_t i = 0; i < scene.ladders.size() && i < rungs.size(); ++i)
        if (rungs[i] < scene.ladders[i].rungs.size())
            setup[key(ladder_option, scene.ladders[i].name)] = scene.ladders[i].rungs[rungs[i]];
}

// A value that was set while its program was broken may have one number for all components.
bool read_value(const Setup& setup, const std::string& key, std::vector<double>& value) {
    const auto found = setup.find(key);
    std::vector<double> numbers = found == setup.end() ? std::vector<double>{} : read_numbers(found->second);
    if (numbers.size() == 1 && value.size() > 1) numbers.assign(value.size(), numbers[0]);
    if (numbers.size() != value.size()) return false;
    value = std::move(numbers);
    return true;
}

bool read_range(const Setup& setup, const std::string& key, double& min, double& max) {
    std::vector<double> range{min, max};
    if (!read_value(setup, key, range) || range[0] > range[1]) return false;
    min = range[0];
    max = range[1];
    return true;
}

bool recall_value(const Remembered& memory, const std::string& name, Control& control, Follow follow) {
    Control from = control;
    const std::string set = key(set_option, name), range = key(range_option, name);
    if (control.type == ValueType::sampler || !read_value(memory.chosen, set, from.value)) return false;
    if (!read_value(memory.written, set, from.initial)) return false;
    read_range(memory.chosen, range, from.min, from.max);
    read_range(memory.written, range, from.initial_min, from.initial_max);
    for (double& number : from.value) number = fit_to_type(number, control.type);
    if (follow == Follow::text && from.initial != control.initial) return false;
    if (from.value == control.value) return false;
    const Range fitted = limit_range({from.min, from.value[0], from.max}, control.type);
    from.min = fitted.min;
    from.max = fitted.max;
    take_value(from, control, follow);
    return true;
}

// Values are set as by `--set`, which refuses what the uniform cannot hold.
bool set_value(Control& control, const Scene& scene, const std::string& text) {
    Controls one;
    one.items.push_back(control);
    Diagnostics ignored;
    if (!set_control(one, scene, fmt::format("{}={}", control.name, text), ignored)) return false;
    control = std::move(one.items.front());
    return true;
}

// The range has room for the value and for that of the text.
void set_range(Control& control, const std::string& text) {
    const std::vector<double> numbers = read_numbers(text);
    if (control.widget != Widget::slider || numbers.size() != 2) return;
    const auto [lowest, highest] = std::minmax_element(control.value.begin(), control.value.end());
    const Range range = limit_range({std::min({numbers[0], control.initial_min, *lowest}), *lowest,
                                     std::max({numbers[1], control.initial_max, *highest})},
                                    control.type);
    control.min = range.min;
    control.max = range.max;
}

// Name, files and line, with tabs between them, which none of them has; "gone" is a fourth.
std::string text_of(const ProgramId& id) {
    return fmt::format("{}\t{}\t{}{}", id.name, id.files, id.line, id.gone ? "\tgone" : "");
}

std::optional<ProgramId> read_program(std::string_view text) {
    std::vector<std::string> parts{""};
    for (const char c : text)
        if (c == '\t')
            parts.emplace_back();
        else
            parts.back() += c;
    if (parts.size() != 3 && parts.size() != 4) return std::nullopt;
    return ProgramId{parts[0], parts[1], parts[2], parts.size() == 4};
}

void note(Setup& setup, const std::vector<ProgramId>& programs) {
    erase(setup, program_option);
    for (std::size_t i = 0; i < programs.size(); ++i)
        setup[key(program_option, fmt::format("{}", i))] = text_of(programs[i]);
}

std::vector<ProgramId> programs_in(const Setup& setup) {
    std::map<std::size_t, ProgramId> found;
    for (const auto& [key, value] : setup) {
        const auto name = name_in(key, program_option);
        const auto number = name ? read_whole<std::size_t>(*name) : std::nullopt;
        if (std::optional<ProgramId> id = number ? read_program(value) : std::nullopt) found[*number] = std::move(*id);
    }
    std::vector<ProgramId> programs;
    for (auto& [number, id] : found) programs.push_back(std::move(id));
    return programs;
}

Remembered renamed(const Remembered& memory, const Renaming& renaming) {
    return {renaming(memory.chosen), renaming(memory.written)};
}

}  // namespace

Renaming::Renaming(const Setup& programs, const Setup& used, const Scene& scene) : programs_(program_ids(scene)) {
    const std::vector<ProgramId> before = programs_in(programs);
    const std::vector<std::string> old_names = program_names(before);
    std::vector<Index> now = carried_programs(before, programs_);
    const auto is_used = [&](const std::string& name) {
        if (used.contains(snell::key(fold_option, name))) return true;
        const std::string begin = snell::key(set_option, name + ".");
        const auto first = used.lower_bound(begin);
        return first != used.end() && first->first.starts_with(begin);
    };
    const auto unknown = [&](Index i, const std::string& name) {
        return programs_[i].name == name && ranges::find(now, i) == now.end();
    };
    for (std::size_t i = 0; i < before.size(); ++i)
        for (Index other = 0; now[i] == none && !before[i].gone && other < programs_.size(); ++other)
            if (unknown(other, before[i].name)) unclear_.insert(old_names[i]);
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (now[i] != none || !is_used(old_names[i])) continue;
        now[i] = static_cast<Index>(programs_.size());
        programs_.push_back(before[i]);
        programs_.back().gone = true;
    }
    const std::vector<std::string> names = program_names(programs_);
    for (std::size_t i = 0; i < before.size(); ++i)
        if (now[i] != none) names_[old_names[i]] = names[now[i]];
}

std::string Renaming::name(std::string_view control) const {
    for (std::size_t dot = control.find('.'); dot != control.npos; dot = control.find('.', dot + 1))
        if (const auto found = names_.find(control.substr(0, dot)); found != names_.end())
            return found->second + std::string(control.substr(dot));
    return std::string(control);
}

bool Renaming::unclear(std::string_view control) const {
    for (std::size_t dot = control.find('.'); dot != control.npos; dot = control.find('.', dot + 1))
        if (unclear_.contains(control.substr(0, dot))) return true;
    return false;
}

bool Renaming::loses(std::string_view key) const {
    for (const std::string_view option : {set_option, range_option})
        if (const auto old = name_in(key, option)) return unclear(*old);
    return false;
}

std::string Renaming::key(const std::string& key) const {
    for (const std::string_view option : {set_option, range_option})
        if (const auto old = name_in(key, option)) return snell::key(option, name(*old));
    if (const auto old = name_in(key, fold_option))
        if (const auto found = names_.find(*old); found != names_.end()) return snell::key(fold_option, found->second);
    return key;
}

Setup Renaming::operator()(const Setup& setup) const {
    Setup renamed;
    for (const auto& [key, value] : setup)
        if (!loses(key)) renamed[this->key(key)] = value;
    return renamed;
}

void Renaming::note(Setup& setup) const { snell::note(setup, programs_); }

std::string numbers_text(const std::vector<double>& numbers) { return fmt::format("{}", fmt::join(numbers, ",")); }

std::vector<double> read_numbers(std::string_view text) {
    std::vector<double> numbers;
    for (const char *at = text.data(), *const end = at + text.size(); at != end; ++at) {
        const auto [stop, error] = read_real(at, end, numbers.emplace_back());
        if (error != std::errc() || !std::isfinite(numbers.back()) || (stop != end && *stop != ',')) return {};
        if ((at = stop) == end) return numbers;
    }
    return {};
}

Setup setup_of(const Scene& scene, const Controls& controls) {
    Setup setup;
    const std::vector<std::string> names = control_names(scene, controls);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (controls.items[i].type != ValueType::sampler) note(setup, names[i], controls.items[i]);
    note_rungs(scene, controls.rungs, setup);
    note(setup, program_ids(scene));
    return setup;
}

Setup written_setup(const Scene& scene, Controls controls) {
    for (Control& control : controls.items) reset(control);
    controls.rungs = marked_rungs(scene);
    return setup_of(scene, controls);
}

Setup changed_setup(const Scene& scene, const Controls& controls) {
    Setup setup = setup_of(scene, controls);
    for (const auto& [key, value] : written_setup(scene, controls))
        if (const auto found = setup.find(key); found != setup.end() && found->second == value) setup.erase(found);
    if (!setup.empty()) note(setup, program_ids(scene));
    return setup;
}

Setup setup_of(const View& view) {
    const std::string text = view_text(view);
    Setup setup;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view one = rest.substr(0, rest.find(','));
        const std::size_t equals = one.find('=');
        setup[key(view_option, one.substr(0, equals))] = one.substr(equals + 1);
        rest.remove_prefix(std::min(one.size() + 1, rest.size()));
    }
    if (view.axes) setup[std::string(axes_option)] = "on";
    return setup;
}

std::size_t apply_setup(const Setup& setup, const Scene& scene, Controls& controls) {
    std::size_t lost = apply_setup(setup, scene, controls.rungs);
    const std::vector<std::string> names = control_names(scene, controls);
    std::map<std::string_view, Control*> places;
    for (std::size_t i = 0; i < names.size(); ++i) places.emplace(names[i], &controls.items[i]);
    const Setup here = Renaming(setup, setup, scene)(setup);
    for (const auto& [key, value] : here)
        if (const auto name = name_in(key, set_option)) {
            const auto place = places.find(*name);
            if (place == places.end() || !set_value(*place->second, scene, value)) ++lost;
        }
    for (const auto& [key, value] : here)
        if (const auto name = name_in(key, range_option))
            if (const auto place = places.find(*name); place != places.end()) set_range(*place->second, value);
    return lost;
}

std::size_t apply_setup(const Setup& setup, const Scene& scene, Rungs& rungs) {
    std::size_t lost = 0;
    Diagnostics ignored;
    for (const auto& [key, value] : setup)
        if (const auto name = name_in(key, ladder_option))
            if (rungs.size() != scene.ladders.size() ||
                !choose_rung(rungs, scene, fmt::format("{}={}", *name, value), ignored))
                ++lost;
    return lost;
}

std::string setup_text(const Setup& setup) {
    std::string text;
    for (const auto& [key, value] : setup) text.append(key).append("=").append(value).append("\n");
    return text;
}

Setup read_setup(std::string_view text) {
    Setup setup;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        // Numbers and folds have no '=', but names of programs may.
        const bool numbers = name_in(line, set_option) || name_in(line, range_option) || name_in(line, fold_option);
        const std::size_t equals = numbers ? line.rfind('=') : line.find('=');
        if (line.starts_with("--") && equals != line.npos)
            setup[std::string(line.substr(0, equals))] = line.substr(equals + 1);
    }
    return setup;
}

std::vector<std::string> arguments_of(const Setup& setup, std::string_view option) {
    std::vector<std::string> arguments;
    for (const auto& [key, value] : setup)
        if (const auto name = name_in(key, option)) arguments.push_back(fmt::format("{}={}", *name, value));
    // "Glass.u" means all programs of that name, so those of "Glass#2.u" come behind it.
    std::stable_partition(arguments.begin(), arguments.end(), [](const std::string& argument) {
        return argument.substr(0, argument.find('.')).find('#') == std::string::npos;
    });
    return arguments;
}

// A name without a number means all programs of that name, so those after a changed one are named, too.
std::vector<std::string> set_arguments(const Scene& scene, const Controls& controls, bool brief) {
    const std::vector<std::string> names = control_names(scene, controls);
    std::set<std::string> changed;
    std::vector<std::string> arguments;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Control& control = controls.items[i];
        if (!control.active) continue;
        const std::string plain = scene.programs[control.program].name + "." + control.name;
        if (control.value == control.initial && !changed.contains(plain)) continue;
        changed.insert(plain);
        const bool alone = brief && ranges::count(controls.items, control.name, &Control::name) == 1;
        arguments.push_back(fmt::format("{}={}", alone ? control.name : names[i], numbers_text(control.value)));
    }
    return arguments;
}

void erase(Setup& setup, std::string_view option) {
    std::erase_if(setup, [&](const auto& setting) { return setting.first.starts_with(option); });
}

void remember(const Scene& scene, const Controls& controls, Remembered& memory, bool all) {
    const Renaming renaming(memory.written, memory.chosen, scene);
    memory = renamed(memory, renaming);
    renaming.note(memory.written);
    const std::vector<std::string> names = control_names(scene, controls);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const Control& control = controls.items[i];
        const std::string set = key(set_option, names[i]);
        const auto noted = memory.written.find(set);
        if (control.type != ValueType::sampler && (all || control.value != control.initial)) {
            note(memory.chosen, names[i], control);
            note(memory.written, names[i], written(control));
        } else if (noted != memory.written.end() &&
                   (control.listed || noted->second == numbers_text(control.initial))) {
            for (Setup* setup : {&memory.chosen, &memory.written})
                for (const std::string_view option : {set_option, range_option}) setup->erase(key(option, names[i]));
        }
    }
    Setup rungs, marked;
    note_rungs(scene, controls.rungs, rungs);
    note_rungs(scene, marked_rungs(scene), marked);
    for (const auto& [ladder, rung] : rungs) {
        if (all || rung != marked[ladder]) {
            memory.chosen[ladder] = rung;
            memory.written[ladder] = marked[ladder];
        } else {
            memory.chosen.erase(ladder);
            memory.written.erase(ladder);
        }
    }
    if (memory.chosen.size() > 2 * names.size() + rungs.size() + most_gone) {
        const Setup here = setup_of(scene, controls);
        for (Setup* setup : {&memory.chosen, &memory.written})
            std::erase_if(*setup, [&](const auto& setting) { return !here.contains(setting.first); });
    }
    const auto of_program = [](const auto& setting) { return setting.first.starts_with(set_option); };
    if (ranges::none_of(memory.chosen, of_program)) erase(memory.written, program_option);
}

bool recall(const Remembered& memory, const Scene& scene, Controls& controls, Follow follow) {
    bool changed = false;
    if (memory.chosen.empty()) return changed;
    const std::vector<std::string> names = control_names(scene, controls);
    const Remembered here = renamed(memory, Renaming(memory.written, memory.chosen, scene));
    for (std::size_t i = 0; i < names.size(); ++i) changed |= recall_value(here, names[i], controls.items[i], follow);
    return changed;
}

bool recall(const Remembered& memory, const Scene& scene, Rungs& rungs, Follow follow) {
    const Rungs before = rungs;
    Setup marked, chosen = memory.chosen;
    note_rungs(scene, marked_rungs(scene), marked);
    if (follow == Follow::text)
        std::erase_if(chosen, [&](const auto& setting) {
            const auto text = marked.find(setting.first);
            const auto written = memory.written.find(setting.first);
            return text == marked.end() || written == memory.written.end() || text->second != written->second;
        });
    apply_setup(chosen, scene, rungs);
    return rungs != before;
}

namespace {

struct ViewPart {
    std::string_view name;
    double Transformation::*value;
};
constexpr std::array<ViewPart, 7> parts{{{"rotate_x", &Transformation::rotate_x},
                                         {"rotate_y", &Transformation::rotate_y},
                                         {"rotate_z", &Transformation::rotate_z},
                                         {"scale", &Transformation::scale},
                                         {"x", &Transformation::x},
                                         {"y", &Transformation::y},
                                         {"z", &Transformation::z}}};

void add(std::string& text, std::string_view prefix, const Transformation& t) {
    const Transformation none;
    for (const ViewPart& part : parts)
        if (t.*part.value != none.*part.value)
            text += fmt::format("{}{}{}={}", text.empty() ? "" : ",", prefix, part.name, t.*part.value);
}

// Returns the transformation that a prefix such as "eye." means, or null.
Transformation* named(std::string_view prefix, View& view) {
    if (prefix.empty()) return &view.scene;
    if (prefix == "eye.") return &view.eye;
    if (prefix == "texture.") return &view.texture;
    constexpr std::string_view object = "object";
    if (!prefix.starts_with(object)) return nullptr;
    const auto draw = read_whole<unsigned>(prefix.substr(object.size(), prefix.size() - object.size() - 1));
    return draw ? &view.objects[*draw] : nullptr;
}

std::string parse_one(std::string_view text, View& view) {
    const std::size_t equals = text.find('='), dot = text.substr(0, equals).find('.');
    if (equals == text.npos) return fmt::format("'{}' sets nothing: write rotate_x=30", text);
    if (text.substr(0, equals) == "projection") {
        const std::string_view which = text.substr(equals + 1);
        view.projection = which == "ortho" ? Projection::ortho : Projection::perspective;
        if (which == "ortho" || which == "perspective") return {};
        return fmt::format("'{}' is not a projection; use perspective or ortho", which);
    }
    const std::size_t begin = dot == text.npos ? 0 : dot + 1;
    const std::string_view name = text.substr(begin, equals - begin), number = text.substr(equals + 1);
    const auto value = read_whole<double>(number);
    if (!value || !std::isfinite(*value)) return fmt::format("'{}' is no number", number);
    if (text.substr(0, equals) == "background") {
        if (!(*value >= 0 && *value <= 1)) return fmt::format("'{}' is not a brightness from 0 to 1", number);
        view.background = value;
        return {};
    }
    Transformation* transformation = named(text.substr(0, begin), view);
    for (const ViewPart& part : parts)
        if (transformation && part.name == name) {
            if (name == "scale" && *value == 0) return fmt::format("'{}' is not a scale: nothing would be seen", text);
            transformation->*part.value = *value;
            return {};
        }
    return fmt::format(
        "there is no '{}': rotate_x, rotate_y, rotate_z, scale, x, y, z, also after 'eye.', 'texture.' and 'object0.'; "
        "projection, background",
        text.substr(0, equals));
}

}  // namespace

std::string view_text(const View& view) {
    std::string text;
    add(text, "", view.scene);
    add(text, "eye.", view.eye);
    add(text, "texture.", view.texture);
    for (const auto& [draw, transformation] : view.objects) add(text, fmt::format("object{}.", draw), transformation);
    const auto say = [&text](const std::string& what) { text += (text.empty() ? "" : ",") + what; };
    if (view.projection != Projection::scene)
        say(view.projection == Projection::ortho ? "projection=ortho" : "projection=perspective");
    if (view.background) say(fmt::format("background={}", *view.background));
    return text;
}

std::string parse_view(std::string_view text, View& view) {
    while (!text.empty()) {
        const std::string_view one = text.substr(0, text.find(','));
        if (std::string wrong = parse_one(one, view); !wrong.empty()) return wrong;
        text.remove_prefix(std::min(one.size() + 1, text.size()));
    }
    return {};
}

void apply_setup(const Setup& setup, View& view) {
    for (const auto& [key, value] : setup) {
        if (key == axes_option) view.axes = value == "on";
        const auto name = name_in(key, view_option);
        if (!name) continue;
        if (value.empty() && *name == "projection")
            view.projection = Projection::scene;
        else if (value.empty() && *name == "background")
            view.background.reset();
        else
            parse_one(fmt::format("{}={}", *name, !value.empty() ? value : name->ends_with("scale") ? "1" : "0"), view);
    }
    std::erase_if(view.objects, [](const auto& object) { return object.second == Transformation{}; });
}

}  // namespace snell
