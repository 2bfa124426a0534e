#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "parser/text/words.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/kit.h"
#include "src/ui/kit/text.h"
#include "src/ui/panels/panels.h"

namespace snell::ui {

namespace {

constexpr ImGuiWindowFlags overlay = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                     ImGuiWindowFlags_NoNav;

std::size_t count(std::span<const Problem> problems, Severity severity) {
    return static_cast<std::size_t>(std::count_if(problems.begin(), problems.end(),
                                                  [&](const Problem& p) { return p.finding.severity == severity; }));
}

// Underlines the place, such as "paint.frag:3:12", at the beginning of the line that was just drawn.
Rect underline(const Finding& finding) {
    const ImVec2 from = ImGui::GetItemRectMin();
    const float width = std::min(width_of(place_text(finding)), ImGui::GetItemRectSize().x);
    const float y = from.y + ImGui::GetTextLineHeight() - 1;
    ImGui::GetWindowDrawList()->AddLine({from.x, y}, {from.x + width, y}, ImGui::GetColorU32(palette().link),
                                        std::max(1.0F, ImGui::GetFontSize() / 14));
    return {from.x, y, width, 1};
}

// Draws source and carets without wrapping, because the carets must stay under what they mark.
void show_source(const Finding& finding) {
    const std::string left = margin(finding.at->line);
    const float column = ImGui::CalcTextSize("M").x;
    const auto columns = static_cast<std::size_t>(std::max(1.0F, ImGui::GetContentRegionAvail().x / column));
    const MarkedLine line = excerpt(*finding.source, columns - std::min(columns, left.size()));
    ImGui::TextUnformatted((left + line.text).c_str());
    ImGui::TextUnformatted((std::string(left.size() - 2, ' ') + "| " + carets(line)).c_str());
}

void show_details(const Finding& finding) {
    if (finding.source) show_source(finding);
    if (!finding.also.empty()) wrapped("   " + finding.also);
    if (!finding.help.empty()) wrapped("   help: " + finding.help);
    for (const Finding& note : finding.notes) {
        wrapped(headline(note));
        show_details(note);
    }
}

// The first line is the message, in its severity's colour, and a link to the editor; the rest shows the source.
void show(const Facts& facts, const Problem& problem, std::size_t number, Requests& requests, Layout& layout) {
    const Finding& finding = problem.finding;
    const Palette& colors = palette();
    ImGui::PushStyleColor(ImGuiCol_Text, finding.severity == Severity::error ? colors.error : colors.warning);
    wrapped(headline(finding));
    ImGui::PopStyleColor();
    if (!problem.place.file.empty()) {
        const std::string name = fmt::format("problem.{}", number);
        layout.note(name);
        layout.place(name + ".place", underline(finding));
        const bool keys = or_keys(false, ImGui::GetID(name.c_str()));
        if (edit_link(facts, problem.place, true) || keys) requests.edit = problem.place;
    }
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0});
    show_details(finding);
    ImGui::PopStyleVar();
    ImGui::Spacing();
}

void list(const Facts& facts, Severity severity, const Fonts& fonts, Requests& requests, Layout& layout) {
    constexpr std::size_t most = 30;  // more could not be read at once, and every line costs time in every frame
    std::size_t shown = 0;
    ImGui::PushFont(fonts.mono);
    for (std::size_t i = 0; i < facts.problems.size(); ++i)
        if (facts.problems[i].finding.severity == severity && shown++ < most)
            show(facts, facts.problems[i], i, requests, layout);
    if (shown > most) ImGui::TextUnformatted(fmt::format("\u2026 and {} more", shown - most).c_str());
    ImGui::PopFont();
}

void push_dark() {
    const Palette& colors = palette();
    ImGui::PushStyleColor(ImGuiCol_WindowBg, colors.problem_background);
    ImGui::PushStyleColor(ImGuiCol_Text, colors.problem_text);
    ImGui::PushStyleColor(ImGuiCol_Button, colors.problem_button);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, colors.problem_hovered);
    ImGui::PushStyleColor(ImGuiCol_ButtonActive, colors.problem_pressed);
    ImGui::PushStyleColor(ImGuiCol_Border, colors.problem_border);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().FrameRounding * 1.5F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
}

