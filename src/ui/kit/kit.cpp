#include "src/ui/kit/kit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <imgui.h>
#include <imgui_internal.h>

#include "parser/text/ranges.h"
#include "src/ui/kit/field.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/widgets.h"

namespace snell::ui {

namespace {

constexpr double tip_delay = .5;  // seconds without motion

// Before the frame begins, Dear ImGui has not yet seen what is pressed.
bool newly_down(Key key) {
    const ImGuiIO& io = ImGui::GetIO();
    return io.KeysDown[static_cast<int>(key)] && io.KeysDownDuration[static_cast<int>(key)] < 0;
}

bool newly_clicked() {
    const ImGuiIO& io = ImGui::GetIO();
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
        if (io.MouseDown[button] && io.MouseDownDuration[button] < 0) return true;
    return false;
}

bool modal(const ImGuiPopupData& popup) { return !popup.Window || (popup.Window->Flags & ImGuiWindowFlags_Modal) != 0; }

// Closes drop-downs, menus and pickers at Escape, which then does nothing else, and at a click beside them, which then
// acts where it lands, but for pickers: a colour is looked at in the picture. Dear ImGui itself would ignore the key
// and swallow the click. A number that is being typed there has the key first, but not a field of text, which has the
// keyboard as soon as its list opens.
void close_popups() {
    ImGuiContext& g = *ImGui::GetCurrentContext();
    ImVector<ImGuiPopupData>& open = g.OpenPopupStack;
    if (open.empty()) return;
    if (newly_down(Key::escape) && kit().typing.id == 0 && !modal(open.back())) {
        g.IO.KeysDown[static_cast<int>(Key::escape)] = false;
        return ImGui::ClosePopupToLevel(open.Size - 1, true);
    }
    const ImVec2 mouse = g.IO.MousePos;
    if (!newly_clicked() || kit().opener.contains(mouse.x, mouse.y)) return;
    int kept = 0;
    for (int i = 0; i < open.Size; ++i)
        if (modal(open[i]) || open[i].Window->OuterRectClipped.Contains(mouse)) kept = i + 1;
    if (kept == open.Size) return;
    ImGui::ClosePopupToLevel(kept, true);
    if (kit().swallows) std::fill(std::begin(g.IO.MouseDown), std::end(g.IO.MouseDown), false);
}

// Where Tab leads, or with Shift the other way: after the last stop comes the first one.
const Focus::Stop* next_stop(const Focus& focus) {
    const ImGuiIO& io = ImGui::GetIO();
    const std::size_t count = focus.stops.size();
    const auto found = ranges::find(focus.stops, focus.at, &Focus::Stop::id);
    const bool text = found != focus.stops.end() && found->kind == Focus::Kind::text;
    const bool values = !ImGui::GetTopMostPopupModal() && ((io.WantTextInput && !text) || found == focus.stops.end());
    std::size_t at = static_cast<std::size_t>(found - focus.stops.begin());
    if (at == count && !io.KeyShift) at = count - 1;  // the next one is the first
    for (std::size_t i = 0; i < count; ++i) {
        at = (at + (io.KeyShift ? count - 1 : 1)) % count;
        if (focus.stops[at].kind == Focus::Kind::value || !values) return &focus.stops[at];
    }
    return count == 0 || io.WantTextInput ? nullptr : &(io.KeyShift ? focus.stops.back() : focus.stops.front());
}

// Where the arrow keys lead in a menu that is open; null if none is.
const Focus::Stop* next_entry(const Focus& focus) {
    const int way = int{pressed(Key::down, true)} - int{pressed(Key::up, true)};
    if (way == 0 || ImGui::GetIO().WantTextInput) return nullptr;
    const auto entry = [](const Focus::Stop& stop) { return stop.menu && stop.kind == Focus::Kind::button; };
    const Focus::Stop *first = nullptr, *last = nullptr, *before = nullptr, *after = nullptr;
    bool passed = false;
    for (const Focus::Stop& stop : focus.stops) {
        if (!entry(stop)) continue;
        if (!first) first = &stop;
        last = &stop;
        if (stop.id == focus.at)
            passed = true;
        else if (!passed)
            before = &stop;
        else if (!after)
            after = &stop;
    }
    if (way > 0) return after ? after : first;
    return passed && before ? before : last;
}

void move_focus(Focus& focus) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool tab = pressed(Key::tab, true) && !io.KeyCtrl && !io.KeyAlt && !focus.refused;
    const Focus::Stop* next = tab ? next_stop(focus) : next_entry(focus);
    focus.tabbed = next != nullptr;
    if (next) {
        focus.opens = io.WantTextInput || next->kind == Focus::Kind::text;
        focus.at = next->id;
        focus.presses = next->kind == Focus::Kind::button;
        ImGui::ClearActiveID();
    } else if (!focus.taken && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        focus.at = 0;
    }
    focus.presses = focus.presses && focus.at != 0 && (next || focus.passed);
    focus.refused = focus.taken = focus.passed = false;
    focus.stops.clear();
}

// Draws the text below its item, or beside the item's window, where it covers no neighbour.
void draw(const Tip& tip, bool below, ImVec4 color) {
    const ImVec2 all = ImGui::GetIO().DisplaySize, padding(ImGui::GetFontSize() * .5F, ImGui::GetFontSize() * .25F);
    const float em = ImGui::GetFontSize(), gap = em * .3F, wrap = std::min(32 * em, all.x - 2 * padding.x - em);
    const char *begin = tip.text.data(), *end = begin + tip.text.size();
    const ImVec2 size = ImGui::CalcTextSize(begin, end, false, wrap);
    const float width = size.x + 2 * padding.x, height = size.y + 2 * padding.y;
    ImVec2 at(tip.item.x, tip.item.y + tip.item.height + gap);
    if (const float left = tip.window.x - width - gap; !below && left >= 0) at = {left, tip.item.y};
    if (at.y + height > all.y) at.y = at.x < tip.window.x ? all.y - height : tip.item.y - height - gap;
    at = {std::clamp(at.x, 0.F, std::max(0.F, all.x - width)), std::clamp(at.y, 0.F, std::max(0.F, all.y - height))};
    ImGui::SetNextWindowPos({std::floor(at.x), std::floor(at.y)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().PopupRounding);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(wrap + padding.x + 1);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::TextUnformatted(begin, end);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
    ImGui::EndTooltip();
    ImGui::PopStyleVar(2);
}

// `next` is the last tooltip that a widget of this frame set.
void follow_tip(Tip& tip, Tip& next) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
    const bool same = tip.item == next.item;
    tip.item = next.item;
    tip.window = next.window;
    std::swap(tip.text, next.text);
    next.item = {};
    if (!same || (moved && !tip.shown)) tip.since = ImGui::GetTime();
    if (!same) tip.shown = tip.quiet = false;
    tip.quiet |= ranges::any_of(io.MouseDown, [](bool down) { return down; });
    tip.shown = !(tip.item == Rect{}) && !tip.quiet && (tip.shown || tip_due() <= 0);
}

}  // namespace

