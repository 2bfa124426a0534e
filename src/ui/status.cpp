#include "src/ui/shell.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <imgui.h>

#include "parser/text/ranges.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"

namespace snell::ui {

namespace {

struct Part {
    const char* name;  // in the layout
    int rank = 0;      // those of low rank are left out first
    Text text;
    float width = 0;  // 0: left out
    float least = 0;  // if not 0, it may be shortened to this width, as if it were of the second rank
    int shortened = 0;
    bool dim = true;
    bool right = false;  // at the right end of the line

    bool shortens() const { return least > 0 && width > least; }
    int next() const { return shortens() ? shortened : rank; }
};

// At most as many as status_line() adds.
struct Parts {
    std::array<Part, 16> items;
    std::size_t count = 0;

    // `least` and `shortened` are those of Part.
    Part& add(const char* name, int rank, std::string_view text, float least = 0, int shortened = 0) {
        Part& part = items[count++];
        part = {.name = name, .rank = rank, .text = Text(text), .width = width_of(text)};
        part.least = std::min(least, part.width);
        part.shortened = shortened;
        return part;
    }
    std::span<Part> all() { return {items.data(), count}; }
};

// Shortens parts and leaves them out until the line has the width.
void fit(std::span<Part> parts, float room, float gap) {
    const auto used = [&] {
        float sum = -gap;
        for (const Part& part : parts) sum += part.width > 0 ? part.width + gap : 0;
        return sum;
    };
    for (float over = used() - room; over > 0; over = used() - room) {
        Part* first = nullptr;
        for (Part& part : parts)
            if (part.width > 0 && (!first || part.next() < first->next())) first = &part;
        if (!first) return;
        first->width = first->shortens() ? std::max(first->least, first->width - over) : 0;
    }
}

bool problem_chip(const Text& text, bool errors, Layout& layout) {
    ImGui::PushStyleColor(ImGuiCol_Text, errors ? palette().error_text : palette().warning_text);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {ImGui::GetStyle().FramePadding.x, 0});
    const bool chosen = button(text.c_str(), layout, "problems");
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    return chosen;
}

void draw(const Facts& facts, const Part& part, bool errors, Memory& memory, Layout& layout) {
    if (std::string_view(part.name) == "problems") {
        bool& open = errors ? memory.problems_hidden : memory.warnings_open;
        if (problem_chip(part.text, errors, layout)) open = !open;
        return;
    }
    fitted(part.text.view(), part.width + 1, part.dim);
    if (std::string_view(part.name) == "status.cost")
        tip(Text("time to draw the last picture; the first after a load or a change of rungs\nwaits for the driver's "
                 "compiler\n{} samples per pixel\n{}",
                 facts.samples, facts.renderer)
                .view());
    if (std::string_view(part.name) == "notice") tip(memory.notice);
    if (std::string_view(part.name) == "status.nan")
        tip("pixels that are not a number, or an infinite one, which show as any colour\ncounted in a small picture, "
            "which may miss single "
            "ones; N marks all");
    layout.note(part.name);
}

void add_keys(const Facts& facts, Parts& parts) {
    if (!facts.scene) {
        parts.add("status.open", 15, "Ctrl+O: open a scene");
    } else {
        parts.add("status.drag", 14, "drag: turn");
        parts.add("status.wheel", 13, "wheel: scale");
        parts.add("status.move", 12, "right drag: move");
        parts.add("status.reset", 11, "R: reset");
        parts.add("status.accuracy", 15, "A: accuracy");
    }
    parts.add("status.keys", 20, "F1: keys");
}

void add_cost(const Facts& facts, Parts& parts) {
    if (!facts.scene || facts.first_picture) return;
    // Widths of their own, so that the line is quiet while the numbers change.
    if (facts.animated) {
        Part& time = parts.add("status.time", 40, Text("t = {:.2f} s", facts.time).view());
        time.width = std::max(time.width, width_of("t = 1000.00 s"));
        time.right = true;
    }
    if (!facts.grain.empty()) parts.add("status.grain", 75, facts.grain).right = true;
    Part& cost = parts.add("status.cost", 70, Text("picture {:.1f} ms", facts.frame_ms).view());
    cost.width = std::max(cost.width, width_of("picture 100.0 ms"));
    cost.right = true;
}

// Returns true if there are errors.
bool collect(const Facts& facts, const Memory& memory, Parts& parts) {
    const float em = ImGui::GetFontSize();
    Part& file = parts.add("status.file", 60, facts.file.empty() ? "no scene" : facts.file, 6 * em, 35);
    file.dim = false;
    const auto count = [&](Severity severity) {
        return static_cast<std::size_t>(
            ranges::count(facts.problems, severity, [](const Problem& p) { return p.finding.severity; }));
    };
    const std::size_t errors = count(Severity::error), warnings = count(Severity::warning);
    if (errors + warnings > 0) {
        const std::string text = counted(errors > 0 ? errors : warnings, errors > 0 ? "error" : "warning");
        parts.add("problems", 100, text).width += 2 * ImGui::GetStyle().FramePadding.x;
    }
    // The names of two states say it themselves.
    if ((facts.stale || !facts.failed_rungs.empty()) && !facts.states)
        parts.add("status.stale", 93, facts.stale && facts.incomplete ? "incomplete picture" : "last good picture")
            .dim = false;
    if (!facts.nan.empty()) parts.add("status.nan", 91, facts.nan, 4 * em, 45).dim = false;
    if (facts.found && !facts.found->shown.empty()) {
        const std::string text = found_text(*facts.found) + ": Esc shows the scene";
        parts.add("status.found", 95, text, 9 * em, 92).dim = false;
    }
    if (facts.found && facts.found->progress && !memory.accuracy_in_sight())
        parts.add("status.finding", 94,
                  Text("finding rungs {:.0f} %", std::floor(100 * *facts.found->progress)).view());
    if (memory.hold.picking) {
        const bool picked = memory.hold.object != none;
        Part& mode = parts.add("status.pick", 90, picked ? "pick: Esc deselects" : "pick: click an object, Esc ends");
        mode.dim = false;
    }
    if (!facts.object.empty()) {
        parts.add("status.object", 50, facts.object, 6 * em, 30);
    }
    if (memory.notice.empty()) {
        add_keys(facts, parts);
    } else {
        // The first line; the tooltip has all of them. It is left out last, because the next press ends it.
        const std::string_view line = std::string_view(memory.notice).substr(0, memory.notice.find('\n'));
        parts.add("notice", 101, line, 8 * em, 65).dim = false;
    }
    add_cost(facts, parts);
    return errors > 0;
}

}  // namespace

