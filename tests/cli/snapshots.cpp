// Values that are kept: round trips, odd names, and files that are not as we wrote them.
#include <nlohmann/json.hpp>

#include <random>

#include "parser/text/ranges.h"
#include "src/app/desktop/folder.h"
#include "src/app/open/command_text.h"
#include "src/app/open/states.h"
#include "src/app/open/write_copy.h"
#include "src/app/window/survive/recovery.h"
#include "src/document/document.h"
#include "src/plan/setup.h"
#include "src/plan/values/declared.h"
#include "tests/cli/run.h"
#include "tests/harness/harness.h"

namespace snell::test {

namespace {

using nlohmann::json;

class Kept : public GlTest {
protected:
    void SetUp() override {
        GlTest::SetUp();
        folder.write("many.frag",
                     "uniform float uA;\nuniform vec3 uColor;\nuniform int uN;\nuniform bool uOn;\n"
                     "void main() { gl_FragColor = vec4(uColor * uA, uOn ? float(uN) : 1.); }\n");
        folder.write("s.glib", scene);
    }
    std::unique_ptr<Document> read() { return open_file(folder.path("s.glib")); }
    static Control& named(Document& document, const std::string& name, Index program = 0) {
        for (Control& control : document.controls.items)
            if (control.name == name && control.program == program) return control;
        ADD_FAILURE() << name;
        return document.controls.items.front();
    }
    std::string snapshots() const { return bytes_of(folder.path("s.snapshots.json")); }