void pop_dark() {
    ImGui::PopStyleVar(2);
    ImGui::PopStyleColor(6);
}

bool right_button(const char* text, Layout& layout, std::string_view name) {
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - button_width(text));
    return button(text, layout, name);
}

constexpr float most_problems = .9F;  // of the picture's height

// Below the list, by which the user sizes it. Returns its height.
float problems_grip(const Rect& scene, float bottom, Memory& memory, Layout& layout) {
    const float grip = std::round(ImGui::GetFontSize() * .5F), margin = ImGui::GetStyle().WindowPadding.x;
    ImGui::SetNextWindowPos({scene.x + margin, bottom});
    ImGui::SetNextWindowSize({scene.width - 2 * margin, grip});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    if (ImGui::Begin("##problems grip", nullptr,
                     (overlay & ~ImGuiWindowFlags_NoInputs) | ImGuiWindowFlags_NoBackground)) {
        ImGui::InvisibleButton("##grip", {std::max(scene.width - 2 * margin, 1.0F), grip});
        layout.note("problems.grip");
        const bool held = ImGui::IsItemActive();
        if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
        if (held)
            memory.problems_height = std::clamp(
                (ImGui::GetIO().MousePos.y - scene.y - margin) / std::max(scene.height, 1.0F), .1F, most_problems);
        const float middle = scene.x + scene.width / 2, reach = 1.5F * ImGui::GetFontSize(), y = bottom + grip / 2;
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.AddRectFilled({middle - 1.2F * reach, bottom}, {middle + 1.2F * reach, bottom + grip},
                           ImGui::GetColorU32(palette().problem_background), ImGui::GetStyle().FrameRounding,
                           ImDrawFlags_RoundCornersBottom);
        list.AddLine({middle - reach, y}, {middle + reach, y}, ImGui::GetColorU32(palette().problem_text), 2);
    }
    ImGui::End();
    ImGui::PopStyleVar(3);
    return grip;
}