void status_line(const Facts& facts, const Rect& status, Memory& memory, Layout& layout) {
    ImGui::SetNextWindowPos({status.x, status.y});
    ImGui::SetNextWindowSize({status.width, status.height});
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding,
                        {style.WindowPadding.x, (status.height - ImGui::GetFontSize()) * .5F});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                       ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                                       ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("##status", nullptr, fixed)) {
        Parts parts;
        const bool errors = collect(facts, memory, parts);
        const float gap = ImGui::GetFontSize();
        fit(parts.all(), status.width - 2 * style.WindowPadding.x, gap);
        float left = ImGui::GetCursorPosX(), right = ImGui::GetWindowContentRegionMax().x + gap;
        const float top = ImGui::GetCursorPosY();
        for (const Part& part : parts.all())
            if (part.right && part.width > 0) right -= part.width + gap;
        for (const Part& part : parts.all()) {
            if (part.width <= 0) continue;
            float& at = part.right ? right : left;
            const float unused = part.right ? part.width - width_of(part.text.view()) : 0;
            ImGui::SetCursorPos({at + std::max(0.0F, unused), top});
            draw(facts, part, errors, memory, layout);
            at += part.width + gap;
        }
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
}

void loading(const std::string& text, double share) {
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(30 * em, all.x), 0});
    ImGui::Begin("##loading", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
    fitted(text, ImGui::GetContentRegionAvail().x);
    ImGui::ProgressBar(static_cast<float>(std::clamp(share, 0., 1.)), {-1, .5F * em}, "");
    ImGui::End();
}

void first_picture(const Facts& facts, const Rect& area, Layout& layout) {
    if (!facts.first_picture) return;
    const bool over_panel = !has_room(area);
    const Rect scene = with_room(area);
    const float em = ImGui::GetFontSize();
    Text whole("Drawing the first picture of {}", facts.file);
    if (facts.longest_picture > 0) whole.add(", for {:g} s at most", facts.longest_picture);
    whole.add("\u2026");
    const float wrap = std::max(scene.width - 3 * em, em);
    const ImVec2 words = ImGui::CalcTextSize(whole.begin(), whole.end(), false, wrap);
    const ImVec2 size(words.x + 2 * em, words.y + em);
    const ImVec2 at(std::round(scene.x + (scene.width - size.x) / 2),
                    std::round(scene.y + (scene.height - size.y) / 2));
    ImDrawList& list = over_panel ? *ImGui::GetForegroundDrawList() : *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(at, {at.x + size.x, at.y + size.y}, pack(palette().problem_background), em * .4F);
    list.AddText(nullptr, 0, {at.x + em, at.y + em * .5F}, pack(palette().problem_text), whole.begin(), whole.end(),
                 wrap);
    layout.place("first picture", {at.x, at.y, size.x, size.y});
}

}  // namespace snell::ui