    const std::string scene =
        "##OpenGL GLIB\r\nOrtho -1 1 -1 1\r\nFragment many.frag\r\n"
        "Program P uA <0. .5 1.> uColor {.1 .2 .3} \\ # why\r\n  uN <0 2 9> uOn <true>\r\nQuadXY\r\n"
        "Program P uA <0. .25 1.> uColor {.1 .2 .3}\r\nQuadXY";
};

TEST_F(Kept, SnapshotsReadBackToTheSameBits) {
    auto document = read();
    expect_clean(*document);
    named(*document, "uA").value = {1. / 3};
    named(*document, "uA", 1).value = {.1 + .2};
    named(*document, "uColor").value = {1e-300, -0., 1. / 7};
    named(*document, "uN").value = {7};
    named(*document, "uOn").value = {0};
    const Controls wanted = document->controls;
    for (int number = 1; number <= most_snapshots; ++number) {
        named(*document, "uN").value = {static_cast<double>(number)};
        ASSERT_EQ(store_snapshot(number, *document), "");
    }
    auto again = read();
    for (int number = 1; number <= most_snapshots; ++number) {
        EXPECT_TRUE(snapshots_there(document->path)[static_cast<std::size_t>(number)]);
        const Restored restored = restore_snapshot(number, *again);
        EXPECT_EQ(restored.error, "");
        EXPECT_EQ(restored.lost, 0U);
        EXPECT_EQ(named(*again, "uN").value, std::vector<double>{static_cast<double>(number)});
        for (const Control& control : wanted.items)
            if (control.name != "uN") {
                EXPECT_EQ(named(*again, control.name, control.program).value, control.value) << control.name;
            }
    }
    EXPECT_FALSE(snapshots_there(document->path)[0]);
    EXPECT_EQ(bytes_of(folder.path("s.glib")), scene) << "the scene itself stays";
}

TEST_F(Kept, WhatASnapshotFileHoldsBesidesStays) {
    folder.write("s.snapshots.json",
                 R"({"title": "mine", "1": {"name": "ice", "note": [1, 2]}, "99": {"values": {}}})");
    ASSERT_EQ(store_snapshot(1, *read()), "");
    const json file = json::parse(snapshots());
    EXPECT_EQ(file["title"], "mine");
    EXPECT_EQ(file["1"]["name"], "ice");
    EXPECT_EQ(file["1"]["note"], (json{1, 2}));
    const std::string options = file["1"]["options"];
    EXPECT_NE(options.find("--set P.uA=0.5\n"), options.npos) << options;
    EXPECT_NE(options.find("--set P#2.uA=0.25\n"), options.npos) << "the second of that name";
    EXPECT_TRUE(file.contains("99"));
}

TEST_F(Kept, WhatIsNoSnapshotIsRefusedAndNothingChanges) {
    auto document = read();
    const std::vector<double> before = named(*document, "uA").value;
    for (const char* text : {"", "{", "[]", "null", "7", R"({"1": 5})", R"({"1": {}})", R"({"1": {"options": []}})",
                             R"({"1": {"options": 3}})", R"({"1": {"values": {"P.uA": [0.25]}}})", "\xff\xfe{}"}) {
        folder.write("s.snapshots.json", text);
        const Restored restored = restore_snapshot(1, *document);
        EXPECT_NE(restored.error, "") << text;
        EXPECT_EQ(named(*document, "uA").value, before) << text;
    }
    for (const char* foreign : {"{", "[1, 2]", "\"text\"", "no JSON at all"}) {
        folder.write("s.snapshots.json", foreign);
        EXPECT_NE(store_snapshot(2, *document), "") << foreign;
        EXPECT_EQ(snapshots(), foreign) << "it is somebody's";
    }
}

TEST_F(Kept, ValuesThatDoNotFitAreLeftOut) {
    auto document = read();
    const std::pair<const char*, std::size_t> cases[] = {
        {"--set P.uA=0.75\\n--set P.uGone=1", 1},
        {"--set P.uA=x", 1},
        {"--set P.uA=1,2", 1},
        {"--set P.uA=", 1},
        {"--set P.uA=nan", 1},
        {"--set P.uA=1e999", 1},
        {"--set P.uColor=1,2", 1},
        {"--set P.uN=1e300", 1},
        {"--set =1\\n--set P.=1\\n--set .uA=1\\n--set P#3.uA=1", 4},
        {"--ladder F=exact", 1},
        {"--range P.uA=2,1\\n--range P.uA=x\\n--range P.uN=1e999,-1e999\\n--set\\n--set P.uA\\nP.uA=7\\n=\\n--=", 0},
        {"", 0},
    };
    for (const auto& [values, lost] : cases) {
        folder.write("s.snapshots.json", std::string(R"({"1": {"options": ")") + values + "\"}}");
        const Restored restored = restore_snapshot(1, *document);
        EXPECT_EQ(restored.error, "") << values;
        EXPECT_EQ(restored.lost, lost) << values;
        for (const Control& control : document->controls.items)
            for (const double value : control.value) EXPECT_TRUE(std::isfinite(value)) << values;
    }
}

TEST_F(Kept, ASnapshotFileThatCannotBeReadIsLeftAsItIs) {
    if (geteuid() == 0) GTEST_SKIP() << "root reads everything";
    const std::string file = folder.write("s.snapshots.json", R"({"1": {"options": ""}})");
    std::filesystem::permissions(file, std::filesystem::perms::none);
    auto document = read();
    EXPECT_NE(restore_snapshot(1, *document).error.find("cannot be read"), std::string::npos);
    EXPECT_NE(store_snapshot(2, *document), "");
    std::filesystem::permissions(file, std::filesystem::perms::owner_all);
    EXPECT_EQ(snapshots(), R"({"1": {"options": ""}})");
}

// All that a scene can be set to, as text, and set again in a scene that was just opened: the same text and picture.
TEST_F(Kept, ASetupReadsBackToTheSameBytesAndPicture) {
    folder.write("kinds.frag",
                 "#version 400\n#ifdef EXACT\n#endif\nuniform float uF; uniform vec3 uV; uniform int uI; "
                 "uniform uint uU; uniform bool uB; uniform mat2 uM; uniform double uD; uniform float uArray[3];\n"
                 "out vec4 f;\nvoid main() { f = vec4(uV * uF + uArray[1] + uM[1][0], 1.) * (uB ? 1. : .5)\n"
                 "+ float(uI) * .01 + float(uU) * .02 + float(uD) + float(WAY) * .3; }\n");
    const std::string path = folder.write("kinds.glib",
                                          "Ladder WAY <a> b c\nOrtho -1 1 -1 1\nFragment kinds.frag\n"
                                          "Program P=1 uF <0. .5 1.> uV {.1 .2 .3} uI <0 2 9> uU <0 1 5> uB <true> uD "
                                          "0.25 uM [1 0 0 1] uArray [.1 .2 .3]\n"
                                          "QuadXY 0. .7\nProgram P=1 uF <0. .25 1.>\nTranslate .5 0 0\nSphere .3\n");
    std::mt19937 random(11);
    std::uniform_real_distribution<double> any(0, 1);
    for (int round = 0; round < 20; ++round) {
        auto set = open_file(path), fresh = open_file(path);
        expect_clean(*set);
        ASSERT_GE(set->controls.items.size(), 8U);
        set->controls.rungs = {random() % 3};
        follow_rungs(*set);
        for (Control& control : set->controls.items) {
            for (double& number : control.value) number = fit_to_type(any(random) * (round % 2 ? 10 : 1), control.type);
            if (control.widget != Widget::slider) continue;
            control.min -= std::floor(any(random) * 3);
            control.max = std::max(control.max, *ranges::max_element(control.value)) + std::floor(any(random) * 3);
            if (control.type == ValueType::uint_) control.min = 0;
        }
        View view, again;
        for (Transformation* t : {&view.scene, &view.eye, &view.objects[1]})
            *t = {any(random), any(random), 1.5, any(random)};
        view.projection = static_cast<Projection>(round % 3);
        if (round % 2) view.background = any(random);
        view.axes = round % 3 == 0;
        snell::Setup setup = setup_of(set->scene(), set->controls);
        setup.merge(setup_of(view));
        const std::string text = setup_text(setup);
        const snell::Setup back = read_setup(text);
        EXPECT_EQ(setup_text(back), text);
        EXPECT_EQ(apply_setup(back, fresh->scene(), fresh->controls.rungs), 0U);
        follow_rungs(*fresh);
        EXPECT_EQ(apply_setup(back, fresh->scene(), fresh->controls), 0U);
        apply_setup(back, again);
        EXPECT_EQ(again, view);
        snell::Setup given = setup_of(fresh->scene(), fresh->controls);
        given.merge(setup_of(again));
        ASSERT_EQ(setup_text(given), text);
        EXPECT_TRUE(draw(*set, {.view = view}) == draw(*fresh, {.view = again})) << text;
        // Empty values are the view as it begins.
        for (auto& [key, value] : given)
            if (key.starts_with(view_option) || key == axes_option) value.clear();
        apply_setup(given, again);
        EXPECT_EQ(again, View{});
    }
}

// What the copied command says sets every program to what it is, also programs of one name.
TEST_F(Kept, TheOptionsOfACommandSetTheSameValues) {
    auto document = read();
    for (const auto& [first, second] : {std::pair(.75, .25), std::pair(.5, .75), std::pair(.75, .75)}) {
        named(*document, "uA").value = {first};
        named(*document, "uA", 1).value = {second};
        named(*document, "uN").value = {7};
        const std::vector<std::string> words = value_options(*document, {});
        auto other = read();
        Diagnostics wrong;
        for (std::size_t i = 0; i < words.size(); i += 2) {
            EXPECT_EQ(words[i], "--set");
            EXPECT_TRUE(set_control(other->controls, other->scene(), words[i + 1], wrong)) << words[i + 1];
        }
        EXPECT_EQ(setup_of(other->scene(), other->controls), setup_of(document->scene(), document->controls));
    }
}

TEST_F(Kept, OddNamesOfFilesAreNames) {
    for (const char* name : {"a b.glib", "room.v2.glib", "ünï.glib", "noextension", "quote'\".glib", "{stem}.glib"}) {
        const std::string path = folder.write(std::string("odd/") + name, "Ortho -1 1 -1 1\nQuadXY\n");
        auto document = open_file(path);
        ASSERT_TRUE(document->runtime) << name;
        ASSERT_EQ(store_snapshot(9, *document), "") << name;
        EXPECT_TRUE(snapshots_there(path)[9]) << name;
        EXPECT_TRUE(std::filesystem::exists(snapshots_file(path))) << name;
        EXPECT_NE(snapshots_file(path), path);
    }
}

// A file that is not there yet has its links, too: Save as writes through them.
TEST_F(Kept, LinksHaveTheSnapshotsOfTheirFile) {
    const std::string link = folder.path("links/other.glib"), again = folder.path("again.glib");
    std::filesystem::create_directory(folder.path("links"));
    std::filesystem::create_symlink("../s.glib", link);
    std::filesystem::create_symlink(link, again);
    std::filesystem::create_symlink("later.glib", folder.path("links/early.glib"));
    auto document = open_file(again);
    ASSERT_EQ(store_snapshot(3, *document), "");
    for (const std::string& name : {link, again, folder.path("s.glib")}) EXPECT_TRUE(snapshots_there(name)[3]) << name;
    EXPECT_FALSE(snapshots().empty());
    EXPECT_EQ(snapshots_file(folder.path("links/early.glib")), folder.path("links/later.snapshots.json"));
}

TEST_F(Kept, SavedValuesAreReadAgain) {
    auto document = read();
    named(*document, "uA").value = {1. / 3};
    named(*document, "uColor").value = {0, 1, .123456789012345678};
    named(*document, "uN").value = {9};
    named(*document, "uA", 1).value = {1};
    const Saved saved = saved_values(*document);
    ASSERT_EQ(saved.error, "");
    for (const Unwritten& value : saved.unwritten) ADD_FAILURE() << value.name << ": " << value.reason;
    ASSERT_EQ(write_saved(saved.files), "");
    auto again = read();
    expect_clean(*again);
    for (const Control& control : document->controls.items)
        EXPECT_EQ(named(*again, control.name, control.program).value, control.value) << control.name;
    const std::string text = bytes_of(folder.path("s.glib"));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), std::count(scene.begin(), scene.end(), '\r'));
    EXPECT_NE(text.find("\\ # why\r\n"), std::string::npos);
    ASSERT_EQ(revert_saved(saved.files), "");
    EXPECT_EQ(bytes_of(folder.path("s.glib")), scene);
    EXPECT_NE(revert_saved(saved.files), "") << "it is not as it was saved";
}