// Shows all errors, with the warnings on request, or all warnings. Returns where it ends.
float problems_window(const Facts& facts, Severity severity, const Rect& scene, const Fonts& fonts, Memory& memory,
                      Requests& requests, Layout& layout) {
    const bool errors = severity == Severity::error;
    const std::size_t warnings = count(facts.problems, Severity::warning);
    const float margin = ImGui::GetStyle().WindowPadding.x, width = scene.width - 2 * margin;
    // The window has the size of its contents in the last frame, limited to the picture.
    ImGui::SetNextWindowPos({scene.x + margin, scene.y + margin});
    // In the lowest windows, too, something is read below the title.
    const float least = std::min(5 * ImGui::GetFontSize(), scene.height / 2);
    const float most = std::max({scene.height * memory.problems_height, least, 1.0F});
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, most});
    if (ImGui::Begin(errors ? "##problems" : "##warnings", nullptr,
                     (overlay & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::AlignTextToFramePadding();
        std::string title = counted(count(facts.problems, severity), name(severity));
        if (errors && !facts.stale && !facts.failed_rungs.empty())
            title = fmt::format("{}: {} \u2014 the last good picture is shown", facts.failed_rungs, title);
        if (errors && facts.stale)
            title += facts.incomplete ? " \u2014 the picture shows an earlier version, which had errors, too"
                                      : " \u2014 the picture shows the last version without errors";
        fitted(title, ImGui::GetContentRegionAvail().x - button_width("Hide") - ImGui::GetStyle().ItemSpacing.x);
        if (right_button("Hide", layout, "problems.hide")) {
            if (errors)
                memory.problems_hidden = true;
            else
                memory.warnings_open = false;
        }
        list(facts, severity, fonts, requests, layout);
        if (errors && warnings > 0) {
            const char* arrow = memory.warnings_open ? " \u25B4" : " \u25BE";
            if (or_keys(ImGui::SmallButton((counted(warnings, "warning") + arrow).c_str())))
                memory.warnings_open = !memory.warnings_open;
            layout.note("problems.warnings");
            if (memory.warnings_open) list(facts, Severity::warning, fonts, requests, layout);
        }
        layout.place_window("problems.panel");
    }
    const float bottom = ImGui::GetWindowPos().y + ImGui::GetWindowHeight();
    const bool cut = ImGui::GetScrollMaxY() > 0 || memory.problems_height != usual_problems;
    ImGui::End();
    return cut ? bottom + problems_grip(scene, bottom, memory, layout) : bottom;
}

bool answering() { return pressed(Key::enter) || pressed(Key::keypad_enter) || pressed(Key::space); }

// Notes where the notice that is being drawn stands. A press on it is too early if it may have happened within half a
// second of when the notice came there, by a key or under a mouse that has hardly moved since: the second one of two
// for the notice that stood there before. However long a picture takes, a press lies between two looks for events.
void stand(std::string_view text, NoticeMemory& memory) {
    constexpr double until_seen = .5;  // seconds
    const ImGuiIO& io = ImGui::GetIO();
    const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    const Rect box{at.x, at.y, size.x, size.y};
    auto stood = std::find_if(memory.stood.begin(), memory.stood.end(),
                              [&](const NoticeMemory::Stood& other) { return other.text == text; });
    if (stood == memory.stood.end()) stood = memory.stood.insert(stood, {std::string(text), {}, 0, {}, false});
    stood->drawn = true;
    if (stood->box != box) {
        stood->box = box;
        stood->since = ImGui::GetTime();
        stood->mouse = {io.MousePos.x, io.MousePos.y};
    }
    const bool soon = ImGui::GetTime() - kit().late < stood->since + until_seen;
    memory.early_key = soon && answering();
    if (!ImGui::IsMouseClicked(ImGuiMouseButton_Left) || !box.contains(io.MousePos.x, io.MousePos.y)) return;
    const bool moved = std::hypot(io.MousePos.x - stood->mouse.x, io.MousePos.y - stood->mouse.y) >
                       static_cast<double>(io.MouseDoubleClickMaxDist);
    memory.early = soon && !moved;
}

// Forgets the notices that are gone. Before any is drawn, no press is too early.
void begin_notices(NoticeMemory& memory) {
    std::erase_if(memory.stood, [](NoticeMemory::Stood& stood) { return !std::exchange(stood.drawn, false); });
    memory.early &= !ImGui::IsMouseClicked(ImGuiMouseButton_Left);
}

// True while a key, or the release of a press, that came too early must not act.
bool too_early(const NoticeMemory& memory) {
    return memory.early_key || (memory.early && ImGui::IsMouseReleased(ImGuiMouseButton_Left));
}

// For a line, and below it the buttons.
bool has_notice_room(float bottom, const Rect& scene) { return bottom - scene.y >= 5.5F * ImGui::GetFontSize(); }
float notice_gap() { return ImGui::GetStyle().WindowPadding.x * .5F; }

// Shows a text above `bottom`, which moves up by its height, and beside it what `buttons` draws.
template <typename Buttons>
void message_box(std::string_view text, const ImVec4& color, int index, const Rect& scene, float& bottom,
                 float buttons_width, NoticeMemory& memory, const Buttons& buttons) {
    const float margin = ImGui::GetStyle().WindowPadding.x;
    if (!has_notice_room(bottom, scene)) return;  // there is once those below it are answered
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, ImGui::GetStyle().FrameRounding * 1.5F);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1);
    ImGui::SetNextWindowPos({scene.x + margin, bottom}, ImGuiCond_Always, {0, 1});
    const float width = std::min(scene.width - 2 * margin, 30 * ImGui::GetFontSize());
    const float room = bottom - scene.y - margin;
    ImGui::SetNextWindowSizeConstraints({width, 0}, {width, std::max(room, 1.0F)});
    if (ImGui::Begin(fmt::format("##message{}", index).c_str(), nullptr,
                     (overlay & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize)) {
        // What does not fit scrolls, so that the buttons are seen.
        const float wrap = width - buttons_width - 3 * margin;
        const float height = ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, wrap).y;
        float& below = *ImGui::GetStateStorage()->GetFloatRef(ImGui::GetID("below"));
        const float least = ImGui::GetFrameHeight(), line = ImGui::GetTextLineHeight();
        float rest = std::max(room - below - 2 * ImGui::GetStyle().WindowPadding.y, least);
        const bool scrolls = height > rest && below > 0;
        if (scrolls) rest = std::max(std::floor(rest / line), 1.F) * line;  // a line that is seen is seen whole
        if (scrolls) ImGui::BeginChild("text", {wrap + margin, rest});
        if (!scrolls) ImGui::AlignTextToFramePadding();
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + wrap);
        ImGui::PushStyleColor(ImGuiCol_Text, color);
        ImGui::TextUnformatted(text.data(), text.data() + text.size());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
        if (scrolls) ImGui::EndChild();
        const float bottom_of_text = ImGui::GetItemRectMax().y;
        stand(text, memory);
        buttons();
        below = ImGui::GetCursorScreenPos().y - bottom_of_text;
    }
    bottom -= ImGui::GetWindowHeight() + notice_gap();
    ImGui::End();
    ImGui::PopStyleVar(2);
}

