// Files and looks in the window: the browser, links to the editor, sizes of letters.
#include <algorithm>
#include <cmath>

#include <imgui.h>

#include "src/ui/kit/text.h"
#include "src/ui/panels/panels.h"
#include "src/ui/shell.h"
#include "tests/ui/screen.h"

namespace snell::ui {
namespace {

class FilePanels : public UiTest {
protected:
    FilePanels() {
        listing_.folder = "/home/ann/scenes";
        listing_.home = "/home/ann";
        listing_.entries = {{"glass", "/home/ann/scenes/glass", true, "", ""},
                            {"ball.glib", "/home/ann/scenes/ball.glib", false, "1 kB", ""},
                            {"Room.glib", "/home/ann/scenes/Room.glib", false, "1 kB", ""}};
        facts_.listing = &listing_;
        facts_.recent = recent_;
        facts_.file = "ball.glib";
        facts_.editor = "vi";
    }
    void press(Key which, Modifiers modifiers = {}) {
        frame({{.kind = Event::Kind::key, .key = which, .down = true, .modifiers = modifiers}});
        const Requests asked = requests_;
        frame({key(which, false)});
        if (requests_.open.empty()) requests_.open = asked.open;
        requests_.browse |= asked.browse;
    }
    void write(const std::string& text) {
        std::vector<Event> events;
        for (char c : text) events.push_back({.kind = Event::Kind::text, .text = static_cast<char32_t>(c)});
        frame(events);
        frame();
    }
    void open() {
        choose("open", "open");
        click(place("browser.folders"));
        place("browser.name");
    }
    // What was asked for by the last click, which spans several frames.
    Requests click_asks(const std::string& name, bool twice = false) {
        const Rect at = place(name);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        Requests asked;
        const auto step = [&](bool down) {
            frame({button(down)});
            if (!requests_.open.empty()) asked.open = requests_.open;
            if (!requests_.edit.file.empty()) asked.edit = requests_.edit;
            asked.browse |= requests_.browse;
        };
        step(true);
        step(false);
        if (twice) {
            step(true);
            step(false);
        }
        frame({}, 1);
        return asked;
    }

