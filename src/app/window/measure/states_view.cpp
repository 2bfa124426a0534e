#include "src/app/window/measure/states_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"

namespace snell {

namespace {

constexpr const char *opened = "opened", *before_edit = "edit";

// The right half if none was chosen yet.
std::string usual(const Scene& scene) { return std::string(scene.ladders.empty() ? state_saved : state_reference); }

// Its texts are those of an earlier time.
bool is_earlier(const std::string& name) { return name == opened || name == before_edit; }

std::map<std::string, std::string_view> texts_of(const Sources& sources) {
    std::map<std::string, std::string_view> texts;
    for (FileId file = 0; file < sources.size(); ++file)
        texts.insert_or_assign(std::string(sources.name(file)), sources.text(file));
    return texts;
}

// The names, without their folders, of the files that only one of them has, or with another text.
std::vector<std::string> differing_files(const Sources& a, const Sources& b) {
    const auto left = texts_of(a), right = texts_of(b);
    std::set<std::string> names;
    const auto add = [&](const auto& texts, const auto& others) {
        for (const auto& [name, text] : texts)
            if (const auto other = others.find(name); other == others.end() || other->second != text)
                names.insert(utf8::printable(name.substr(name.rfind('/') + 1)));
    };
    add(left, right);
    add(right, left);
    return {names.begin(), names.end()};
}

// "paint.frag as it was".
std::string as_it_was(const std::vector<std::string>& files) {
    if (files.empty()) return {};
    return files.size() == 1 ? files[0] + " as it was" : fmt::format("{} files as they were", files.size());
}

std::string shown_name(const std::string& name) {
    if (name == state_saved) return "as saved";
    if (name == opened) return "as opened";
    if (name == before_edit) return "before the last edit";
    return name;
}

}  // namespace

void StatesView::follow(Document& scene, const Earlier& earlier, std::uint64_t revision, bool stale,
                        const ui::AccuracyMemory& memory) {
    active_ = memory.show != ui::AccuracyMemory::Show::picture;
    if (!active_) {
        for (Half& half : halves_)
            if (half.error.empty() || (!stale && half.revision != revision)) half = {};
        return;
    }
    const std::array<std::string, 2> names{memory.left.empty() ? std::string(state_now) : memory.left,
                                           memory.right.empty() ? usual(scene.scene()) : memory.right};
    // Swapped, for it might not be possible to make them again.
    if (names[0] != names[1] && halves_[0].name == names[1] && halves_[1].name == names[0]) {
        std::swap(halves_[0], halves_[1]);
        ++showings_;
    }
    for (std::size_t i = 0; i < halves_.size(); ++i) {
        Half& half = halves_[i];
        if (half.name != names[i] || half.revision != revision) {
            Half next = made(names[i], scene, earlier);
            if (next.error.empty()) next.error = set_values(next, scene);
            if (!next.error.empty()) next.document.reset();
            if (!next.shows() && half.name == next.name && half.document)
                half.error = std::move(next.error);
            else
                half = std::move(next);
            half.revision = revision;
            ++showings_;
        }
        set_values(half, scene);
    }
}

void StatesView::reread_snapshots() {
    for (Half& half : halves_)
        if (half.name.starts_with(state_snapshot)) half.revision = 0;
}

std::string StatesView::text(bool right) const { return shown_name(halves_[right ? 1 : 0].name); }

bool StatesView::with_reference() const { return halves_[0].name == state_now && halves_[1].name == state_reference; }

StatesView::Half StatesView::made(const std::string& name, Document& scene, const Earlier& earlier) const {
    Half half{.name = name};
    if (half.name == state_now) return half;
    const TextState* const texts = half.name == opened        ? &earlier.opened
                                   : half.name == before_edit ? &earlier.before_edit
                                                              : nullptr;
    if (texts && texts->texts.empty()) {
        half.error = "there is no state before an edit";
        return half;
    }
    half.fixed = half.name == opened;
    if (half.fixed) half.setup = texts->setup;
    if (!texts) half.state = named_state(half.name, scene.path, scene.scene());
    half.fixed |= half.state.written;
    half.error = half.state.error;
    if (!half.error.empty()) return half;
    const auto choose = [&](const Scene& other, Rungs& rungs) {
        if (!half.fixed) carry_over(scene.controls.rungs, scene.scene(), rungs, other);
        apply_setup(half.setup, other, rungs);
        half.error = apply_state(half.state, other, rungs);
    };
    half.document =
        open_beside(scene, caps_, choose, texts ? texts->texts : std::map<std::string, std::string>{}, half.error);
    return half;
}

// Sliders act on what follows the scene.
std::string StatesView::set_values(Half& half, Document& scene) {
    if (!half.document) return {};
    Document& document = *half.document;
    Controls wanted = document.controls;
    if (!half.fixed) {
        for (Control& control : wanted.items) reset(control);
        carry_over(scene.controls, scene.scene(), wanted, document.scene());
        carry_over(scene.controls.rungs, scene.scene(), wanted.rungs, document.scene());
    }
    apply_setup(half.setup, document.scene(), wanted.rungs);
    apply_state(half.state, document.scene(), wanted.rungs);
    if (std::exchange(document.controls.rungs, wanted.rungs) != wanted.rungs) {
        follow_rungs(document);
        wanted = document.controls;
        if (!half.fixed) carry_over(scene.controls, scene.scene(), wanted, document.scene());
    }
    apply_setup(half.setup, document.scene(), wanted);
    std::string misfit = apply_state(half.state, document.scene(), wanted);
    document.controls = std::move(wanted);
    return misfit;
}

void StatesView::compare_texts(Document& scene) {
    const std::pair now{std::max(halves_[0].revision, halves_[1].revision), showings_};
    if (std::exchange(compared_, now) == now) return;
    other_texts_.clear();
    if (ranges::none_of(halves_, [](const Half& half) { return is_earlier(half.name) && half.document; })) return;
    other_texts_ = differing_files(of(halves_[0], scene).sources, of(halves_[1], scene).sources);
}

const ui::StateFacts* StatesView::facts(Document& scene, const Earlier& earlier, const std::array<bool, 10>& snapshots,
                                        const std::string& stale, const std::string& found) {
    if (!active_) return nullptr;
    facts_ = {};
    const auto offer = [&](std::string name) {
        std::string text = shown_name(name);
        facts_.choices.push_back({std::move(name), std::move(text)});
    };
    offer(std::string(state_now));
    offer(std::string(state_saved));
    offer(opened);
    if (!earlier.before_edit.texts.empty()) offer(before_edit);
    for (std::size_t i = 1; i < snapshots.size(); ++i)
        if (snapshots[i]) offer(fmt::format("{}{}", state_snapshot, i));
    if (!scene.scene().ladders.empty()) offer(std::string(state_reference));
    for (const Ladder& ladder : scene.scene().ladders)
        for (const std::string& rung : ladder.rungs) offer(fmt::format("{}={}", ladder.name, rung));
    const auto slider = ranges::find_if(scene.controls.items, [](const Control& control) {
        return control.active && control.listed && control.widget == Widget::slider && control.value.size() == 1;
    });
    if (slider != scene.controls.items.end())
        facts_.example = fmt::format("values, such as {}={:.4g}", slider->name, slider->max);
    const auto setup = [&](Half& half) {
        const Document& document = of(half, scene);
        return setup_of(document.scene(), document.controls);
    };
    const StateDifference differ = difference(setup(halves_[0]), setup(halves_[1]));
    compare_texts(scene);
    const bool same = differ.left.empty() && other_texts_.empty() && halves_[0].name != halves_[1].name &&
                      ranges::all_of(halves_, [](const Half& half) { return half.error.empty(); });
    for (const std::size_t i : {0, 1}) {
        const Half& half = halves_[i];
        const bool settings = half.name.find('=') != std::string::npos;  // the values say it already, with their names
        std::string values = i == 0     ? differ.left
                             : settings ? difference(setup(halves_[1]), setup(halves_[0])).left
                                        : differ.right;
        if (is_earlier(half.name) && !other_texts_.empty())
            values += (values.empty() ? "" : ", ") + as_it_was(other_texts_);
        ui::StateFacts::Side& side = facts_.sides[i];
        side.name = half.name;
        side.label = !half.shows()    ? fmt::format("{}: {}", shown_name(half.name), half.error)
                     : values.empty() ? shown_name(half.name)
                     : settings       ? values
                                      : shown_name(half.name) + ": " + values;
        const std::string& error = half.document || !half.error.empty() ? half.error : stale;
        side.failed = !error.empty();
        side.blank = !half.shows();
        if (same && i == 1) side.label += ": the same";
        if (side.failed && !side.blank) side.label += fmt::format(", last good picture: {}", error);
        if (!half.error.empty() || !(half.document ? *half.document : scene).diagnostics.has_errors()) continue;
        side.failed = true;
        side.label = shown_name(half.name) + ": incomplete, for it has errors";
    }
    facts_.fixed = ranges::all_of(halves_, &Half::fixed);
    if (found.empty()) return &facts_;
    facts_.fixed = false;
    facts_.sides[0] = {facts_.sides[0].name, found};
    facts_.sides[1] = {facts_.sides[1].name, "the scene as it is"};
    return &facts_;
}

}  // namespace snell
