#include "web/interface/open_scene.h"

#include <algorithm>
#include <utility>

#include "parser/text/ranges.h"
#include "src/lint/lint.h"
#include "src/plan/setup.h"
#include "src/plan/texts.h"
#include "src/plan/values/numbers.h"
#include "src/plan/view.h"

namespace snell::web {

namespace {

Rungs reference_rungs(const Scene& scene) {
    Rungs rungs;
    for (const Ladder& ladder : scene.ladders) rungs.push_back(ladder.rungs.size() - 1);
    return rungs;
}

// Where two numbers do not fit but one does, the comma of "Glass.uEta=1,3" is a decimal one.
void set_value_with_comma(const std::string& assignment, Controls& controls, const Scene& scene,
                          Diagnostics& problems) {
    Diagnostics wrong, still_wrong;
    bool taken = set_control(controls, scene, assignment, wrong);
    const std::size_t comma = assignment.find(',', assignment.find('='));
    if (!taken && comma != std::string::npos) {
        std::string decimal = assignment;
        decimal[comma] = '.';
        taken = set_control(controls, scene, decimal, still_wrong);
        if (taken) wrong = std::move(still_wrong);
    }
    problems.append(wrong);
}

// Takes a range that has room for the value. What does not fit is named as an address has it.
void set_range(const std::string& assignment, const Scene& scene, Controls& controls, Diagnostics& problems) {
    const std::size_t equals = assignment.rfind('=');
    const std::vector<std::string> names = control_names(scene, controls);
    const auto found = ranges::find(names, assignment.substr(0, equals));
    const std::vector<double> range = read_numbers(std::string_view(assignment).substr(equals + 1));
    Control* const control =
        found == names.end() ? nullptr : &controls.items[static_cast<std::size_t>(found - names.begin())];
    const auto fits = [&](double value) { return value >= range[0] && value <= range[1]; };
    if (control && control->widget == Widget::slider && range.size() == 2 && range[0] < range[1] &&
        ranges::all_of(range, [&](double end) { return fitting(end, control->type) == end; }) &&
        ranges::all_of(control->value, fits)) {
        control->min = range[0];
        control->max = range[1];
        return;
    }
    problems.error("range-not-taken", assignment.substr(0, equals) + ":range=" + assignment.substr(equals + 1));
}

constexpr std::uint64_t most_image_bytes = std::uint64_t{512} << 20;  // decoding takes three times as much

bool names_ladder(const Scene& scene, const std::string& assignment) {
    return ranges::find(scene.ladders, assignment.substr(0, assignment.find('=')), &Ladder::name) !=
           scene.ladders.end();
}

}  // namespace

Access page_access(const gl::Caps& caps) {
    Access access;
    access.limits.texture_bytes = most_image_bytes;
    if (caps.max_texture > 0)
        access.limits.texture_side = std::min(access.limits.texture_side, static_cast<std::uint64_t>(caps.max_texture));
    return access;
}

Reading OpenScene::open(const std::string& path, const Settings& settings, const gl::Caps& caps) {
    Reading reading;
    const bool again = shown_ && shown_->path == path && !settings.fresh;
    Plan plan;
    const auto choose = [&](const Scene& scene, Rungs& rungs) {
        if (again) {
            recall(remembered(), scene, rungs);  // for ladders that were gone for a while
            carry_over(shown_->controls.rungs, shown_->scene(), rungs, scene);
        }
        for (const std::string& rung : settings.rungs)
            if (names_ladder(scene, rung)) choose_rung(rungs, scene, rung, reading.settings);
    };
    const auto planned = [&](const Plan& made, Document& document) {
        plan = made;
        if (!settings.lints) return;
        document.diagnostics.append(lint::check(made, document.sources, shader_includes(*document.files)));
    };
    RuntimeOptions options;
    options.previous = shown_ ? &*shown_->runtime : nullptr;
    auto read = open_document(path, caps, choose, planned, options, page_access(caps));
    reading.shown = read->runtime && (!again || no_new_errors(shown_->diagnostics, read->diagnostics));
    if (reading.shown)
        take(std::move(read), std::move(plan), settings, again, reading.settings);
    else
        reading.refused = std::move(read);
    return reading;
}

void OpenScene::take(std::unique_ptr<Document> read, Plan plan, const Settings& settings, bool again,
                     Diagnostics& problems) {
    ++readings_;
    memory_ = again ? remembered() : Remembered{};
    if (again) {
        recall(memory_, read->scene(), read->controls);
        carry_over(shown_->controls, shown_->scene(), read->controls, read->scene());
        carry_objects(object_names(shown_->scene()), object_names(read->scene()), view);
    } else {
        view = {};
    }
    for (const std::string& value : settings.values)
        set_value_with_comma(value, read->controls, read->scene(), problems);
    // What no ladder has the name of is a uniform of any program.
    for (const std::string& rung : settings.rungs)
        if (!names_ladder(read->scene(), rung)) set_value_with_comma(rung, read->controls, read->scene(), problems);
    for (const std::string& range : settings.ranges) set_range(range, read->scene(), read->controls, problems);
    if (settings.view)
        if (const std::string wrong = parse_view(*settings.view, view); !wrong.empty())
            problems.error("view-unreadable", wrong);
    reference_.reset();
    shown_ = std::move(read);
    plan_ = std::move(plan);
}

Remembered OpenScene::remembered() const {
    Remembered memory = memory_;
    if (shown_) remember(shown_->scene(), shown_->controls, memory);
    return memory;
}

const Diagnostics& OpenScene::follow_rungs() {
    memory_ = remembered();
    if (snell::follow_rungs(*shown_)) recall(memory_, shown_->scene(), shown_->controls);
    return shown_->runtime->ladder_problems();
}

std::unique_ptr<Document> OpenScene::compiled(const Plan& plan, const gl::Caps& caps, const Runtime* previous) const {
    RuntimeOptions options;
    options.previous = previous;
    return compile_document(shown_->path, plan, shown_->sources, shown_->controls, caps, page_access(caps), options);
}

void OpenScene::release() {
    reference_.reset();
    if (shown_) shown_->runtime.reset();
}

void OpenScene::restore(const gl::Caps& caps) {
    if (!shown_) return;
    release();
    plan_.rungs = shown_->controls.rungs.empty() ? plan_.rungs : shown_->controls.rungs;
    shown_ = compiled(plan_, caps, nullptr);
}

Document* OpenScene::reference(const gl::Caps& caps) {
    if (!shown_ || shown_->scene().ladders.empty()) return nullptr;
    if (!reference_) {
        Plan plan = plan_;
        plan.rungs = reference_rungs(plan.scene);
        reference_ = compiled(plan, caps, &*shown_->runtime);
    }
    Controls& controls = reference_->controls;
    carry_over(shown_->controls, shown_->scene(), controls, reference_->scene());
    controls.rungs = reference_->runtime->rungs();
    return reference_.get();
}

}  // namespace snell::web
