// Values that are kept: round trips, odd names, and files that are not as we wrote them.
#include <nlohmann/json.hpp>

#include "src/app/open/snapshots.h"
#include "src/app/open/write_copy.h"
#include "src/document/save_values.h"
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
    EXPECT_EQ(file["1"]["values"]["P.uA"][0], .5);
    EXPECT_EQ(file["1"]["values"]["P#2.uA"][0], .25) << "the second of that name";
    EXPECT_TRUE(file.contains("99"));
}

TEST_F(Kept, WhatIsNoSnapshotIsRefusedAndNothingChanges) {
    auto document = read();
    const std::vector<double> before = named(*document, "uA").value;
    for (const char* text : {"", "{", "[]", "null", "7", R"({"1": 5})", R"({"1": {}})", R"({"1": {"values": []}})",
                             R"({"1": {"values": 3}})", "{\"1\": {\"values\": {\"P.uA\": [.5]}}}", "\xff\xfe{}"}) {
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
        {R"({"P.uA": [0.75], "P.uGone": [1]})", 1},
        {R"({"P.uA": ["x"]})", 1},
        {R"({"P.uA": [1, 2]})", 1},
        {R"({"P.uA": 0.5})", 1},
        {R"({"P.uA": [null]})", 1},
        {R"({"P.uA": [1e999]})", 1},
        {R"({"P.uColor": [1, 2]})", 1},
        {R"({"P.uN": [1e300]})", 1},
        {R"({"": [1], "P.": [1], ".uA": [1], "P#3.uA": [1]})", 4},
        {R"({})", 0},
    };
    for (const auto& [values, lost] : cases) {
        folder.write("s.snapshots.json", std::string(R"({"1": {"values": )") + values + "}}");
        const Restored restored = restore_snapshot(1, *document);
        if (std::string(values).find("1e999") != std::string::npos && !restored.error.empty()) continue;
        EXPECT_EQ(restored.error, "") << values;
        EXPECT_EQ(restored.lost, lost) << values;
        for (const Control& control : document->controls.items)
            for (const double value : control.value) EXPECT_TRUE(std::isfinite(value)) << values;
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

TEST_F(Kept, AnotherNameIsTheSameSceneWithItsValues) {
    auto document = read();
    named(*document, "uA").value = {.9};
    const SavedAs as = saved_as(*document, "other");
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
    for (const char* name : {"", "sub/", "s.glib", "s", "./s.glib", "nowhere/x.glib"})
        EXPECT_NE(saved_as(*document, name).error, "") << name;
    folder.write("sub/other.txt", "");
    const std::string error = saved_as(*document, "sub/x").error;
    EXPECT_NE(error.find("many.frag"), std::string::npos) << error;
    folder.write("sub/many.frag", bytes_of(folder.path("many.frag")));
    EXPECT_EQ(saved_as(*document, "sub/x").error, "") << "it would find its files there";
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