// A file would hold the moment at which the key was pressed.
TEST_F(Kept, ASliderThatMovesKeepsTheScenesNumber) {
    auto document = read();
    ui::Memory memory;
    Control& color = named(*document, "uColor");
    const std::vector<double> written = color.value;
    memory.animated = {animated_from(named(*document, "uA"), 0, 4, 0), animated_from(color, 1, 4, 0)};
    animate(document->controls, memory.animated, 1.7);
    ASSERT_NE(named(*document, "uA").value, named(*document, "uA").initial) << "the test can fail";
    Keeper keeper(document->path);
    ui::Facts facts;
    keeper.tell(facts, &*document, memory.animated);
    EXPECT_FALSE(facts.changed);
    keeper.serve({.save = true}, *document, {}, memory);
    EXPECT_EQ(bytes_of(folder.path("s.glib")), scene);
    EXPECT_EQ(memory.notice, "nothing to save; not uA, uColor, which move");
    color.value[0] = .375;
    memory.animated.front() = memory.animated.back();
    memory.animated.pop_back();
    named(*document, "uA").value = named(*document, "uA").initial;
    keeper.serve({.save = true}, *document, {}, memory);
    EXPECT_EQ(memory.notice, "1 value saved to s.glib; not uColor, which moves");
    memory.save_as.file = {'o', '.', 'g', 'l', 'i', 'b'};
    EXPECT_EQ(keeper.serve({.save_as_now = true}, *document, {}, memory).as,
              "saved as o.glib; not uColor, which moves");
    EXPECT_EQ(named(*read(), "uColor").value, (std::vector<double>{.375, written[1], written[2]}));
    memory.animated.clear();
    auto again = read();
    keeper.serve({.save = true}, *again, {}, memory);
    EXPECT_EQ(memory.notice, "nothing to save");
    snell::Picture turned;
    const auto told = [&] {
        keeper.serve({.save = true}, *again, turned, memory);
        return memory.notice;
    };
    turned.view.objects[0].x = 1;
    EXPECT_EQ(told(), "nothing to save; moved objects are not written to the scene");
    turned.view.scene.rotate_y = 30;
    EXPECT_EQ(told(), "nothing to save; the view and moved objects are not written to the scene");
    turned.view.objects.clear();
    EXPECT_EQ(told(), "nothing to save; the view is not written to the scene");
    named(*again, "uA").value = {50};
    keeper.serve({.save = true}, *again, {}, memory);
    EXPECT_EQ(memory.notice, "1 value saved to s.glib; range of uA widened to 50");
}

