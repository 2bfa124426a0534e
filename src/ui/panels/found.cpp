#include "src/ui/panels/found.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cctype>
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

// Texts in two parts, of which either may be empty.
using Parts = std::array<std::string, 2>;

std::string joined(const Parts& parts) {
    return parts[0] + (parts[0].empty() || parts[1].empty() ? "" : ", ") + parts[1];
}

// Of an error that is none, what is visible of it is nothing, too.
Parts error_and_flip(double error, const std::optional<double>& flip) {
    const std::string text = error_text(error);
    return {"error " + text, flip && text != error_text(0) ? "FLIP " + error_text(*flip) : ""};
}

Parts errors_of(const FoundRow& row) {
    if (row.group == Group::untried) return {row.remark};
    if (row.group == Group::unused) {
        const std::string loading = row.loading > 0 ? fmt::format("{:.3g} ms of loading", row.loading) : "";
        const std::string memory = row.bytes > 0 ? bytes_text(row.bytes) + " of GPU memory" : "";
        return {loading.empty() && memory.empty() ? "no pixel differs" : loading, memory};
    }
    if (!row.error) return {};
    Parts worst = error_and_flip(*row.error, row.flip);
    worst[0].insert(0, "worst ");
    return worst;
}

std::string tip_of(const FoundRow& row) {
    std::string text = fmt::format("{}, {}: {}\n{}\n\u2192 {}", row.name, row.kind, row.meaning, row.before,
                                   row.after.empty() ? "(nothing)" : row.after);
    if (!row.where.empty()) text += "\n" + row.where;
    if (const std::string time = time_of(row); !time.empty()) text += "\ntime " + time;
    if (row.group != Group::untried && !joined(errors_of(row)).empty()) text += "\n" + joined(errors_of(row));
    if (row.error)
        text += "\nworst error: of all views and values that were tried, over the pixels in which the scene draws";
    if (row.error_here) text += "\nas the scene opens: " + joined(error_and_flip(*row.error_here, row.flip_here));
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

// How the texts of a group's rows are broken into lines. All rows of a group are equally high, so that only those in
// sight need to be known.
struct Lines {
    bool narrow = false;  // change and time have lines of their own
    bool parts = false;   // so have the parts of the error
    int count(Group group) const {
        const int time = narrow && group != Group::untried ? 1 : 0;
        return (narrow ? 3 : 2) + (parts ? 2 : 1) + time;
    }
};

bool narrow(float width) { return width < 18 * ImGui::GetFontSize(); }

Lines lines_of(Group group, float width) {
    const char* const longest =
        group == Group::unused ? "286 ms of loading, 999.9 kB of GPU memory" : "worst error .00123, FLIP .00123";
    return {narrow(width), group == Group::untried || width_of(longest) > width};
}

// The place, as a link to the editor. Returns true if the pointer is on it.
bool place_link(const Facts& facts, const FoundRow& row, const Text& where, ImVec2 at, Requests& requests,
                Layout& layout) {
    put(where, at, facts.found->stale);
    const bool on_link = ImGui::IsItemHovered();
    layout.note("found.place", row.name);
    if (edit_link(facts, row.place)) requests.edit = row.place;
    if (!row.place.file.empty()) {
        const float under = at.y + ImGui::GetTextLineHeight() - 1;
        ImGui::GetWindowDrawList()->AddLine({at.x, under}, {at.x + width_of(where.view()), under},
                                            ImGui::GetColorU32(palette().dim),
                                            std::max(1.0F, ImGui::GetFontSize() / 14));
    }
    return on_link && !row.place.file.empty();
}

// Draws the texts of a row, a line below the other. Returns true if the pointer is on the place's link.
bool texts_of(const Facts& facts, const FoundRow& row, ImVec2 at, float width, Requests& requests, Layout& layout) {
    const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight();
    const Lines lines = lines_of(row.group, width);
    const bool dim = facts.found->stale;
    const auto down = [&] { at.y += line; };
    const std::string time = time_of(row);
    const float beside = lines.narrow || time.empty() ? 0 : width_of(time);
    put(shortened(Text("{}  {}", row.name, row.kind).view(), width - beside - (beside > 0 ? em : 0)), at, dim);
    if (beside > 0) put(Text(time), {at.x + width - beside, at.y}, dim);
    down();
    const Text where = shortened(row.where, lines.narrow ? width : width * .6F);
    const bool on_link = place_link(facts, row, where, at, requests, layout);
    const float left = lines.narrow ? 0 : width_of(where.view()) + em * .6F;
    if (lines.narrow) down();
    const std::string_view after = row.after.empty() ? "(nothing)" : std::string_view(row.after);
    put(Text(change_text(row.before, after, width - left)), {at.x + left, at.y}, true);
    down();
    Parts errors = errors_of(row);
    if (row.group == Group::untried) {
        const std::string broken = broken_at_blanks(row.remark, width);
        const std::size_t end = std::min(broken.find('\n'), broken.size());
        errors = {broken.substr(0, end), row.remark.substr(std::min(end + 1, row.remark.size()))};
    } else if (!lines.parts) {
        errors = {joined(errors)};
    }
    put(shortened(errors[0], width), at, dim || row.group == Group::untried);
    layout.note("found.error", row.name);
    if (lines.parts) {
        down();
        put(shortened(errors[1], width), at, dim || row.group == Group::untried);
    }
    down();
    if (lines.narrow && !time.empty()) put(shortened(Text("time {}", time).view(), width), at, dim);
    return on_link;
}

float row_indent() { return ImGui::GetFontSize() * .9F; }

void row(const Facts& facts, const FoundRow& row, Requests& requests, Layout& layout) {
    const float em = ImGui::GetFontSize(), line = ImGui::GetTextLineHeight(), indent = row_indent();
    const float width = ImGui::GetContentRegionAvail().x;
    const float height = line * static_cast<float>(lines_of(row.group, width - indent).count(row.group));
    const bool shown = facts.found->shown == row.name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetCursorPosX();
    ImGui::PushID(row.name.c_str());
    ImGui::BeginDisabled(facts.found->stale);
    const bool pressed = selectable("##row", shown, ImGuiSelectableFlags_AllowItemOverlap, {width, height});
    const bool over = ImGui::IsItemHovered();
    const ImVec2 below = ImGui::GetCursorPos();
    layout.note("found.row", row.name);
    if (over) tip(tip_of(row));
    if (row.front)
        ImGui::GetWindowDrawList()->AddCircleFilled({at.x + indent * .4F, at.y + line * .5F}, em * .24F,
                                                    ImGui::GetColorU32(palette().accent));
    const bool on_link = texts_of(facts, row, {at.x + indent, at.y}, width - indent, requests, layout);
    ImGui::EndDisabled();
    ImGui::PopID();
    ImGui::SetCursorPos({left, below.y});
    if (pressed && !on_link && row.group != Group::untried) requests.show_rung = shown ? "" : row.name;
}

// Only rows in sight are drawn.
void rows_of(const Facts& facts, const std::vector<FoundRow>& rows, Group group, Requests& requests, Layout& layout) {
    const auto first = ranges::find(rows, group, &FoundRow::group);
    const auto count = ranges::count(rows, group, &FoundRow::group);
    const float line = ImGui::GetTextLineHeight(), gap = ImGui::GetStyle().ItemSpacing.y;
    const int lines = lines_of(group, ImGui::GetContentRegionAvail().x - row_indent()).count(group);
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

void groups(const Facts& facts, const std::vector<FoundRow>& rows, Requests& requests, Layout& layout) {
    constexpr std::array<std::pair<Group, const char*>, 4> headings{{{Group::cheaper, "Cheaper"},
                                                                     {Group::dearer, "Not cheaper"},
                                                                     {Group::better, "What the picture lacks"},
                                                                     {Group::unused, "Changes nothing"}}};
    for (const auto& [group, heading] : headings) {
        if (ranges::count(rows, group, &FoundRow::group) == 0) continue;
        ImGui::Spacing();
        wrapped(heading, true);
        layout.note("found.heading", heading);
        time_heading();
        rows_of(facts, rows, group, requests, layout);
    }
    const auto untried = ranges::count(rows, Group::untried, &FoundRow::group);
    if (untried == 0 || facts.found->progress) return;
    const bool open =
        ImGui::TreeNodeEx("untried", ImGuiTreeNodeFlags_SpanAvailWidth, "Not tried: %d", static_cast<int>(untried));
    toggled_by_keys(open);
    layout.note("found.untried");
    if (!open) return;
    rows_of(facts, rows, Group::untried, requests, layout);
    ImGui::TreePop();
}

// What can be done with the rung whose picture is shown. It takes as much room while there is none, so that a click on
// a row moves no row.
void shown_rung(const FoundFacts& found, Requests& requests, Layout& layout) {
    const bool none = found.shown.empty();
    const std::string whole = fmt::format(
        "The picture is that of {}. Esc shows the scene again, and so does a click on the row.", found_text(found));
    const float end = ImGui::GetCursorPosY() + ImGui::GetStyle().ItemSpacing.y +
                      ImGui::CalcTextSize(whole.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y;
    wrapped(
        none ? "A click on a row shows its picture. Write\u2026 then writes the scene with that change into a folder."
             : whole,
        none);
    layout.note(none ? "found.hint" : "found.shown");
    ImGui::SetCursorPosY(std::max(ImGui::GetCursorPosY(), end));
    ImGui::BeginDisabled(none);
    if (button("Write\u2026", layout, "found.write")) requests.write_rung = true;
    tip("Writes the scene and its shaders with this change into a folder");
    if (next_button("Copy command", layout, "found.copy")) requests.copy_rung = true;
    tip("Copies the command that writes them");
    ImGui::EndDisabled();
}

// While the pointer is over the rows or their buttons, they stay as they are and where they are: what is measured
// meanwhile is shown once it leaves, and what grows above them is scrolled away.
void held_groups(const Facts& facts, FoundMemory& memory, Requests& requests, Layout& layout) {
    const float top = ImGui::GetCursorPosY();
    const bool held = memory.over && !facts.found->rows.empty();
    if (held) {
        ImGui::SetCursorPosY(memory.top);
        if (top > memory.top) ImGui::SetScrollY(ImGui::GetScrollY() + top - memory.top);
        memory.grown |= top > memory.top;
    }
    memory.top = held ? std::max(memory.top, top) : top;
    const float begin = ImGui::GetCursorScreenPos().y;
    if (!facts.found->rows.empty()) shown_rung(*facts.found, requests, layout);
    groups(facts, held ? memory.rows : facts.found->rows, requests, layout);
    const float mouse = ImGui::GetIO().MousePos.y;
    memory.over = ImGui::IsWindowHovered(ImGuiHoveredFlags_AllowWhenBlockedByActiveItem) && mouse >= begin &&
                  mouse < ImGui::GetCursorScreenPos().y;
    if (memory.over && !held) memory.rows = facts.found->rows;
    if (!memory.over) memory = {.top = memory.top};
    if (memory.grown) ImGui::Dummy({0, ImGui::GetWindowHeight()});  // so that it can be scrolled
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
    if (found.rows.empty()) return;
    std::string legend = "The number before a change names it for 'snell accuracy --apply'.";
    if (ranges::any_of(found.rows, [](const FoundRow& row) { return row.flip || row.flip_here; }))
        legend += " FLIP is how visible an error is, from 0 to 1.";
    wrapped(legend, true);
    layout.note("found.legend", legend);
}

}  // namespace

void found_rungs(const Facts& facts, FoundMemory& memory, Requests& requests, Layout& layout) {
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
        const bool held = memory.over && memory.rows.size() != found.rows.size();
        fitted(held            ? "New rungs are listed once the pointer leaves the list."
               : found.waiting ? "It waits until nothing moves."
                               : found.doing,
               ImGui::GetContentRegionAvail().x, true);
        layout.note("found.doing");
        ImGui::ProgressBar(static_cast<float>(*found.progress), {-FLT_MIN, ImGui::GetFontSize() * .4F}, "");
    }
    remarks(found, layout);
    held_groups(facts, memory, requests, layout);
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

std::string change_text(std::string_view before, std::string_view after, float width) {
    constexpr std::string_view arrow = " \u2192 ", dots = "\u2026";
    if (std::string whole = fmt::format("{}{}{}", before, arrow, after); width_of(whole) <= width) return whole;
    // Names and numbers stay whole.
    const auto in_word = [](char c) {
        return c == '_' || c == '.' || static_cast<unsigned char>(c) > 127 ||
               std::isalnum(static_cast<unsigned char>(c)) != 0;
    };
    const std::size_t most = std::min(before.size(), after.size());
    const auto begins = [&](std::string_view text, std::size_t at) { return at < text.size() && in_word(text[at]); };
    const auto ends = [&](std::string_view text, std::size_t left) {
        return left < text.size() && in_word(text[text.size() - 1 - left]);
    };
    std::size_t head = 0, tail = 0;
    while (head < most && before[head] == after[head]) ++head;
    const std::size_t equal = head;
    if (begins(before, head) || begins(after, head))
        while (head > 0 && in_word(before[head - 1])) --head;
    while (tail + head < most && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) ++tail;
    if (ends(before, tail) || ends(after, tail))
        while (tail > 0 && in_word(before[before.size() - tail])) --tail;
    const auto differing = [&](std::string_view text) {
        return fmt::format("{}{}{}", head > 0 ? dots : "", text.substr(head, text.size() - head - tail),
                           tail > 0 ? dots : "");
    };
    const std::string from = differing(before), to = differing(after);
    const float room = std::max(width - width_of(arrow), 0.0F);
    const float left = std::min(width_of(from), std::max(room / 2, room - width_of(to)));
    // What differs first is never left out: too long a word loses what it begins with in both texts.
    const auto cut = [&](std::string_view text, const std::string& all, float fits) {
        std::size_t end = equal;
        while (end < text.size() && in_word(text[end])) ++end;
        const std::string word = fmt::format("{}{}{}", dots, text.substr(head, end - head), dots);
        if (width_of(all) <= fits || width_of(word) <= fits) return shortened(all, fits, true);
        return shortened(fmt::format("{}{}", equal > 0 ? dots : "", text.substr(equal)), fits, true);
    };
    return fmt::format("{}{}{}", cut(before, from, left).view(), arrow, cut(after, to, room - left).view());
}

std::string ratio_text(double ratio) { return "\u00D7" + ratio_number(ratio); }

}  // namespace snell::ui