    Listing listing_;
    std::vector<SceneCard> recent_{{"old.glib", "/x", "/x/old.glib"}};
};

TEST_F(FilePanels, TheBrowserOpensWhatIsTyped) {
    press(Key::o, {.ctrl = true});
    EXPECT_TRUE(memory_.browser.open);
    EXPECT_TRUE(requests_.browse);
    click(place("browser.folders"));
    EXPECT_TRUE(has("browser.entry.ball.glib"));
    write("roo");
    EXPECT_FALSE(has("browser.entry.ball.glib")) << "only what contains it, in any case";
    EXPECT_TRUE(has("browser.entry.Room.glib"));
    press(Key::enter);
    EXPECT_EQ(requests_.open, "/home/ann/scenes/Room.glib");
    EXPECT_FALSE(memory_.browser.open);
}

TEST_F(FilePanels, TheBrowserIsUsedWithArrowsToo) {
    open();
    press(Key::down);
    press(Key::down);
    EXPECT_EQ(memory_.browser.chosen, 2u);
    press(Key::down);
    EXPECT_EQ(memory_.browser.chosen, 2u) << "the last one";
    press(Key::up);
    press(Key::up);
    press(Key::enter);
    EXPECT_TRUE(requests_.browse);
    EXPECT_EQ(memory_.browser.folder, "/home/ann/scenes/glass");
    EXPECT_TRUE(memory_.browser.open);
    press(Key::backspace);
    EXPECT_EQ(memory_.browser.folder, "/home/ann") << "up from what is listed";
    press(Key::escape);
    EXPECT_FALSE(memory_.browser.open);
    EXPECT_FALSE(has("browser.name"));
    EXPECT_EQ(requests_.open, "");
}

TEST_F(FilePanels, AFolderAboveBeginsWhereOneComesFrom) {
    open();
    listing_.folder = "/home/ann";
    listing_.entries = {{"music", "/home/ann/music", true, "", ""},
                        {"scene", "/home/ann/scene", true, "", ""},
                        {"scenes", "/home/ann/scenes", true, "", ""},
                        {"x.glib", "/home/ann/x.glib", false, "", ""}};
    frame();
    EXPECT_EQ(memory_.browser.chosen, 2u) << "the whole name counts";
    press(Key::up);
    EXPECT_EQ(memory_.browser.chosen, 1u) << "only at first";
    // From further below, too.
    listing_.folder = "/home/ann/music/a/b";
    listing_.entries.clear();
    frame();
    EXPECT_EQ(memory_.browser.chosen, 0u);
    listing_.folder = "/home/ann";
    for (int i = 0; i < 60; ++i) listing_.entries.push_back({"f" + std::to_string(i), "/home/ann/f", true, "", ""});
    listing_.entries.push_back({"music", "/home/ann/music", true, "", ""});
    for (int i = 0; i < 4; ++i) frame();
    EXPECT_EQ(memory_.browser.chosen, 60u);
    for (const Placed& placed : layout_.items())
        if (placed.name == "browser.entry.music") {
            EXPECT_TRUE(placed.visible) << "scrolled to";
        }
    // What is no folder above chooses nothing.
    listing_.folder = "/tmp";
    memory_.browser.chosen = 0;
    frame();
    EXPECT_EQ(memory_.browser.chosen, 0u);
}

TEST_F(FilePanels, TheFirstPictureIsWhole) {
    listing_.entries = {{"ball.glib", "/home/ann/scenes/ball.glib", false, "1 kB", ""}};
    open();
    const Rect row = place("browser.entry.ball.glib"), picture = place("browser.picture");
    const float gap = ImGui::GetStyle().ItemSpacing.y;
    EXPECT_GE(picture.y, row.y + gap / 2 - .5F) << "above it the list begins";
    EXPECT_LE(picture.y + picture.height, row.y + row.height);
}

TEST_F(FilePanels, TheBrowserTakesPaths) {
    open();
    write("../other/x.glib");
    press(Key::enter);
    EXPECT_EQ(requests_.open, "/home/ann/scenes/../other/x.glib");
    open();
    write("~/y.glib");
    press(Key::enter);
    EXPECT_EQ(requests_.open, "~/y.glib");
    // As the window leaves it if that is no scene.
    EXPECT_TRUE(memory_.browser.asked);
    memory_.browser.open = memory_.browser.focus = true;
    memory_.browser.error = "no such file";
    EXPECT_TRUE(has("browser.error"));
    EXPECT_STREQ(memory_.browser.typed.data(), "~/y.glib") << "to be corrected";
    write("z");
    EXPECT_FALSE(has("browser.error")) << "it is another name now";
}

TEST_F(FilePanels, TheBrowserOpensWhatIsClickedTwice) {
    open();
    EXPECT_EQ(click_asks("browser.entry.ball.glib").open, "");
    EXPECT_TRUE(memory_.browser.open) << "once only chooses";
    EXPECT_EQ(click_asks("browser.entry.ball.glib", true).open, "/home/ann/scenes/ball.glib");
    open();
    EXPECT_TRUE(click_asks("browser.folder.ann").browse);
    EXPECT_EQ(memory_.browser.folder, "/home/ann");
    EXPECT_EQ(click_asks("browser.recent.old.glib").open, "/x/old.glib");
    EXPECT_FALSE(memory_.browser.open);
}

TEST_F(FilePanels, TheRecentScenesAreOneRowUnlessOneIsSought) {
    std::vector<SceneCard> many;
    for (int i = 0; i < 12; ++i) {
        const std::string name = "old" + std::to_string(i) + ".glib";
        many.push_back({name, "/x", "/x/" + name});
    }
    facts_.recent = many;
    choose("open", "open");
    const float top = place("browser.recent.old0.glib").y;
    EXPECT_EQ(place("browser.recent.old1.glib").y, top);
    for (int i = 2; i < 12; ++i) {
        const std::string name = "browser.recent." + many[static_cast<std::size_t>(i)].name;
        EXPECT_TRUE(!has(name) || place(name).y == top) << name;
    }
    EXPECT_FALSE(has("browser.recent.old11.glib"));
    const Rect beside = place("browser.beside.ball.glib");
    EXPECT_LT(beside.y + beside.height, screen_.height) << "in sight without scrolling";
    write("old11");
    EXPECT_TRUE(has("browser.recent.old11.glib"));
}

TEST_F(FilePanels, TheBrowserBeginsWithScenesAsPictures) {
    listing_.entries.resize(1);  // so that all is seen without scrolling
    const std::vector<SceneCard> scenes{{"glass.glib", "", "/s/glass.glib", {7, 1.5F}},
                                        {"sky.glib", "", "/s/sky.glib", {.why = "sky.glib:1: no such file"}}};
    const std::vector<SceneCard> lessons{{"noise.glib", "02-noise", "/l/noise.glib"}};
    const std::string_view sentence = "waves, by a vertex shader that moves a flat square by noise";
    const std::vector<NewKind> kinds{{"blank", sentence}, {"noise", "marble"}};
    facts_.examples = {scenes, lessons};
    facts_.kinds = kinds;
    const auto begin = [&] { choose("open", "open"); };
    begin();
    for (const char* name : {"browser.recent.old.glib", "browser.scene.glass.glib", "browser.lesson.noise.glib",
                             "browser.new.blank", "browser.new.noise"})
        EXPECT_TRUE(has(name)) << name;
    EXPECT_FALSE(has("browser.entry.ball.glib"));
    const Rect whole = place("browser.new.blank");
    const ImVec2 text = ImGui::CalcTextSize(sentence.data(), sentence.data() + sentence.size(), false,
                                            whole.width - ImGui::GetFontSize());
    EXPECT_GT(text.y, 2.5F * ImGui::GetTextLineHeight());
    EXPECT_GT(whole.height, text.y + ImGui::GetTextLineHeight()) << "no word of a sentence is cut";
    EXPECT_EQ(place("browser.new.noise").height, whole.height) << "all are as high";
    const auto told = [&](const std::string& name) {
        const Rect at = place(name);
        frame({move(at.x + at.width / 2, at.y + at.height / 2)});
        frame({}, 1);
        return kit().tip.text;
    };
    EXPECT_EQ(told("browser.scene.sky.glib"), "/s/sky.glib\nNo picture: sky.glib:1: no such file");
    EXPECT_EQ(told("browser.scene.glass.glib"), "/s/glass.glib");
    for (const auto& [room, none, waits] :
         {std::tuple{200.F, "no picture", "being drawn\u2026"}, std::tuple{30.F, "!", "\u2026"}}) {
        EXPECT_EQ(picture_words(scenes[0].picture, room), "");
        EXPECT_EQ(picture_words(scenes[1].picture, room), none) << "also in a row of the list";
        EXPECT_EQ(picture_words(lessons[0].picture, room), waits) << "an empty frame says what it waits for";
    }
    EXPECT_EQ(click_asks("browser.scene.glass.glib").open, "/s/glass.glib") << "one click opens it";
    EXPECT_FALSE(memory_.browser.open);
    begin();
    write("NOI");
    EXPECT_FALSE(has("browser.scene.glass.glib")) << "only what contains it";
    EXPECT_TRUE(has("browser.lesson.noise.glib"));
    press(Key::enter);
    EXPECT_EQ(requests_.open, "/l/noise.glib");
    begin();
    screen_.height = 300;
    const float below = place("browser.new.noise").y;
    EXPECT_GT(below, place("browser.to new").y) << "out of sight";
    click(place("browser.to new"));
    EXPECT_LT(place("browser.new.noise").y, below - 50);
    screen_.height = 800;
    click(place("browser.new.noise"));
    EXPECT_TRUE(has("new scene save"));
    EXPECT_EQ(memory_.browser.kind, "noise");
    EXPECT_STREQ(memory_.new_scene.file.data(), "noise") << "a name to begin with";
    click(place("new scene cancel"));
    for (const auto& [name, own] : {std::pair("noise", false), {"~noise", false}, {"/tmp/n", true}, {"~/n", true}}) {
        open_save_as(memory_.new_scene, name, "/home/ann/scenes");
        EXPECT_EQ(has("new scene folder"), !own) << name << " says which folder itself";
        click(place("new scene cancel"));
    }
    EXPECT_TRUE(has("browser.scene.sky.glib")) << "back to where it was asked";
    click(place("browser.folders"));
    EXPECT_TRUE(has("browser.entry.glass"));
    EXPECT_TRUE(has("browser.recent.old.glib"));
}

TEST_F(FilePanels, SearchesFindTheScenesBesideTheOpenOne) {
    press(Key::o, {.ctrl = true});
    EXPECT_TRUE(has("browser.beside.ball.glib"));
    EXPECT_FALSE(has("browser.beside.glass")) << "a folder";
    write("roo");
    EXPECT_FALSE(has("browser.none"));
    press(Key::enter);
    EXPECT_EQ(requests_.open, "/home/ann/scenes/Room.glib");
    requests_.open.clear();
    press(Key::o, {.ctrl = true});
    write("ss");
    EXPECT_TRUE(has("browser.none")) << "and that it is not there is said";
    EXPECT_FALSE(has("browser.path"));
    write("/");
    EXPECT_TRUE(has("browser.path"));
    press(Key::backspace);
    press(Key::enter);
    EXPECT_TRUE(memory_.browser.open);
    // What is typed goes to the other tab, and stays whatever is listed.
    const auto typed = [&] { return std::string_view(memory_.browser.typed.data()); };
    press(Key::tab, {.ctrl = true});
    EXPECT_FALSE(memory_.browser.start);
    EXPECT_EQ(typed(), "ss");
    EXPECT_TRUE(has("browser.entry.glass"));
    EXPECT_FALSE(has("browser.entry.ball.glib"));
    EXPECT_TRUE(click_asks("browser.all").browse);
    EXPECT_TRUE(memory_.browser.all);
    EXPECT_EQ(typed(), "ss");
    frame({{.kind = Event::Kind::key, .key = Key::tab, .down = true, .modifiers = {.ctrl = true}}});
    frame({key(Key::tab, false)});
    EXPECT_TRUE(memory_.browser.start);
    EXPECT_EQ(typed(), "ss");
    click(place("browser.folders"));
    EXPECT_EQ(typed(), "ss");
}

TEST_F(FilePanels, KeysOfTheBrowserAreNoCommands) {
    open();
    click(place("browser.entry.ball.glib"));  // the field for the name has no keys now
    press(Key::h);
    EXPECT_TRUE(memory_.panel);
    press(Key::f5);
    EXPECT_FALSE(requests_.reload);
}

TEST_F(FilePanels, AnErrorIsALinkToItsPlace) {
    const std::vector<Problem> problems{
        {{.message = "nowhere"}, {}},
        {{.file = "a.frag", .at = Position{12, 3}, .message = "no"}, {"/s/a.frag", 12, 3}}};
    facts_.problems = problems;
    EXPECT_FALSE(has("problem.0")) << "what has no place leads nowhere";
    const Requests asked = click_asks("problem.1");
    EXPECT_EQ(asked.edit.file, "/s/a.frag");
    EXPECT_EQ(asked.edit.line, 12);
    EXPECT_EQ(asked.edit.column, 3);
}

// Names of files and messages may hold what looks like a place, or like a line of source.
TEST_F(FilePanels, AnErrorLeadsToItsPlaceWhateverItSays) {
    const Finding plain{.file = "a.frag", .at = Position{12, 3}, .message = "no"};
    Finding odd = plain;
    odd.message = "12 | a.frag:3:4: error: no:12:3: or so";
    Finding named = odd;
    named.file = "a:12:3: b.frag";
    const Place there{"/s/a.frag", 12, 3};
    const std::vector<Problem> problems{{plain, there}, {odd, there}, {named, there}};
    facts_.problems = problems;
    for (const char* which : {"problem.0", "problem.1", "problem.2"}) {
        const Requests asked = click_asks(which);
        EXPECT_EQ(asked.edit.file, there.file) << which;
        EXPECT_EQ(asked.edit.line, there.line) << which;
        EXPECT_EQ(asked.edit.column, there.column) << which;
    }
    const auto width_of = [&](const char* name) { return place(name).width; };
    // The font is monospaced, so the line below a place is as long as the place has letters.
    const float letters = static_cast<float>(std::string("a.frag:12:3").size()), width = width_of("problem.0.place");
    EXPECT_GT(width, letters);
    EXPECT_EQ(width_of("problem.1.place"), width);
    EXPECT_NEAR(width_of("problem.2.place"), width / letters * std::string("a:12:3: b.frag:12:3").size(), 1);
}

TEST_F(FilePanels, FilesInUseAreLinksToo) {
    const std::vector<FileRow> files{{"room.glib", "/s/room.glib"}, {"glass.frag", "/s/glass.frag"}};
    facts_.files = files;
    memory_.tab = Tab::tools;
    EXPECT_FALSE(has("file.glass.frag"));
    click(place("files"));
    EXPECT_EQ(click_asks("file.glass.frag").edit.file, "/s/glass.frag");
    EXPECT_TRUE(memory_.open.contains("Files")) << "to be open in the next run as well";
}

TEST_F(FilePanels, LettersGrowAndShrink) {
    press(Key::plus, {.ctrl = true});
    EXPECT_FLOAT_EQ(memory_.zoom, 1.1F);
    press(Key::minus, {.ctrl = true});
    press(Key::minus, {.ctrl = true});
    EXPECT_FLOAT_EQ(memory_.zoom, .9F);
    press(Key::zero, {.ctrl = true});
    EXPECT_FLOAT_EQ(memory_.zoom, 1);
    press(Key::plus);
    EXPECT_FLOAT_EQ(memory_.zoom, 1) << "not without Ctrl";
    float zoom = 1;
    for (int i = 0; i < 30; ++i) zoom = next_zoom(zoom, 1);
    EXPECT_FLOAT_EQ(zoom, 3);
    for (int i = 0; i < 30; ++i) zoom = next_zoom(zoom, -1);
    EXPECT_FLOAT_EQ(zoom, .5F);
    EXPECT_FLOAT_EQ(next_zoom(1.03F, 1), 1.1F);
}

TEST_F(FilePanels, SizesOfLettersAreAList) {
    memory_.tab = Tab::tools;
    memory_.open.insert("Window");
    for (const auto& [text, zoom] : {std::pair("125 %", 1.25F), {"150 %", 1.5F}, {"110 %", 1.1F}, {"100 %", 1.F}}) {
        click(place("letters"));
        click(place(std::string("letters.") + text));
        EXPECT_FLOAT_EQ(memory_.zoom, zoom);
        screen_.scale = memory_.zoom;
        for (int i = 0; i < 3; ++i) frame();
        EXPECT_FALSE(has("letters.110 %")) << "it closes";
    }
    memory_.zoom = 1.03F;
    EXPECT_TRUE(has("letters"));
    EXPECT_FLOAT_EQ(memory_.zoom, 1.03F) << "one that is not in the list stays";
}

TEST_F(FilePanels, ThePanelGrowsWithTheLetters) {
    add_slider("uEta", 0, .5, 1);
    frame();
    const float before = screen_.width - memory_.scene.width;
    EXPECT_FLOAT_EQ(before, 352);
    screen_.scale = 1.5F;
    frame();
    EXPECT_FLOAT_EQ(screen_.width - memory_.scene.width, 1.5F * before);
}

TEST_F(FilePanels, DarkIsDark) {
    screen_.theme = Theme::dark;
    frame();
    EXPECT_LT(palette().panel.x, .2F);
    EXPECT_GT(palette().text.x, .8F);
    screen_.theme = Theme::light;
    frame();
    EXPECT_GT(palette().panel.x, .9F);
}

TEST(Excerpts, KeepTheCaretsUnderWhatTheyMean) {
    const MarkedLine line{std::string(60, 'a') + "WRONG|" + std::string(60, 'b'), 60, 65};
    for (std::size_t columns : {11u, 21u, 41u, 71u}) {
        const MarkedLine part = excerpt(line, columns);
        // Characters, not bytes: dots are three of these.
        std::string plain = part.text;
        for (std::size_t dots; (dots = plain.find("\u2026")) != std::string::npos;) plain.replace(dots, 3, ".");
        ASSERT_LT(part.begin, static_cast<int>(plain.size())) << columns;
        EXPECT_EQ(plain[static_cast<std::size_t>(part.begin)], 'W') << columns << part.text;
        EXPECT_EQ(plain.size(), columns);
        EXPECT_LE(carets(part).size(), columns);
    }
    EXPECT_EQ(excerpt(line, 1000).text, line.text);
    EXPECT_EQ(excerpt(line, 3).text, line.text) << "no room at all: left alone";
    const MarkedLine at_end{std::string(60, 'a'), 60, 60};
    EXPECT_EQ(carets(excerpt(at_end, 20)), std::string(19, ' ') + "^") << "the caret behind the line is seen too";
}

TEST(Labels, OfALongOneTheNameGivesWay) {
    EXPECT_EQ(cut_name("Glass : uRefractiveIndex =     1.1000", 25), "Glass : \u2026veIndex = 1.1000");
    EXPECT_EQ(cut_name("Glass : uEta =     1.1000", 24), "Glass : uEta = 1.1000");
    EXPECT_EQ(cut_name("Glass : uEta =     1.1000", 14), "Gl\u2026ta = 1.1000");
    EXPECT_EQ(cut_name("Glass : uEta = -123456.7890", 12), "\u2026 = -123456\u2026") << "that more follows is seen";
    EXPECT_EQ(cut_name("Glass : uC =     0.250,     0.500", 18), "G\u2026C = 0.250, 0.500");
    EXPECT_EQ(cut_name("a = 1", 2), "\u2026 = 1");
}

TEST(Crumbs, LeadToTheirFolders) {
    const std::vector<Crumb> all = crumbs("/home/ann//x");
    ASSERT_EQ(all.size(), 4u);
    EXPECT_EQ(all[0].path, "/");
    EXPECT_EQ(all[2].name, "ann");
    EXPECT_EQ(all[2].path, "/home/ann");
    EXPECT_TRUE(crumbs("").empty());
}

}  // namespace
}  // namespace snell::ui