TEST_F(Kept, AFileThatChangedMeanwhileIsNotOverwritten) {
    auto document = read();
    named(*document, "uA").value = {.9};
    const Saved saved = saved_values(*document);
    ASSERT_EQ(saved.error, "");
    const std::string other = scene + "\r\n# mine\r\n";
    folder.write("s.glib", other);
    EXPECT_NE(saved_values(*document).error, "");
    EXPECT_NE(write_saved(saved.files), "");
    EXPECT_EQ(bytes_of(folder.path("s.glib")), other);
}

TEST_F(Kept, ADeletedSceneIsRescuedByAnotherName) {
    auto document = read();
    named(*document, "uA").value = {.9};
    fs::remove(folder.path("s.glib"));
    EXPECT_NE(saved_values(*document).error.find("is gone"), std::string::npos) << saved_values(*document).error;
    const SavedAs as = saved_as(*document, "rescued.glib");
    ASSERT_EQ(as.error, "");
    folder.write("rescued.glib", as.file.after);
    EXPECT_EQ(named(*open_file(folder.path("rescued.glib")), "uA").value, std::vector<double>{.9});
}

TEST_F(Kept, AnotherNameIsTheSameSceneWithItsValues) {
    auto document = read();
    named(*document, "uA").value = {.9};
    const SavedAs as = saved_as(*document, "other.glib");
    ASSERT_EQ(as.error, "");
    EXPECT_EQ(as.file.path, folder.path("other.glib"));
    EXPECT_FALSE(as.exists);
    folder.write("other.glib", as.file.after);
    EXPECT_EQ(bytes_of(folder.path("s.glib")), scene);
    auto other = open_file(folder.path("other.glib"));
    expect_clean(*other);
    EXPECT_EQ(named(*other, "uA").value, std::vector<double>{.9});
    EXPECT_TRUE(saved_as(*document, "other.glib").exists);
    EXPECT_EQ(saved_as(*document, folder.path("whole.glib")).file.path, folder.path("whole.glib"));
    EXPECT_EQ(saved_as(*other, "x").file.after, as.file.after) << "nothing changed: the text as it is";
}