// True if the user goes on: a key that does not lead to a notice's button, or a press that is not on one.
bool goes_on(const NoticeMemory& memory) {
    const ImGuiIO& io = ImGui::GetIO();
    const auto clicks = [](int button) { return ImGui::IsMouseClicked(button); };
    const bool press = clicks(ImGuiMouseButton_Left) || clicks(ImGuiMouseButton_Right);
    if (press)
        return std::none_of(memory.stood.begin(), memory.stood.end(), [&](const NoticeMemory::Stood& stood) {
            return stood.box.contains(io.MousePos.x, io.MousePos.y);
        });
    return any_pressed() && !answering() && !pressed(Key::tab);
}

using Remedy = Failure::Remedy;

bool of_saving(Remedy remedy) {
    return remedy == Remedy::reload || remedy == Remedy::save || remedy == Remedy::save_as || remedy == Remedy::add;
}

// True if both are of the same request, or say the same.
bool same(const Failure& a, const Failure& b) {
    if (of_saving(a.remedy) && of_saving(b.remedy)) return true;
    if (a.remedy != b.remedy) return a.text == b.text && a.snapshot == b.snapshot;
    if (a.remedy == Remedy::none || a.remedy == Remedy::editor) return a.text == b.text;
    return a.remedy == Remedy::absent || a.remedy == Remedy::page ||
           (a.place.file == b.place.file && a.snapshot == b.snapshot);
}

// What the user can do about it, as buttons. Returns true if one was pressed. `name` is that of the failure.
bool remedies(const Failure& failure, const std::string& name, Memory& memory, Requests& requests, Layout& layout) {
    const Remedy remedy = failure.remedy;
    bool chosen = false, first = true;
    const auto offer = [&](const char* text, const char* what, auto&& act) {
        const std::string whole = name + what;
        const bool pressed =
            std::exchange(first, false) ? button(text, layout, whole) : next_button(text, layout, whole);
        if (!pressed || too_early(memory.notices)) return;
        act();
        chosen = true;
    };
    if (remedy == Remedy::reload) offer("Reload", ".reload", [&] { requests.reload = true; });
    if (remedy == Remedy::save) offer("Try again", ".again", [&] { requests.save = true; });
    if (of_saving(remedy) && remedy != Remedy::add)
        offer("Save as\u2026", ".save as", [&] { requests.save_as = true; });
    if (remedy == Remedy::store)
        offer("Try again", ".again", [&] {
            requests.store_snapshot = failure.snapshot;
            requests.values = failure.values;
        });
    if (remedy == Remedy::recall) offer("Try again", ".again", [&] { requests.restore_snapshot = failure.snapshot; });
    if (remedy == Remedy::absent) offer("Store it", ".store", [&] { requests.store_snapshot = failure.snapshot; });
    if (remedy == Remedy::open)
        offer("Open\u2026", ".open", [&] {
            open_browser({}, memory, requests);
            failure.place.file.copy(memory.browser.typed.data(), memory.browser.typed.size() - 1);
        });
    if (remedy != Remedy::editor) return chosen;
    offer("Set editor\u2026", ".editor", [&] { requests.set_editor = true; });
    if (!failure.place.file.empty()) offer("Try again", ".again", [&] { requests.edit = failure.place; });
    return chosen;
}

