#include "src/ui/panels/found.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

using Group = FoundRow::Group;

std::string ratio_number(double ratio) {
    const std::string text = fmt::format("{:.{}f}", ratio, ratio < 9.995 ? 2 : 0);
    return text.starts_with("0.") ? text.substr(1) : text;
}

std::string time_of(const FoundRow& row) {
    if (!(row.ratio > 0)) return {};
    if (!(row.high > 0)) return "about " + ratio_text(row.ratio);
    return fmt::format("{} [{}, {}]", ratio_text(row.ratio), ratio_number(row.low), ratio_number(row.high));
}

// Of an error that is none, what is visible of it is nothing, too.
std::string error_and_flip(double error, const std::optional<double>& flip) {
    const std::string text = error_text(error);
    return flip && text != error_text(0) ? fmt::format("{}, FLIP {}", text, error_text(*flip)) : text;
}

std::string errors_of(const FoundRow& row) {
    if (row.group == Group::untried) return row.remark;
    if (row.group == Group::unused) {
        const std::string loading = row.loading > 0 ? fmt::format("{:.3g} ms of loading", row.loading) : "";
        const std::string memory = row.bytes > 0 ? bytes_text(row.bytes) + " of GPU memory" : "";
        if (loading.empty() && memory.empty()) return "no pixel differs";
        return loading + (loading.empty() || memory.empty() ? "" : ", ") + memory;
    }
    if (!row.error) return {};
    return (row.group == Group::better ? "the scene's worst error " : "worst error ") +
           error_and_flip(*row.error, row.flip);
}

std::string tip_of(const FoundRow& row) {
    std::string text = fmt::format("{}, {}: {}\n{}\n\u2192 {}", row.name, row.kind, row.meaning, row.before,
                                   row.after.empty() ? "(nothing)" : row.after);
    if (row.error)
        text += "\nworst error: of all views and values that were tried, over the pixels in which the scene draws";
    if (row.error_here) text += "\nas the scene opens: error " + error_and_flip(*row.error_here, row.flip_here);
    if (row.of_display) text += fmt::format("\nerror of display values {}", error_text(*row.of_display));
    if (row.front) text += "\nworth its time";
    if (!row.remark.empty()) text += "\n" + row.remark;
    return text;
}

void put(const Text& text, ImVec2 at, bool dim) {
    ImGui::SetCursorScreenPos(at);
    ImGui::PushStyleColor(ImGuiCol_Text, dim ? palette().dim : palette().text);
    ImGui::TextUnformatted(text.begin(), text.end());
    ImGui::PopStyleColor();
}

// The place, as a link to the editor, and the change. Returns true if the pointer is on the link.
bool change_line(const Facts& facts, const FoundRow& row, ImVec2 at, float width, Requests& requests, Layout& layout) {
    const float em = ImGui::GetFontSize();
    const Text where = shortened(row.where, width * .6F);
    const float taken = width_of(where.view());
    put(where, at, facts.found->stale);
    const bool on_link = ImGui::IsItemHovered();
    layout.note("found.place", row.name);
    if (edit_link(facts, row.place)) requests.edit = row.place;
    if (!row.place.file.empty()) {
        const float under = at.y + ImGui::GetTextLineHeight() - 1;
        ImGui::GetWindowDrawList()->AddLine({at.x, under}, {at.x + taken, under}, ImGui::GetColorU32(palette().dim),
                                            std::max(1.0F, em / 14));
    }
    const float left = taken + em * .6F;
    const Text change("{} \u2192 {}", row.before, row.after.empty() ? "(nothing)" : row.after);
    if (width - left > 2 * em) put(shortened(change.view(), width - left), {at.x + left, at.y}, true);
    return on_link && !row.place.file.empty();
}

// In narrow panels the time has a line of its own, the last one.
bool narrow(float width) { return width < 18 * ImGui::GetFontSize(); }
int lines_of(Group group, float width) { return group != Group::untried && narrow(width) ? 4 : 3; }