TEST_F(Kept, NamesThatMakeNoSceneAreRefused) {
    auto document = read();
    for (const char* name : {"", "sub/", "s.glib", "./s.glib", "nowhere/x.glib"})
        EXPECT_NE(saved_as(*document, name).error, "") << name;
    folder.write("sub/other.txt", "");
    const std::string error = saved_as(*document, "sub/x").error;
    EXPECT_NE(error.find("many.frag"), std::string::npos) << error;
    folder.write("sub/many.frag", bytes_of(folder.path("many.frag")));
    EXPECT_EQ(saved_as(*document, "sub/x").error, "") << "it would find its files there";
}

// The scene that reads ../glass/far.frag goes into a folder of its own beside that of its files.
TEST_F(Kept, WhereASceneGoesIsSaidBeforeAndAfter) {
    folder.write("glass/far.frag", bytes_of(folder.path("many.frag")));
    folder.write("room/r.glib", "Ortho -1 1 -1 1\nFragment ../glass/far.frag\nProgram P uA <0. .5 1.>\nQuadXY\n");
    const auto document = open_file(folder.path("room/r.glib"));
    expect_clean(*document);
    Keeper keeper(document->path);
    ui::Memory memory;
    ui::SaveAs& dialog = memory.save_as;
    const auto asked = [&](const std::string& name, bool now) {
        if (!dialog.open) ui::open_save_as(dialog, name);
        dialog.file.fill('\0');
        name.copy(dialog.file.data(), name.size());
        return keeper.serve({.save_as_now = now}, *document, {}, memory);
    };
    asked("x", false);
    EXPECT_EQ(dialog.place, "");
    folder.write("a/far/notes.txt", "");
    const std::string none = folder.path("none"), far_shown = with_tilde(folder.path("a/far")),
                      none_shown = with_tilde(none);
    asked("../a/far/x", false);
    EXPECT_EQ(dialog.place, "as " + far_shown + "/room/x.glib, with its files");
    EXPECT_EQ(asked("../a/far/x", true).as, "saved as room/x.glib in " + far_shown + " with its 1 file");
    EXPECT_FALSE(dialog.open);

    asked("../none/x", false);
    EXPECT_EQ(dialog.place, "as " + none_shown + "/room/x.glib, with its files");
    EXPECT_EQ(asked("../none/x", true).saved_as, "");
    EXPECT_TRUE(dialog.asks() && dialog.makes);
    EXPECT_EQ(dialog.existing, "none");
    EXPECT_EQ(dialog.error, "");
    EXPECT_FALSE(fs::exists(none)) << "it is asked first";
    EXPECT_EQ(asked("../none/x", true).as, "saved as room/x.glib in " + none_shown + " with its 1 file");
    expect_clean(*open_file(none + "/room/x.glib"));

    asked("../glass/y", false);
    EXPECT_EQ(dialog.place, "") << "it finds its files from there";
    EXPECT_EQ(asked("../glass/y", true).as, "saved as y.glib in " + with_tilde(folder.path("glass")));
}

TEST_F(Kept, ValuesOfIncludedFilesAreNotSavedUnderAnotherName) {
    folder.write("part.glib", "Program P uA <0. .5 1.>\nQuadXY\n");
    folder.write("whole.glib", "Ortho -1 1 -1 1\nFragment many.frag\nInclude part.glib\n");
    auto document = open_file(folder.path("whole.glib"));
    EXPECT_EQ(saved_as(*document, "x").error, "");
    named(*document, "uA").value = {.9};
    const std::string error = saved_as(*document, "x").error;
    EXPECT_NE(error.find("part.glib"), std::string::npos) << error;
}

TEST_F(Kept, NothingChangedNothingIsWritten) {
    const Saved saved = saved_values(*read());
    EXPECT_EQ(saved.error, "");
    EXPECT_TRUE(saved.files.empty());
    EXPECT_EQ(saved.values, 0U);
}

}  // namespace

}  // namespace snell::test