Kit& kit() { return *static_cast<Kit*>(ImGui::GetIO().UserData); }

const Palette& palette() { return *kit().palette; }

void begin_kit() {
    close_popups();
    if (newly_down(Key::escape) && !ImGui::GetIO().WantTextInput) kit().focus.at = 0;
    const std::array enders{Key::escape, Key::enter, Key::keypad_enter, Key::space};
    if (newly_clicked() || ranges::any_of(enders, newly_down)) kit().remark.shown = false;
}

void end_kit() {
    Kit& kit = ui::kit();
    move_focus(kit.focus);
    if (!kit.typing.drawn) kit.typing.id = 0;
    if (const unsigned next = std::exchange(kit.typing.next, 0); next != 0 && kit.typing.id == 0)
        type_number(next, kit.typing.next_value);
    kit.typing.drawn = false;
    follow_tip(kit.tip, kit.next_tip);
    if (kit.remark.shown)
        draw(kit.remark, true, palette().error_text);
    else if (kit.tip.shown)
        draw(kit.tip, false, palette().text);
}

void note_opener(const Rect& box, bool open, bool swallows) {
    Kit& kit = ui::kit();
    if (open) {
        if (kit.opener == Rect{}) {
            kit.opened_by = kit.focus.at;
            kit.opened_by_keys = kit.focus.presses;
        }
        kit.swallows = swallows;
        kit.opener = box;
    } else if (kit.opener == box) {
        kit.opener = {};
        if (kit.opened_by == 0) return;
        kit.focus.at = kit.opened_by;
        kit.focus.presses = kit.opened_by_keys;
    }
}

double tip_due() {
    const Tip& tip = kit().tip;
    if (tip.item == Rect{} || tip.shown || tip.quiet) return std::numeric_limits<double>::infinity();
    return tip.since + tip_delay - ImGui::GetTime();
}

void tip(std::string_view text, bool focused) {
    if (text.empty() || !(focused || ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))) return;
    const ImVec2 min = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    const ImGuiWindow* window = ImGui::GetCurrentWindow()->RootWindow;
    Tip& next = kit().next_tip;
    next.item = {min.x, min.y, size.x, size.y};
    next.window = {window->Pos.x, window->Pos.y, window->Size.x, window->Size.y};
    next.text.assign(text);
}

void tip_below_window(std::string_view text) {
    tip(text);
    Tip& next = kit().next_tip;
    if (next.text == text) next.item = next.window;
}

void keep_wheel() { ImGui::SetItemUsingMouseWheel(); }

void Layout::note(std::string_view name) {
    if (!listening_) return;
    const ImVec2 min = ImGui::GetItemRectMin(), size = ImGui::GetItemRectSize();
    items_.push_back({std::string(name), {min.x, min.y, size.x, size.y}, ImGui::IsItemVisible()});
}

void Layout::note(std::string_view first, std::string_view second) {
    if (listening_) note(std::string(first).append(".").append(second));
}

void Layout::place_window(std::string_view name) {
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    place(name, {at.x, at.y, size.x, size.y});
}

void Layout::place(std::string_view name, const Rect& rect) {
    if (listening_) items_.push_back({std::string(name), rect, true});
}

}  // namespace snell::ui
