// Every panel, as large and as full as scenes make it.
#pragma once

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "src/runtime/inspect.h"
#include "tests/screens.h"
#include "tests/ui/found_rungs.h"
#include "tests/ui/paint.h"
#include "tests/ui/screen.h"

namespace snell::ui {

inline const std::string long_name = "uRefractiveIndexOfTheInnermostGlassBallBehindTheSecondWall";
inline const std::string long_path =
    "/home/students/2026/spring/computer-graphics/assignment-07-refraction/submissions/a very long folder name/" +
    long_name + ".frag";

inline void keep_picture(const std::string& name) {
    const std::string folder = screens_folder();
    if (folder.empty()) return;
    EXPECT_EQ(content::write_image(folder + "/" + name + ".png", paint(*ImGui::GetDrawData())), "");
}

class Screens;

// A row for each panel: what must be there, and a widget that must be in sight.
struct Panel {
    const char* name;
    const char* widget;
    void (Screens::*prepare)();
};

class Screens : public UiTest, public ::testing::WithParamInterface<Panel> {
public:
    void many_sliders() {
        for (int i = 0; i < 60; ++i) add_slider("uParameterOfNumber" + std::to_string(i), 0, i, 60);
    }
    void no_sliders() {}
    void programs() {
        add_slider("uEta", .1, 1.1, 5);
        add_slider(long_name, 0, -123456.789, 1e6);
        Control& box = add_slider("uOn", 0, 1, 1, ValueType::bool_);
        box.widget = Widget::check_box;
        Control& long_box = add_slider(long_name + "On", 0, 1, 1, ValueType::bool_);
        long_box.widget = Widget::check_box;
        color("uColor", 3);
        color("uColorWithAlpha" + long_name, 4);
        Control& idle = add_slider("uNotUsed", 0, 1, 2);
        idle.active = false;
        Control& idle_box = add_slider("uNotUsedEither", 0, 1, 2, ValueType::bool_);
        idle_box.widget = Widget::check_box;
        idle_box.active = false;
        Control& vector = add_slider("uOffset" + long_name, -1, .25, 1);
        vector.components = 4;
        vector.value = vector.initial = {.25, -123.456, 1e-7, -9e30};
        vector.widget = Widget::none;
        vector.listed = false;
        add_program(long_name + "Program");
        add_slider("uLast", 0, 1, 2);
    }
    void forty_sliders() {
        for (int i = 1; i <= 40; ++i) add_slider("uValue" + std::to_string(i), 0, i * .025, 1);
    }
    void ladders() {
        ladder("FRESNEL", {"f0", "schlick", "exact"});
        ladder("A_LADDER_WITH_QUITE_A_LONG_NAME_INDEED", {"a rung with a name that is longer still", "exact"});
        programs();
    }
    void accuracy() {
        memory_.tab = Tab::tools;
        ladder("FRESNEL", {"f0", "schlick", "exact"});
        accuracy_.samples = 7;
        accuracy_.wanted = 16;
        accuracy_.clock = "CPU time of the process";
        accuracy_.error = .0123;
        accuracy_.nonfinite = 12345;
        accuracy_.points = {{.name = "f0", .rung = 0, .milliseconds = 1.9, .low = 1.8, .high = 2, .error = .05},
                            {.name = "schlick", .rung = 1, .milliseconds = 2, .error = .01, .chosen = true},
                            {.name = "exact", .rung = 2, .milliseconds = 3, .error = 0, .reference = true}};
        accuracy_.remark = "the machine was too busy: the same rung took 2.0 and 3.1 ms";
        facts_.accuracy = &accuracy_;
        memory_.accuracy.open = true;
    }
    void two_states() {
        programs();
        states_ = {{{"now", "now"}, {"snapshot 1", "snapshot 1"}},
                   {{{"now", "now: uIndex 1.33, uMix 0 and 12 more"}, {"snapshot 1", "snapshot 1: 2.42, 1"}}}};
        facts_.states = &states_;
        memory_.accuracy.show = AccuracyMemory::Show::split;
        scene_.messages.push_back({"Drag uEta until the ball is gone.", {}});
    }
    void state_menu() {
        two_states();
        for (const char* name : {"now", "saved", "opened", "snapshot 1", "reference", "FRESNEL=schlick"})
            states_.choices.push_back({name, name});
        states_.example = "values, such as uRefractiveIndex=2.42";
        menu_ = "accuracy.right";
    }
    void heat_map() {
        two_states();
        memory_.accuracy.show = AccuracyMemory::Show::heat;
    }
    void blank_states() {
        two_states();
        states_.sides[0] = {"reference", "reference, last good picture: the shader does not compile", true};
        states_.sides[1] = {"TINT=dark", "TINT=dark: cannot read " + long_path, true, true};
    }
    void marked_states() {
        pixels();
        two_states();
        pixels_.flags = {{"left: snapshot 1", flags_}, {"right: uRefractiveIndex=2.42 " + long_name, flags_}};
    }
    void found() {
        accuracy();
        accuracy_.of_scene = true;
        sought_ = many_found_rungs(long_name, long_path);
        facts_.found = &sought_;
    }
    void found_untried() {
        found();
        scene_.ladders.clear();
        controls_.rungs.clear();
        facts_.accuracy = nullptr;
        sought_ = untried_rungs(long_name, long_path);
        unfolded_ = {"found.untried"};
    }
    void clock() {
        facts_.animated = facts_.timed = true;
        memory_.clock.time = 123456.78;
        facts_.time = 123456.78;
        add_slider("uEta", .1, 1.1, 5);
    }
    void values() {
        programs();
        memory_.labels = true;
    }
    void errors() {
        add_slider("uEta", .1, 1.1, 5);
        const auto add = [&](Severity severity, const std::string& file, const std::string& what) {
            const std::string source =
                "    gl_FragColor = vec4(uRed, .4 + nonsense, .2, 1.); // and a comment that "
                "goes on until the line has more columns than the window, and then some more";
            problems_.push_back({{.severity = severity,
                                  .file = file,
                                  .at = Position{12, 38},
                                  .message = what,
                                  .source = MarkedLine{source, 37, 45},
                                  .help = "did you mean 'nonSense'? It is declared in line 3, and what is more, "
                                          "nobody ever wrote anything that would set it"},
                                 {file, 12, 38}});
        };
        add(Severity::error, "scene/paint.frag", "'nonsense' undeclared [shader-error]");
        add(Severity::error, long_path, "unknown command 'Sphare' [unknown-command]");
        add(Severity::warning, "scene/scene.glib", "'uUnused' is not used by the program [uniform-unused]");
        facts_.problems = problems_;
        facts_.stale = true;
        memory_.warnings_open = true;
    }
    void messages() {
        add_slider("uEta", .1, 1.1, 5);
        scene_.messages.push_back({"Drag uEta until the ball is gone.", {}});
        scene_.messages.push_back(
            {"A message that has to say so much that no window can show all of it in one line, "
             "and so it goes on in the next one, with aVeryLongWord" +
                 long_name + long_name,
             {}});
    }
    void everything() {
        two_states();
        errors();
        failures();
    }
    void first_picture() {
        programs();
        facts_.first_picture = true;
        facts_.longest_picture = 60;
    }
    void failures() {
        messages();
        using Remedy = Failure::Remedy;
        facts_.changed = true;
        for (int number = 1; number <= 4; ++number)
            memory_.failures.add({"snapshot is not stored: no space left", Remedy::store, {}, number});
        memory_.failures.add({long_path + " ended with status 4", Remedy::editor, {"/a.frag", 1, 1}});
        memory_.failures.add({"not saved: room.glib: no space left on the device", Remedy::save});
    }
    void states_and_a_notice() {
        add_slider("uEta", .1, 1.1, 5);
        const Tab tab = memory_.tab;
        two_states();
        memory_.tab = tab;
        facts_.nan = "NaN in under 1 %: N shows it";
        memory_.failures.add({"there is no snapshot 5. Ctrl+5 stores one", Failure::Remedy::absent, {}, 5});
    }
    void costs() {
        memory_.tab = Tab::tools;
        using Kind = Explanation::Kind;
        explanation_.redraw = "in every frame: its programs read the time";
        explanation_.paid = {{Kind::image, "Texture2D 6 " + long_path, "sampled by uWall", {}, 4 << 20, 12.5, {}},
                             {Kind::program, long_name, "drawn", {}, 0, 22.5, {}},
                             {Kind::pass, "the window", "shown", {}, 0, {}, {0, 1, 2}}};
        explanation_.unpaid = {{"Noise3", "no drawn program reads it"}};
        explanation_.unused = {{"Texture2D 7 " + long_path, "no drawn program samples it", {}}};
        explanation_.switched_off = {{0, "Glass", "uMix", "0", {}, {{Kind::image, "Texture2D 8 " + long_path}}, {}}};
        facts_.explanation = &explanation_;
        memory_.open.emplace("Costs");
        unfolded_ = {"costs.Images",     "costs.Programs",           "costs.Passes", "costs.Switched off by values",
                     "costs.Not loaded", "costs.Declared but unused"};
    }
    void files() {
        memory_.tab = Tab::tools;
        facts_.files = files_;
        facts_.editor = "/usr/local/bin/an-editor-with-a-long-name --and --many arguments that go on and on";
        memory_.open.emplace("Files");
    }
    void window() {
        memory_.tab = Tab::tools;
        memory_.open.emplace("Window");
    }
    void browser() {
        listing_.folder = "/home/students/2026/spring/computer-graphics/assignment-07-refraction/submissions";
        for (const char* folder : {"a folder", "another"})
            listing_.entries.push_back({folder, std::string("/") + folder, true, "", "2026-01-01 12:00"});
        for (int i = 1; i <= 30; ++i)
            listing_.entries.push_back(
                {"scene" + std::to_string(i) + ".glib", "/s", false, "12.5 kB", "2026-01-01 12:00"});
        listing_.entries.insert(listing_.entries.begin() + 2,
                                {long_name + long_name + ".glib", "/l", false, "999.9 MB", "2026-01-01 12:00"});
        recent_ = {{"room.glib", "~/scenes", "/home/ann/scenes/room.glib", {7, 1.5F}},
                   {long_name + ".glib", long_path, long_path, {7, .5F}},
                   {"new.glib", "/", "/new.glib"}};
        facts_.recent = recent_;
        facts_.listing = &listing_;
        memory_.browser.open = true;
    }
    void refused_folder() {
        browser();
        listing_.entries.clear();
        listing_.error = listing_.folder + ": Permission denied";
    }
    void view() {
        memory_.tab = Tab::tools;
        add_slider("uEta", .1, 1.1, 5);
        memory_.open.emplace("View");
        facts_.object = long_name;
        hold_object(memory_.hold, 0);
        memory_.hold.picking = true;
        view_.objects[0] = {-123.4567, 59.5, .001, -12.345678, 123.456, -.0123, 179.5};
    }
    void pixels() {
        memory_.tab = Tab::tools;
        flags_.pixels = {0, 1234567, 1234567, 1234567, 1234567};
        pixels_.flags = {{"", flags_}};
        facts_.pixels = &pixels_;
        memory_.pixels.flags = true;
        memory_.open.emplace("Pixels");
    }
    void marked_errors() {
        pixels();
        errors();
    }
    void inspected() {
        found_.x = 1234;
        found_.y = 1234;
        found_.radius = 4;
        found_.rgba.assign(4 * 81, -1.234567e-30F);
        found_.rgba[4 * 40] = std::numeric_limits<float>::quiet_NaN();
        found_.inside.assign(81, 1);
        found_.depth = .987654321;
        found_.distance = 1234.5678;
        pixels_.inspection = &found_;
        pixels_.at = "pixel 1234, 1234";
        pixels_.half = "right: before the last edit";
        pixels_.statement = "Sphere 1.23456 50 50 # the ball in the middle, as large as it was before";
        pixels_.place = long_path + ":1234";
        facts_.pixels = &pixels_;
        pointed_ = true;
    }
    void textures() {
        memory_.tab = Tab::tools;
        textures_rows_ = {{"Texture2D 6 " + long_name + ".bmp", "16384 x 16384", "RGBA16F, 15 levels",
                           "read by uPicture of " + long_name, true},
                          {"Noise3", "64 x 64 x 64", "RGBA8", "read by Noise3 of Glass", true},
                          {"CubeMap 7 " + long_path, "", "", "no program for these values reads it", false}};
        textures_.rows = textures_rows_;
        textures_.width = textures_.height = 16384;
        textures_.levels = 15;
        textures_.slices = 64;
        textures_.floats = true;
        flags_.pixels = {0, 1234567, 1234567, 1234567, 1234567};
        textures_.texel.flags = {{"", flags_}};
        facts_.textures = &textures_;
        memory_.pixels.flags = true;
        memory_.open.emplace("Textures");
    }
    void frame_cost() {
        memory_.tab = Tab::tools;
        for (int i = 0; i < 100; ++i) frames_.push_back(16 + 3 * std::sin(static_cast<float>(i)));
        rows_ = {{"the window", "", 12.34, false},
                 {"Sphere 1.23456 50 50 # the ball in the middle", "scene.glib:12", 1.23, true},
                 {long_name, long_path + ":1234", 123.4, true}};
        frame_cost_ = {frames_, 16, 19, rows_, rows_, "with a wait after every draw, which makes draws take longer",
                       12.3,    .3};
        facts_.frame_cost = &frame_cost_;
        memory_.open.emplace("Frame cost");
    }
    void picture() {
        facts_.animated = facts_.timed = true;
        memory_.picture.open = true;
        std::ranges::copy(std::string("pictures/room.png"), memory_.picture.file.begin());
        memory_.picture.width = memory_.picture.height = memory_.picture.largest = 16384;
        memory_.picture.most = 1'000'000;
        memory_.picture.sequence = memory_.picture.transparent = true;
        memory_.picture.error = long_path + ": there is no such folder, so nothing was written into it";
    }
    void save_as() {
        open_save_as(memory_.save_as, "room.glib");
        memory_.save_as.there = "room.glib";
        memory_.save_as.existing = long_path;
        memory_.save_as.error = "the scene would not find " + long_path + ", " + long_path + " from there";
    }
    void write_rung() {
        found();
        open_save_as(memory_.write_rung, "room-rung-3");
        memory_.write_rung.error = long_path + ": there is no such folder";
    }
    void save_page() {
        open_save_as(memory_.save_page, "room.html");
        memory_.save_page.error = "another page is being saved";
    }
    // With what is below it in sight, each of the toolbar's menus.
    void open_menu() {
        programs();
        for (int i = 1; i <= 12; ++i) recent_.push_back({"scene" + std::to_string(i) + ".glib", "~/scenes", "/s"});
        recent_[3].name = long_name + ".glib";
        facts_.recent = recent_;
        menu_ = "menu.open";
    }
    void save_menu() {
        programs();
        facts_.animated = facts_.timed = true;
        menu_ = "menu.save";
    }
    void view_menu() {
        programs();
        menu_ = "menu.view";
    }
    void empty() {
        no_scene_ = true;
        facts_.file = "";
    }
    void empty_browser() {
        empty();
        browser();
        memory_.browser.start = true;
        for (int i = 1; i <= 20; ++i)
            examples_.push_back({"scene" + std::to_string(i) + ".glib", "", "/scene", {7, 1.5F}});
        lessons_ = {{"glass.glib", "07-glass", "/glass.glib", {7, .8F}}, {long_name, long_name, "/l"}};
        recent_.back().picture.why = "new.glib:1:1: error: unknown command";
        kinds_ = {{"blank", "a lit ball in one colour"},
                  {"displace", "waves, by a vertex shader that moves a flat square"}};
        facts_.examples = {examples_, lessons_};
        facts_.kinds = kinds_;
    }
    void picking() {
        programs();
        facts_.animated = facts_.timed = true;
        facts_.object = long_name;
        memory_.hold.picking = true;
        hold_object(memory_.hold, 0);
    }
    void hidden() {
        programs();
        memory_.panel = false;
        memory_.hint = 1e3;
    }
    void keys() {
        ladder("FRESNEL", {"f0", "exact"});
        memory_.keys = true;
    }
    void nothing() {
        no_scene_ = true;
        errors();
    }

protected:
    void color(const std::string& name, int components) {
        Control& control = add_slider(name, 0, 0, 1);
        control.widget = Widget::color;
        control.components = components;
        control.value = control.initial = {.25, .5, 1};
        control.value.resize(static_cast<std::size_t>(components), .75);
        control.initial = control.value;
    }
    void ladder(const std::string& name, std::vector<std::string> rungs) {
        Ladder ladder;
        ladder.name = name;
        ladder.rungs = std::move(rungs);
        scene_.ladders.push_back(ladder);
        controls_.rungs.push_back(0);
    }