// Draws the latest failures, the last one below the others, and how many more there are.
void failure_boxes(const Rect& scene, float& bottom, Memory& memory, Requests& requests, Layout& layout) {
    constexpr std::size_t most = 3;  // so that some of the picture is seen
    std::vector<Failure>& open = memory.failures.open;
    std::optional<std::size_t> done;
    const std::size_t shown = std::min(open.size(), most);
    for (std::size_t i = 0; i < shown; ++i) {
        const std::size_t at = open.size() - 1 - i;
        const std::string name = i == 0 ? "failure" : fmt::format("failure {}", i + 1);
        const std::size_t older = open.size() - 1 - i;
        message_box(open[at].text, palette().error_text, -static_cast<int>(i), scene, bottom, button_width("OK"),
                    memory.notices, [&] {
                        const bool read = right_button("OK", layout, name + ".ok") && !too_early(memory.notices);
                        if (remedies(open[at], name, memory, requests, layout) || read) done = at;
                        const bool last =
                            i + 1 == shown || !has_notice_room(ImGui::GetWindowPos().y - notice_gap(), scene);
                        if (!last || older == 0) return;
                        const std::string more = fmt::format("and {} more", older);
                        follow(width_of(more));
                        wrapped(more, true);
                        layout.note("failure.more");
                    });
    }
    if (done) open.erase(open.begin() + static_cast<std::ptrdiff_t>(*done));
}

// The files were read again, but a scene that is gone only in vain. What was to be saved still is not, but can be now.
void reread(Failure& failure, const Facts& facts) {
    const bool again = failure.remedy == Remedy::reload || (failure.remedy == Remedy::save_as && !facts.stale);
    if (!again) return;
    failure.remedy = Remedy::save;
    const std::size_t name = std::min(failure.text.find(" has changed since"), failure.text.find(" is gone"));
    if (name != failure.text.npos) failure.text = failure.text.substr(0, name) + " is read again now: try again";
}

// True if what could not be done has become needless.
bool mended(const Failure& failure, const Facts& facts) {
    if (failure.remedy == Remedy::absent) return facts.snapshots[static_cast<std::size_t>(failure.snapshot)];
    return (failure.remedy == Remedy::save || failure.remedy == Remedy::add) && !facts.changed;
}

}  // namespace

void Failures::add(Failure failure) {
    std::erase_if(open, [&](const Failure& other) { return same(other, failure); });
    open.push_back(std::move(failure));
}

void Failures::done(Remedy remedy, int snapshot) {
    std::erase_if(open, [&](const Failure& other) {
        return other.snapshot == snapshot && (other.remedy == remedy || (of_saving(remedy) && of_saving(other.remedy)));
    });
}

void Failures::exchanged(std::string_view said) {
    constexpr std::string_view save = "save to ", snapshot = "snapshot ";
    const std::string_view step = said.substr(std::min(said.size(), said.find(' ') + 1));
    if (!step.starts_with(save) && !step.starts_with(snapshot)) return;
    std::vector<std::string_view> files{".snapshots.json"};
    if (step.starts_with(save)) files = split(step.substr(save.size()));
    std::erase_if(open, [&](const Failure& failure) {
        const bool of_step = failure.text.starts_with("not undone: ") || failure.text.starts_with("not redone: ");
        return of_step && std::any_of(files.begin(), files.end(), [&](std::string_view file) {
                   return failure.text.find(file) != failure.text.npos;
               });
    });
}

