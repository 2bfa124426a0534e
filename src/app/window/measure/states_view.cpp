#include "src/app/window/measure/states_view.h"

#include <fmt/format.h>

#include <utility>

#include "parser/text/ranges.h"

namespace snell {

namespace {

constexpr const char *opened = "opened", *before_edit = "edit";

// The right half if none was chosen yet.
std::string usual(const Scene& scene) { return std::string(scene.ladders.empty() ? state_saved : state_reference); }

std::string shown_name(const std::string& name) {
    if (name == state_saved) return "as saved";
    if (name == opened) return "as opened";
    if (name == before_edit) return "before the last edit";
    return name;
}

}  // namespace

void StatesView::follow(Document& scene, const Earlier& earlier, std::uint64_t revision,
                        const ui::AccuracyMemory& memory) {
    active_ = memory.show != ui::AccuracyMemory::Show::picture;
    if (!active_) return leave();
    const std::array<std::string, 2> names{memory.left.empty() ? std::string(state_now) : memory.left,
                                           memory.right.empty() ? usual(scene.scene()) : memory.right};
    for (std::size_t i = 0; i < halves_.size(); ++i) {
        Half& half = halves_[i];
        if (half.name != names[i] || half.revision != revision) {
            half = {.name = names[i], .revision = revision};
            make(half, scene, earlier);
            ++showings_;
        }
        set_values(half, scene);
    }
}

bool StatesView::with_reference() const { return halves_[0].name == state_now && halves_[1].name == state_reference; }

void StatesView::make(Half& half, Document& scene, const Earlier& earlier) {
    if (half.name == state_now) return;
    const TextState* const texts = half.name == opened        ? &earlier.opened
                                   : half.name == before_edit ? &earlier.before_edit
                                                              : nullptr;
    if (texts && texts->texts.empty()) {
        half.error = "there is no state before an edit";
        return;
    }
    half.fixed = half.name == opened;
    if (half.fixed) half.setup = texts->setup;
    if (!texts) half.state = named_state(half.name, scene.path, scene.scene());
    half.fixed |= half.state.written;
    half.error = half.state.error;
    if (!half.error.empty()) return;
    const auto choose = [&](const Scene& other, Rungs& rungs) {
        if (!half.fixed) carry_over(scene.controls.rungs, scene.scene(), rungs, other);
        apply_setup(half.setup, other, rungs);
        half.error = apply_state(half.state, other, rungs);
    };
    half.document =
        open_beside(scene, caps_, choose, texts ? texts->texts : std::map<std::string, std::string>{}, half.error);
}

// Sliders act on what follows the scene.
void StatesView::set_values(Half& half, Document& scene) {
    if (!half.document) return;
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
    if (std::string error = apply_state(half.state, document.scene(), wanted); !error.empty())
        half.error = std::move(error);
    document.controls = std::move(wanted);
}

const ui::StateFacts* StatesView::facts(Document& scene, const Earlier& earlier, const std::array<bool, 10>& snapshots,
                                        const std::string& found) {
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
    const auto setup = [&](Half& half) {
        const Document& document = of(half, scene);
        return setup_of(document.scene(), document.controls);
    };
    const StateDifference differ = difference(setup(halves_[0]), setup(halves_[1]));
    for (const std::size_t i : {0, 1}) {
        const Half& half = halves_[i];
        const std::string& values = i == 0 ? differ.left : differ.right;
        ui::StateFacts::Side& side = facts_.sides[i];
        side.name = half.name;
        const bool settings = half.name.find('=') != std::string::npos;  // the values say it already
        side.label = !half.error.empty() ? half.error
                     : values.empty()    ? shown_name(half.name)
                     : settings          ? values
                                         : shown_name(half.name) + ": " + values;
        side.failed = !half.error.empty();
    }
    if (found.empty()) return &facts_;
    facts_.sides[0].label = found;
    facts_.sides[1].label = "the scene as it is";
    return &facts_;
}

}  // namespace snell