    void settle() {
        for (int i = 0; i < 4; ++i) frame();
    }
    // Of the panel at the right, all the way.
    void scroll(int steps) {
        const Rect scene = memory_.scene;
        frame({move((scene.width + screen_.width) / 2, screen_.height * .8)});
        for (int i = 0; i < 3; ++i) frame({wheel(steps)});
        frame({move(1, screen_.height - 1)});
        if (pointed_) frame({move(scene.width / 2, scene.height / 2), key(Key::i, true)});
        settle();
    }
    void unfold() {
        for (const std::string& name : unfolded_) click(place(name), MouseButton::left, .1);
        unfolded_.clear();
        if (!menu_.empty()) {
            if (has(panel_widget_)) click({0, 0, 1, 1});
            click(place(menu_));
        }
    }

    // What is noted by name ends where the panel's contents do.
    std::vector<std::string> beyond_the_panel() const {
        std::vector<std::string> found;
        // Rows that can be chosen are lit up to the middle of the gap beside them.
        const float end = screen_.width - 10 * screen_.scale + .5F;
        for (const Placed& placed : layout_.items())
            if (placed.visible && placed.rect.x > memory_.scene.width && placed.rect.x + placed.rect.width > end)
                found.push_back(placed.name + " ends " + std::to_string(placed.rect.x + placed.rect.width - end) +
                                " too far");
        return found;
    }
    // Windows that are not whole on the screen, and what they hide for good.
    static std::vector<std::string> off_the_screen() {
        std::vector<std::string> found;
        const ImVec2 all = ImGui::GetIO().DisplaySize;
        const float little = ImGui::GetStyle().WindowPadding.x + 1;  // around what is inside
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
            if (!window->Active || window->Hidden || (window->Flags & ImGuiWindowFlags_Tooltip) != 0) continue;
            const ImVec2 from = window->Pos, to(from.x + window->Size.x, from.y + window->Size.y);
            const bool child = (window->Flags & ImGuiWindowFlags_ChildWindow) != 0;
            if (!child && (from.x < -.5F || from.y < -.5F || to.x > all.x + .5F || to.y > all.y + .5F))
                found.push_back(fmt::format("{} goes from {}, {} to {}, {}", window->Name, from.x, from.y, to.x, to.y));
            if (window->ScrollbarY && window->ScrollMax.y < 1)
                found.push_back(fmt::format("{} has a scroll bar and nothing to scroll", window->Name));
            if (window->ScrollMax.x > little && !window->ScrollbarX)
                found.push_back(fmt::format("{} hides {} at its right", window->Name, window->ScrollMax.x));
            if (window->ScrollMax.y > little && !window->ScrollbarY)
                found.push_back(fmt::format("{} hides {} at its bottom", window->Name, window->ScrollMax.y));
        }
        return found;
    }
    // What lies over the picture, of the panel and of each other.
    static std::vector<std::string> covered() {
        std::vector<const ImGuiWindow*> seen;
        for (const ImGuiWindow* window : ImGui::GetCurrentContext()->Windows)
            for (const char* name : {"##panel", "##problems", "##warnings", "##states", "##message", "##legend"})
                if (window->Active && !window->Hidden && window->ParentWindow == nullptr &&
                    std::string_view(window->Name).starts_with(name)) {
                    seen.push_back(window);
                    break;
                }
        std::vector<std::string> found;
        for (std::size_t i = 0; i < seen.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                if (ImRect both = seen[i]->Rect(); both.Overlaps(seen[j]->Rect())) {
                    both.ClipWith(seen[j]->Rect());
                    if (both.GetWidth() > 1 && both.GetHeight() > 1)
                        found.push_back(fmt::format("{} covers {} by {} x {}", seen[i]->Name, seen[j]->Name,
                                                    both.GetWidth(), both.GetHeight()));
                }
        return found;
    }
    void expect_legible(const std::string& where) {
        for (const std::string& window : covered()) ADD_FAILURE() << where << ": " << window;
        for (const std::string& window : off_the_screen()) ADD_FAILURE() << where << ": " << window;
        for (const std::string& flaw : flaws(*ImGui::GetDrawData())) ADD_FAILURE() << where << ": " << flaw;
        if (memory_.browser.open || memory_.picture.open || memory_.save_as.open) return;
        for (const std::string& widget : beyond_the_panel()) ADD_FAILURE() << where << ": " << widget;
    }

    StateFacts states_;
    AccuracyFacts accuracy_;
    FoundFacts sought_;
    Explanation explanation_;
    std::vector<Problem> problems_;
    std::vector<FileRow> files_{{"room.glib", "/room.glib"}, {"glass.vert", "/glass.vert"}, {long_path, long_path}};
    std::vector<SceneCard> recent_, examples_, lessons_;
    std::vector<NewKind> kinds_;
    std::vector<std::string> unfolded_;
    std::string menu_, panel_widget_;
    Listing listing_;
    FlagCounts flags_;
    PixelFacts pixels_;
    Inspection found_;
    bool pointed_ = false;  // the mouse rests on the picture, with I held
    std::vector<float> frames_;
    std::vector<CostRow> rows_;
    FrameCostFacts frame_cost_;
    std::vector<TextureRow> textures_rows_;
    TextureFacts textures_;
};

}  // namespace snell::ui
