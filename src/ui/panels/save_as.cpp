#include "src/ui/panels/save_as.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cfloat>
#include <cmath>

#include "parser/text/words.h"
#include "src/plan/values/numbers.h"
#include "src/ui/kit/field.h"
#include "src/ui/kit/input.h"
#include "src/ui/kit/style.h"
#include "src/ui/kit/widgets.h"
#include "src/ui/panels/state.h"

namespace snell::ui {

namespace {

struct SaveAsWords {
    const char *title, *label, *tip;
    std::string name;  // of the widgets
    const char* word = "Save";
    const char* elsewhere = nullptr;  // what is said of a name with a folder, if anything
};

// A dialog in the middle of the screen, of that width in multiples of the text height.
bool begin_dialog(const char* title, float width) {
    if (!ImGui::IsPopupOpen(title)) ImGui::OpenPopup(title);
    const ImVec2 all = ImGui::GetIO().DisplaySize;
    const float em = ImGui::GetFontSize();
    ImGui::SetNextWindowPos({all.x / 2, all.y / 2}, ImGuiCond_Always, {.5F, .5F});
    ImGui::SetNextWindowSize({std::min(width * em, all.x - em), 0});
    return ImGui::BeginPopupModal(title, nullptr,
                                  ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize);
}

void end_dialog(const SaveAs& dialog) {
    if (!dialog.open) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

void complain(const std::string& text, const std::string& name, Layout& layout) {
    ImGui::PushStyleColor(ImGuiCol_Text, palette().error_text);
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::PopStyleColor();
    layout.note(name + " error");
}

// What the dialog asks or complains of.
void questions(const SaveAs& dialog, const std::string& name, Layout& layout) {
    if (dialog.asks())
        ImGui::TextWrapped(dialog.makes ? "There is no folder %s. Make it?" : "%s exists. Replace it?",
                           shortened(dialog.existing, 30 * ImGui::GetFontSize()).c_str());
    if (!dialog.error.empty()) complain(dialog.error, name, layout);
}

// "Cancel" and, behind it at the right end, what the dialog is for. Returns true if that was pressed.
bool answered(SaveAs& dialog, const char* word, const std::string& name, Layout& layout) {
    if (dialog.asks()) word = dialog.makes ? "Make" : "Replace";
    to_right(button_width("Cancel") + button_width(word) + ImGui::GetStyle().ItemSpacing.x);
    if (button("Cancel", layout, name + " cancel") || pressed(Key::escape)) dialog.open = false;
    ImGui::SameLine();
    return button(word, layout, name + " save");
}

// The field of a name. Returns true if Enter confirms it: after a refusal once more without another name, because its
// cause may be gone.
bool name_field(const char* id, SaveAs& dialog, ImGuiInputTextFlags flags) {
    const bool refused = !dialog.error.empty() || (dialog.asks() && dialog.makes);
    const bool again = refused && kit().focus.at == ImGui::GetID(id) && !ImGui::IsAnyItemActive() &&
                       (pressed(Key::enter) || pressed(Key::keypad_enter));
    if (again) {
        ui::take(Key::enter);
        ui::take(Key::keypad_enter);
    }
    ImGui::SetNextItemWidth(-FLT_MIN);
    return text_field(id, "", dialog.file, ImGuiInputTextFlags_EnterReturnsTrue | flags) || again;
}

// Returns true when the user confirms the name.
bool save_as_window(SaveAs& dialog, const SaveAsWords& words, Layout& layout) {
    if (!dialog.open) return false;
    const bool fresh = !ImGui::IsPopupOpen(words.title);
    if (!begin_dialog(words.title, 30)) return false;
    wrapped(words.label);
    if (fresh) ImGui::SetKeyboardFocusHere();
    const bool entered = name_field("##name", dialog, ImGuiInputTextFlags_AutoSelectAll);
    layout.note(words.name + " file");
    tip(words.tip);
    if (!dialog.folder.empty()) {
        const std::string_view name = dialog.file.data();
        const bool whole = name == "~" || name.starts_with("~/") || name.starts_with('/');  // it says which folder
        const bool elsewhere = words.elsewhere && (whole || name.find('/') != name.npos);
        fitted(elsewhere ? (dialog.place.empty() ? words.elsewhere : dialog.place)
               : whole   ? ""
                         : "in " + dialog.folder,
               ImGui::GetContentRegionAvail().x, true);
        if (!whole) layout.note(words.name + " folder");
    }
    ImGui::Spacing();
    questions(dialog, words.name, layout);
    const bool now = answered(dialog, words.word, words.name, layout) || entered;
    end_dialog(dialog);
    return now;
}

}  // namespace

bool confirmed(SaveAs& dialog, bool asks, const std::string& path, bool makes) {
    const bool answered = dialog.asks() && dialog.makes == makes;
    dialog.there = asks && !answered ? dialog.file.data() : "";
    dialog.makes = makes;
    if (!dialog.there.empty()) dialog.error.clear();
    dialog.existing = utf8::printable(path.substr(path.rfind('/') + 1));
    return dialog.there.empty();
}

void open_save_as(SaveAs& dialog, const std::string& name, std::string folder) {
    dialog = {};
    dialog.open = true;
    dialog.folder = std::move(folder);
    name.copy(dialog.file.data(), dialog.file.size() - 1);
}

void save_as_windows(Memory& memory, Requests& requests, Layout& layout) {
    static const SaveAsWords scene{"Save scene as",
                                   "Save the scene with these values as",
                                   "In the scene's folder, where the scene finds its files, or with another folder",
                                   "save as",
                                   "Save",
                                   "with the files that the scene would not find there"};
    static const SaveAsWords page{"Save page", "Save a page for browsers, with these values, as",
                                  "One file that holds all files of the scene.\nRelative to the scene's folder",
                                  "save page"};
    static const SaveAsWords rung{"Write rung", "Write the scene with this rung into the folder",
                                  "Relative to the scene's folder", "write rung"};
    static const SaveAsWords created{"New scene", "Name of the new scene, which gets a folder of its own",
                                     "Letters, digits, '-' and '_'; or a path", "new scene", "Create"};
    static const SaveAsWords editor{"Set editor", "Open files with the command",
                                    "A program with its arguments, such as 'code' or 'emacsclient -n'.\nEmpty: that of "
                                    "the variables VISUAL and EDITOR, or the desktop's",
                                    "editor", "Set"};
    requests.save_as_now = save_as_window(memory.save_as, scene, layout);
    requests.save_page_now = save_as_window(memory.save_page, page, layout);
    requests.write_rung_now = save_as_window(memory.write_rung, rung, layout);
    requests.new_scene_now = save_as_window(memory.new_scene, created, layout);
    requests.set_editor_now = save_as_window(memory.set_editor, editor, layout);
    for (const SaveAs* dialog : {&memory.save_as, &memory.save_page, &memory.write_rung, &memory.new_scene,
                                 &memory.set_editor, static_cast<SaveAs*>(&memory.picture)})
        if (dialog->open && !dialog->error.empty()) memory.notice.clear();  // as in Memory::failed
}

namespace {

constexpr const char* picture_title = "Save picture";

void row(const char* name, const char* help = nullptr) {
    label(name);
    if (help) tip(help);
    if (ImGui::GetContentRegionMax().x < 14 * ImGui::GetFontSize()) return ImGui::NewLine();
    ImGui::SameLine(std::min(7 * ImGui::GetFontSize(), .35F * ImGui::GetContentRegionMax().x));
}

void whole(const char* id, double& value, double initial, Layout& layout, const char* name, double most) {
    number(id, value, ValueType::int_, initial, std::min(5 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x),
           {1, most});
    layout.note(name);
}

void set_size(PictureMemory& picture, const Rect& scene, double factor) {
    picture.width = std::max(1., std::round(scene.width * factor));
    picture.height = std::max(1., std::round(scene.height * factor));
}

// Which picture is saved, where another one is seen; "" otherwise.
std::string_view saved_picture(const Facts& facts) {
    const bool found = facts.found && !facts.found->shown.empty();
    if (facts.states)
        return found ? "of the scene as it is now, without the comparison and the found rung"
                     : "of now, without the comparison";
    return found ? "of the scene, without the found rung" : "";
}

void size_row(PictureMemory& picture, const Rect& scene, Layout& layout) {
    const double density = ImGui::GetIO().DisplayFramebufferScale.x;
    row("Size");
    whole("##width", picture.width, picture.width, layout, "picture width", picture.largest);
    follow(width_of("\u00d7") + 6 * ImGui::GetFontSize());
    ImGui::TextUnformatted("\u00d7");
    ImGui::SameLine();
    whole("##height", picture.height, picture.height, layout, "picture height", picture.largest);
    if (next_button("Window size", layout, "picture window size")) set_size(picture, scene, density);
    if (next_button("\u00d7 4", layout, "picture times 4")) set_size(picture, scene, 4 * density);
    row("Samples", "samples per pixel; more make edges smoother");
    whole("##samples", picture.samples, 4, layout, "picture samples", 64);
    follow(check_box_width("Transparent"), ImGui::GetFontSize());
    switch_box("Transparent", picture.transparent);
    tip("Leaves out the background (PNG and EXR only)");
    layout.note("picture transparent");
}

void sequence_rows(PictureMemory& picture, double time, Layout& layout) {
    if (!picture.sequence) {
        row("Time", "Time stands while this dialog is open");
        wrapped(fmt::format("{:.2f} s, as the window shows it", time));
        layout.note("picture time");
    }
    row("Sequence", "numbered pictures of a time span");
    switch_box("##sequence", picture.sequence);
    layout.note("picture sequence");
    if (!picture.sequence) return;
    row("Seconds");
    const float field = std::min(5 * ImGui::GetFontSize(), ImGui::GetContentRegionAvail().x);
    number("##from", picture.from, ValueType::float_, 0, field);
    layout.note("picture from");
    follow(width_of("to") + 6 * ImGui::GetFontSize());
    ImGui::TextUnformatted("to");
    ImGui::SameLine();
    number("##to", picture.to, ValueType::float_, 10, field);
    layout.note("picture to");
    row("Per second");
    number("##rate", picture.rate, ValueType::float_, 25, field, {1e-3, 1e5});
    layout.note("picture rate");
    if (const std::string problem = sequence_problem(picture); !problem.empty())
        return complain(problem, "sequence", layout);
    const int count = picture_count(picture);
    const std::string told =
        fmt::format("{}, the last at {:.6g} s", counted(static_cast<std::size_t>(count), "picture"),
                    picture.from + (count - 1) / picture.rate);
    follow(width_of(told));
    wrapped(told, true);
}

void answers(PictureMemory& picture, bool moves, bool entered, Requests& requests, Layout& layout) {
    questions(picture, "picture", layout);
    const bool refuses = refused() || !sequence_problem(picture).empty();
    if (button("Copy command", layout, "picture command") && !refuses) requests.picture = PictureRequest::command;
    tip(moves ? "Copies the 'snell render' command, which draws animated sliders at rest"
              : "Copies the 'snell render' command that draws the same");
    follow(button_width("Cancel") + button_width("Replace") + ImGui::GetStyle().ItemSpacing.x);
    if ((answered(picture, "Save", "picture", layout) || entered) && !refuses) requests.picture = PictureRequest::save;
}

double asked_pictures(const PictureMemory& picture) { return std::round((picture.to - picture.from) * picture.rate); }

void progress_row(const PictureMemory& picture, Requests& requests, Layout& layout) {
    const float stop = button_width("Stop") + ImGui::GetStyle().ItemSpacing.x;
    const std::string percent = fmt::format("{:.0f} %", std::floor(*picture.progress * 100));
    ImGui::ProgressBar(static_cast<float>(*picture.progress), {-stop, 0}, percent.c_str());
    ImGui::SameLine();
    if (button("Stop", layout, "picture stop") || pressed(Key::escape)) requests.picture = PictureRequest::stop;
}

}  // namespace

int picture_count(const PictureMemory& picture) {
    return picture.sequence ? static_cast<int>(std::clamp(asked_pictures(picture), 1., picture.most)) : 1;
}

std::string sequence_problem(const PictureMemory& picture) {
    if (!picture.sequence) return {};
    if (picture.to <= picture.from) return fmt::format("{:.6g} s is not after {:.6g} s", picture.to, picture.from);
    const double count = asked_pictures(picture);
    return count <= picture.most ? "" : fmt::format("{:.6g} pictures are more than {:.0f}", count, picture.most);
}

void picture_window(const Facts& facts, Memory& memory, Requests& requests, Layout& layout) {
    PictureMemory& picture = memory.picture;
    const bool fresh = !ImGui::IsPopupOpen(picture_title);
    if (!picture.open || !facts.scene || !begin_dialog(picture_title, 36)) return;
    ImGui::BeginDisabled(picture.progress.has_value());
    row("File", "The extension sets the format: .png, .bmp, .exr \u2026");
    if (fresh) ImGui::SetKeyboardFocusHere();
    // Enter saves, where it does not end the typing of a number.
    const bool free =
        !ImGui::IsAnyItemActive() && !kit().typing.id && (pressed(Key::enter) || pressed(Key::keypad_enter));
    const bool entered = name_field("##file", picture, 0) || (free && kit().focus.at == 0);
    layout.note("picture file");
    if (!picture.folder.empty()) {
        row("");
        fitted("in " + picture.folder, ImGui::GetContentRegionAvail().x, true);
        layout.note("picture folder");
        if (picture.sequence && !picture.names.empty()) {
            row("");
            fitted(picture.names, ImGui::GetContentRegionAvail().x, true);
            layout.note("picture names");
        }
    }
    if (const std::string_view which = saved_picture(facts); !which.empty()) {
        row("Picture");
        wrapped(which);
        layout.note("picture which");
    }
    size_row(picture, memory.scene, layout);
    if (facts.animated || memory.animating())
        sequence_rows(picture, memory.clock.time, layout);
    else
        picture.sequence = false;
    ImGui::EndDisabled();
    ImGui::Spacing();
    if (picture.progress)
        progress_row(picture, requests, layout);
    else
        answers(picture, picture.sequence && memory.animating(), entered, requests, layout);
    end_dialog(picture);
}

}  // namespace snell::ui