// The first line is number and kind; the time is at its right end, if there is room.
void first_line(const FoundRow& row, ImVec2 at, float width, int lines, bool dim) {
    const std::string time = time_of(row);
    const bool beside = lines < 4 && !time.empty();
    const float taken = beside ? width_of(time) : 0, gap = beside ? ImGui::GetFontSize() : 0;
    put(shortened(Text("{}  {}", row.name, row.kind).view(), width - taken - gap), at, dim);
    if (beside) return put(Text(time), {at.x + width - taken, at.y}, dim);
    if (!time.empty())
        put(shortened(Text("time {}", time).view(), width), {at.x, at.y + 3 * ImGui::GetTextLineHeight()}, dim);
}

void row(const Facts& facts, const FoundRow& row, Requests& requests, Layout& layout) {
    const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight(), indent = em * .9F;
    const float width = ImGui::GetContentRegionAvail().x;
    const int lines = lines_of(row.group, width);
    const bool shown = facts.found->shown == row.name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetCursorPosX();
    ImGui::PushID(row.name.c_str());
    ImGui::BeginDisabled(facts.found->stale);
    const bool pressed =
        selectable("##row", shown, ImGuiSelectableFlags_AllowItemOverlap, {width, line * static_cast<float>(lines)});
    const bool over = ImGui::IsItemHovered();
    const ImVec2 below = ImGui::GetCursorPos();
    layout.note("found.row", row.name);
    if (over) tip(tip_of(row));
    if (row.front)
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + indent * .4F, at.y + line * .5F}, em * .24F,
                                                    ImGui::GetColorU32(palette().accent));
    const bool dim = facts.found->stale;
    first_line(row, {at.x + indent, at.y}, width - indent, lines, dim);
    const bool on_link = change_line(facts, row, {at.x + indent, at.y + line}, width - indent, requests, layout);
    put(shortened(errors_of(row), width - indent), {at.x + indent, at.y + 2 * line},
        dim || row.group == Group::untried);
    layout.note("found.error", row.name);
    ImGui::EndDisabled();
    ImGui::PopID();
    ImGui::SetCursorPos({left, below.y});
    if (pressed && !on_link && row.group != Group::untried) requests.show_rung = shown ? "" : row.name;
}

// Only rows in sight are drawn.
void rows_of(const Facts& facts, Group group, Requests& requests, Layout& layout) {
    const std::vector<FoundRow>& rows = facts.found->rows;
    const auto first = ranges::find(rows, group, &FoundRow::group);
    const auto count = ranges::count(rows, group, &FoundRow::group);
    const float line = ImGui::GetTextLineHeight(), gap = ImGui::GetStyle().ItemSpacing.y;
    const int lines = lines_of(group, ImGui::GetContentRegionAvail().x);
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(count), line * static_cast<float>(lines) + gap);
    // Tab leads to all of them.
    if (kit().focus.at != 0) clipper.ForceDisplayRangeByIndices(0, static_cast<int>(count));
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) row(facts, first[i], requests, layout);
    clipper.End();
}

// At the right end of the line, if there is room.
void time_heading() {
    constexpr const char* text = "\u00D7 the scene's time";
    const float right = ImGui::GetContentRegionMax().x - width_of(text);
    if (narrow(ImGui::GetContentRegionAvail().x)) return;
    ImGui::SameLine();
    if (ImGui::GetCursorPosX() > right) return ImGui::NewLine();
    ImGui::SetCursorPosX(right);
    ImGui::TextDisabled("%s", text);
}