void Failures::rewrite(const std::function<std::string(const std::string& text)>& words) {
    for (Failure& failure : std::exchange(open, {})) {
        failure.text = words(failure.text);
        add(std::move(failure));
    }
}

void Failures::enter(const std::string& other) {
    std::erase_if(
        open, [](const Failure& failure) { return failure.remedy == Remedy::open || failure.remedy == Remedy::sharp; });
    const auto of_scene = std::stable_partition(open.begin(), open.end(), [](const Failure& failure) {
        return failure.remedy == Remedy::none || failure.remedy == Remedy::page || failure.remedy == Remedy::editor;
    });
    left[scene].assign(of_scene, open.end());
    open.erase(of_scene, open.end());
    scene = other;
    std::vector<Failure>& again = left[scene];
    open.insert(open.begin(), again.begin(), again.end());
    left.erase(scene);
}

float problems_panel(const Facts& facts, const Rect& picture, const Fonts& fonts, Memory& memory, Requests& requests,
                     Layout& layout) {
    // Problems that were hidden are shown again after the files were read again.
    const bool read_again = memory.revision != facts.revision;
    if (read_again) {
        memory.revision = facts.revision;
        memory.problems_hidden = false;
    }
    for (Failure& failure : memory.failures.open)
        if (read_again) reread(failure, facts);
    std::erase_if(memory.failures.open, [&](const Failure& failure) { return mended(failure, facts); });
    Rect scene = with_room(picture);
    if (memory.below > 0) scene.height = std::max(1.0F, ImGui::GetIO().DisplaySize.y - memory.below);
    float bottom = scene.y;
    push_dark();
    if (count(facts.problems, Severity::error) > 0) {
        if (!memory.problems_hidden)
            bottom = problems_window(facts, Severity::error, scene, fonts, memory, requests, layout);
    } else if (memory.warnings_open && count(facts.problems, Severity::warning) > 0) {
        bottom = problems_window(facts, Severity::warning, scene, fonts, memory, requests, layout);
    }
    pop_dark();
    return bottom;
}

float notices(const Facts& facts, const Rect& free, Memory& memory, Requests& requests, Layout& layout) {
    Rect scene = with_room(free);
    const float end = free.y + free.height, first = end - ImGui::GetStyle().WindowPadding.x;
    // Where they need the panel's room, some of the panel is seen above them. One of them is seen in any case, but
    // where errors need that room as well: these are read, and hidden, first.
    const bool narrow = !has_room(free);
    if (narrow) scene.y += scene.height / 4;
    if (!narrow || free.y <= 0) scene.y = std::max(0.0F, std::min(scene.y, end - 8 * ImGui::GetFontSize()));
    float bottom = first;
    int index = 0;
    begin_notices(memory.notices);
    // That there is no such snapshot is a remark on what was done last.
    if (goes_on(memory.notices))
        std::erase_if(memory.failures.open, [](const Failure& one) { return one.remedy == Remedy::absent; });
    failure_boxes(scene, bottom, memory, requests, layout);
    std::span<const Message> messages;
    if (facts.scene && memory.panel) messages = facts.scene->messages;
    for (const Message& message : messages) {
        if (memory.dismissed.contains(message.text)) continue;
        message_box(message.text, ImGui::GetStyleColorVec4(ImGuiCol_Text), ++index, scene, bottom, button_width("OK"),
                    memory.notices, [&] {
                        if (right_button("OK", layout, "message.ok") && !too_early(memory.notices))
                            memory.dismissed.insert(message.text);
                    });
    }
    return bottom < first ? bottom : end;
}

}  // namespace snell::ui
