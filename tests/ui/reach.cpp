// Tab reaches whatever the mouse does, and shows where it is; Enter and the space bar act on it.
#include <cmath>

#include "src/ui/kit/kit.h"
#include "tests/ui/full_panels.h"

namespace snell::ui {
namespace {

class Reached : public Screens {
public:
    struct Row {
        const char* what;
        void (Screens::*prepare)();
        const char* widget;
        bool (*holds)(Reached&);  // after Enter or the space bar
    };
    static std::vector<Row> rows() {
        using R = Reached;
        return {
            {"a recent scene", &R::empty_browser, "browser.recent.room.glib",
             [](R& r) { return r.pressed_.open == "/home/ann/scenes/room.glib"; }},
            {"a lesson", &R::empty_browser, "browser.lesson.glass.glib",
             [](R& r) { return r.pressed_.open == "/glass.glib"; }},
            {"a new scene", &R::empty_browser, "browser.new.blank", [](R& r) { return r.memory_.new_scene.open; }},
            {"a file", &R::browser, "browser.entry.scene3.glib", [](R& r) { return r.pressed_.open == "/s"; }},
            {"a folder", &R::browser, "browser.entry.another",
             [](R& r) { return r.memory_.browser.folder == "/another"; }},
            {"home", &R::browser, "browser.home",
             [](R& r) { return r.pressed_.browse && r.memory_.browser.folder.empty(); }},
            {"a rung in the table", &R::accuracy, "accuracy.rung.exact",
             [](R& r) { return r.controls_.rungs[0] == 2; }},
            {"a found rung", &R::found, "found.row.2", [](R& r) { return r.pressed_.show_rung == "2"; }},
            {"a found rung out of sight", &R::found, "found.row.40", [](R& r) { return r.pressed_.show_rung == "40"; }},
            {"a texture", &R::textures, "textures.row.Noise3",
             [](R& r) { return r.memory_.textures.chosen == "Noise3"; }},
            {"a file of the scene", &R::files, "file.glass.vert",
             [](R& r) { return r.pressed_.edit.file == "/glass.vert"; }},
            {"an error", &R::errors, "problem.0", [](R& r) { return r.pressed_.edit.file == "scene/paint.frag"; }},
            {"a cost, whose tooltip says more", &R::costs, "costs.row.Noise3",
             [](R& r) {
                 r.frame({}, 1);
                 r.frame();
                 return kit().tip.shown && kit().tip.text.find("no drawn program reads it") != std::string::npos;
             }},
        };
    }

    void check(const Row& row, Key which) {
        (this->*row.prepare)();
        settle();
        unfold();
        if (row.prepare == &Reached::accuracy || row.prepare == &Reached::found) press(Key::tab);
        ASSERT_TRUE(go_to(row.widget));
        const std::uint64_t with_ring = picture_;
        const unsigned at = std::exchange(kit().focus.at, 0U);
        frame();
        EXPECT_NE(picture_, with_ring) << "the focus is seen";
        kit().focus.at = at;
        kit().focus.presses = true;
        frame();
        press(which);
        EXPECT_TRUE(row.holds(*this));
    }

    void text_fields() {
        open_save_as(memory_.save_as, "room.glib");
        settle();
        write("s");  // instead of the name, which is selected
        press(Key::tab);
        press(Key::tab);
        press(Key::enter);
        EXPECT_TRUE(pressed_.save_as_now) << "Cancel and Save follow the field";
        EXPECT_STREQ(memory_.save_as.file.data(), "s");
        press(Key::tab);
        write("t");
        press(Key::tab, {.shift = true});
        press(Key::space);
        EXPECT_TRUE(pressed_.save_as_now);
        EXPECT_STREQ(memory_.save_as.file.data(), "t") << "a field is open when Tab reaches it, its text selected";
    }
    // Another name is typed in the place of one that was refused, and a state is typed as soon as its menu is there.
    void typed_letters() {
        open_save_as(memory_.save_as, "room.glib");
        settle();
        write("s");
        press(Key::enter);
        EXPECT_TRUE(pressed_.save_as_now);
        memory_.save_as.error = "there is no such folder";
        frame();
        write("t");
        write("u");
        frame();
        EXPECT_STREQ(memory_.save_as.file.data(), "tu");
        press(Key::enter);
        EXPECT_TRUE(pressed_.save_as_now);
        memory_.save_as.error = "there is no such folder";
        settle();
        press(Key::enter);
        EXPECT_TRUE(pressed_.save_as_now) << "the folder may have been made meanwhile";
        confirmed(memory_.save_as, true, "/none", true);
        settle();
        press(Key::enter);
        EXPECT_TRUE(pressed_.save_as_now) << "nor is the question whether to make it the end";
        memory_.save_as.open = false;
        settle();
        two_states();
        settle();
        for (const char* typed : {"uMix=2", "uMix=3"}) {
            click(place("accuracy.right"));
            write(typed);
            press(Key::enter);
            EXPECT_EQ(memory_.accuracy.right, typed);
            states_.sides[1] = {typed, typed};  // as soon as it is there
            EXPECT_FALSE(has("right.settings"));
        }
    }
    void filter() {
        many_sliders();
        settle();
        press(Key::tab);  // the first slider
        press(Key::tab, {.shift = true});
        for (int i = 0; i < 5 && !ImGui::GetIO().WantTextInput; ++i) press(Key::tab, {.shift = true});
        write("59");
        EXPECT_STREQ(memory_.filter.data(), "59");
        press(Key::tab);
        EXPECT_FALSE(has("Glass.uParameterOfNumber58"));
        EXPECT_TRUE(has("Glass.uParameterOfNumber59"));
    }

private:
    void TestBody() override {}
    void press(Key which, Modifiers modifiers = {}) {
        frame({{.kind = Event::Kind::key, .key = which, .down = true, .modifiers = modifiers}});
        pressed_ = requests_;
        frame({key(which, false)});
        frame();
    }
    void write(const std::string& text) {
        for (const char c : text) frame({{.kind = Event::Kind::text, .text = static_cast<char32_t>(c)}});
    }
    bool go_to(const std::string& widget) {
        for (int i = 0; i < 150; ++i) {
            press(Key::tab);
            const Rect at = kit().focus.box;
            for (const Placed& placed : layout_.items())
                if (placed.name == widget && kit().focus.at != 0 && std::abs(at.x - placed.rect.x) < 12 &&
                    std::abs(at.y - placed.rect.y) < 6 && std::abs(at.height - placed.rect.height) < 12)
                    return true;
        }
        return false;
    }
    Requests pressed_;
};

TEST(Reach, EveryRowAndCard) {
    for (const Reached::Row& row : Reached::rows())
        for (const Key which : {Key::enter, Key::space}) {
            SCOPED_TRACE(row.what);
            Reached().check(row, which);
        }
}

TEST(Reach, TextFields) {
    Reached().text_fields();
    Reached().typed_letters();
    Reached().filter();
}

}  // namespace
}  // namespace snell::ui