void groups(const Facts& facts, Requests& requests, Layout& layout) {
    constexpr std::array<std::pair<Group, const char*>, 4> headings{{{Group::cheaper, "Cheaper"},
                                                                     {Group::dearer, "Not cheaper"},
                                                                     {Group::better, "What the picture lacks"},
                                                                     {Group::unused, "Changes nothing"}}};
    const std::vector<FoundRow>& rows = facts.found->rows;
    const auto has_flip = [](const FoundRow& row) { return row.flip || row.flip_here; };
    if (!rows.empty()) {
        std::string legend = "The number before a change names it for 'snell accuracy --apply'.";
        if (ranges::any_of(rows, has_flip)) legend += " FLIP is how visible an error is, from 0 to 1.";
        wrapped(legend, true);
        layout.note("found.legend", legend);
    }
    for (const auto& [group, heading] : headings) {
        if (ranges::count(rows, group, &FoundRow::group) == 0) continue;
        ImGui::Spacing();
        wrapped(heading, true);
        layout.note("found.heading", heading);
        time_heading();
        rows_of(facts, group, requests, layout);
    }
    const auto untried = ranges::count(rows, Group::untried, &FoundRow::group);
    if (untried == 0 || facts.found->progress) return;
    const bool open =
        ImGui::TreeNodeEx("untried", ImGuiTreeNodeFlags_SpanAvailWidth, "Not tried: %d", static_cast<int>(untried));
    toggled_by_keys(open);
    layout.note("found.untried");
    if (!open) return;
    rows_of(facts, Group::untried, requests, layout);
    ImGui::TreePop();
}

// What can be done with the rung whose picture is shown.
void shown_rung(const FoundFacts& found, Requests& requests, Layout& layout) {
    wrapped(fmt::format("The picture is that of {}. Esc shows the scene again, and so does a click on the row.",
                        found_text(found)));
    layout.note("found.shown");
    if (button("Write\u2026", layout, "found.write")) requests.write_rung = true;
    tip("Writes the scene and its shaders with this change into a folder");
    if (next_button("Copy command", layout, "found.copy")) requests.copy_rung = true;
    tip("Copies the command that writes them");
}

// What must be known of the numbers.
void remarks(const FoundFacts& found, Layout& layout) {
    const auto say = [&](const char* name, std::string_view text) {
        wrapped(text, true);
        layout.note(name);
    };
    if (!found.note.empty()) say("found.note", found.note);
    if (!found.reduced.empty()) say("found.reduced", found.reduced);
    if (found.stale)
        say("found.stale", "The files have changed: these are rungs of the older text.");
    else if (found.older)
        say("found.older", "Values or view have changed: the numbers are of the older ones.");
    if (!found.remark.empty()) say("found.remark", found.remark);
    if (found.asked && !found.progress && found.rows.empty() && found.remark.empty() && !found.stale)
        say("found.none", "snell finds nothing to change in this scene.");
}

}  // namespace

void found_rungs(const Facts& facts, Requests& requests, Layout& layout) {
    if (!facts.found) return;
    const FoundFacts& found = *facts.found;
    const bool searching = found.progress.has_value();
    ImGui::Spacing();
    ImGui::BeginDisabled(!searching && !found.note.empty());
    requests.find_rungs = button(searching ? "Stop" : "Find rungs", layout, "found.find");
    ImGui::EndDisabled();
    tip("Tries changes of the scene's own texts while nothing moves: what makes it cheaper, what the picture lacks, "
        "and what changes no pixel.\nNothing is written.");
    if (searching) {
        fitted(found.waiting ? "It waits until nothing moves." : found.doing, ImGui::GetContentRegionAvail().x, true);
        layout.note("found.doing");
        ImGui::ProgressBar(static_cast<float>(*found.progress), {-FLT_MIN, ImGui::GetFontSize() * .4F}, "");
    }
    remarks(found, layout);
    if (!found.shown.empty()) shown_rung(found, requests, layout);
    groups(facts, requests, layout);
}

bool found_keys(const Facts& facts, Requests& requests) {
    if (!facts.found || facts.found->shown.empty() || !pressed(Key::escape)) return false;
    requests.show_rung = "";
    return true;
}

const FoundRow* shown_row(const FoundFacts& facts) {
    const auto row = ranges::find(facts.rows, facts.shown, &FoundRow::name);
    return facts.shown.empty() || row == facts.rows.end() ? nullptr : &*row;
}

std::string found_text(const FoundFacts& facts) {
    const char* noun = facts.shown.find('+') == facts.shown.npos ? "found rung" : "found rungs";
    return fmt::format("{} {}", noun, facts.shown);
}

std::string ratio_text(double ratio) { return "\u00D7" + ratio_number(ratio); }

}  // namespace snell::ui
