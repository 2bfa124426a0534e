// The listing of the file browser, and what a window remembers from run to run.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "src/app/desktop/folder.h"
#include "src/app/desktop/settings.h"
#include "src/app/window/opener.h"
#include "tests/scratch.h"

namespace snell {
namespace {

std::vector<std::string> names(const ui::Listing& listing) {
    std::vector<std::string> found;
    for (const ui::Entry& entry : listing.entries) found.push_back(entry.name + (entry.folder ? "/" : ""));
    return found;
}

using Names = std::vector<std::string>;

// Looks until a picture is made, or until nothing is left to do.
std::string made_by(ScenePictures& pictures, int looks = 2000) {
    std::string scene;
    for (int i = 0; i < looks && scene.empty(); ++i) {
        scene = pictures.look();
        usleep(5000);
    }
    return scene;
}

TEST(ScenePictures, AreMadeAgainWhenAFileOfTheSceneIsWritten) {
    const Scratch folder;
    folder.write("draw", "#!/bin/sh\necho picture > \"$4\"\n");
    ASSERT_EQ(chmod(folder.path("draw").c_str(), 0700), 0);
    folder.write("part.inc", "Sphere\n");
    folder.write("paint.vert", "#include \"light.glsl\"\nvoid main() { gl_Position = ftransform(); }\n");
    for (const char* file : {"light.glsl", "paint.frag", "other.frag"}) folder.write(file, "void main() {}\n");
    folder.write("wood.png", "");
    const std::string scene = folder.write("scene.glib",
                                           "Texture2D 5 wood.png\nVertex paint.vert\nFragment paint.frag\n"
                                           "Program Paint\nInclude part.inc\n");
    ScenePictures pictures(folder.path("pictures"), folder.path("draw"));
    pictures.want({scene});
    ASSERT_EQ(made_by(pictures), scene);
    EXPECT_EQ(made_by(pictures, 20), "") << "it is current";
    // By a file that is older than the picture, as when an archive is unpacked.
    const auto replace = [&](const char* file) {
        usleep(20000);  // the clock of files is coarse
        const std::string other = folder.write("other", bytes_of(folder.path(file)));
        std::filesystem::last_write_time(other, std::filesystem::file_time_type::clock::now() - std::chrono::hours(9));
        std::filesystem::rename(other, folder.path(file));
    };
    for (const char* file : {"paint.frag", "light.glsl", "part.inc", "wood.png", "scene.glib"}) {
        replace(file);
        EXPECT_EQ(made_by(pictures), scene) << file;
    }
    replace("other.frag");
    EXPECT_EQ(made_by(pictures, 20), "") << "the scene does not read it";
}

TEST(ScenePictures, SayWhyThereIsNone) {
    const Scratch folder;
    folder.write("bad.glib", "Spere 1\n");
    folder.write("draw",
                 "#!/bin/sh\necho 'bad.glib:9:1: warning: odd'\necho 'bad.glib:1:1: error: no such command'\necho "
                 "more\nexit 1\n");
    ASSERT_EQ(chmod(folder.path("draw").c_str(), 0700), 0);
    ScenePictures pictures(folder.path("pictures"), folder.path("draw"));
    const std::string scene = folder.path("bad.glib");
    pictures.want({scene});
    EXPECT_EQ(pictures.why(scene), "") << "nobody tried";
    EXPECT_EQ(made_by(pictures), scene);
    EXPECT_EQ(pictures.why(scene), "bad.glib:1:1: error: no such command");
    EXPECT_EQ(pictures.look(), "");
    EXPECT_NE(pictures.why(scene), "") << "once is enough";
    folder.write("draw", "#!/bin/sh\necho background > \"$4\"\necho 'bad.glib:1:1: error: another one'\nexit 1\n");
    std::filesystem::last_write_time(scene, std::filesystem::last_write_time(scene) - std::chrono::seconds(10));
    EXPECT_EQ(made_by(pictures), scene) << "until it is written again";
    EXPECT_EQ(pictures.why(scene), "bad.glib:1:1: error: another one");
    EXPECT_FALSE(std::filesystem::exists(thumbnail_file(folder.path("pictures"), scene))) << "of a part of the scene";
}

TEST(Folder, FoldersThenScenesAsPeopleSortThem) {
    const Scratch folder;
    for (const char* name : {"room10.glib", "Room2.glib", "ball.GLIB", "b/x.glib", "A/x.glib", "notes.txt",
                             ".hidden.glib", ".git/x", "room.glib.bak", ".glib"})
        folder.write(name, "12345");
    const ui::Listing listing = list_folder(folder.path(), false);
    EXPECT_EQ(names(listing), (Names{"A/", "b/", "ball.GLIB", "Room2.glib", "room10.glib"}));
    EXPECT_EQ(listing.entries[2].size, "5 B");
    EXPECT_EQ(listing.entries[2].path, std::filesystem::canonical(folder.path()).string() + "/ball.GLIB");
    EXPECT_EQ(listing.entries[2].date.size(), std::string("2026-01-01 12:00").size());
    EXPECT_EQ(names(list_folder(folder.path(), true)),
              (Names{"A/", "b/", "ball.GLIB", "notes.txt", "room.glib.bak", "Room2.glib", "room10.glib"}));
}

TEST(Folder, OrderIsStrictForAnyNames) {
    const Names all{"",  "a", "A",  "a1", "a01", "a2", "a10", "a10b", "a9999999999999999999999",
                    "b", "1", "01", "10", "\xFF"};
    for (const auto& x : all) {
        EXPECT_FALSE(before(x, x)) << x;
        for (const auto& y : all) {
            EXPECT_FALSE(before(x, y) && before(y, x)) << x << " " << y;
            for (const auto& z : all) {
                if (before(x, y) && before(y, z)) {
                    EXPECT_TRUE(before(x, z)) << x << " " << y << " " << z;
                }
            }
        }
    }
    EXPECT_TRUE(before("a2", "a10"));
    EXPECT_TRUE(before("a9", "b1"));
}

TEST(Folder, NamesThatNoTerminalShouldSeeAreEscaped) {
    const Scratch folder;
    const std::string path = folder.write("a\x1B[31m\n.glib", "");
    const ui::Listing listing = list_folder(folder.path(), false);
    ASSERT_EQ(listing.entries.size(), 1u);
    EXPECT_EQ(listing.entries[0].name.find_first_of("\x1B\n"), std::string::npos);
    EXPECT_TRUE(std::filesystem::exists(listing.entries[0].path)) << "and opened under their own";
}

TEST(Folder, TheOnlySceneStandsForItsFolder) {
    const Scratch folder;
    EXPECT_EQ(only_scene(folder.path("none")), folder.path("none"));
    folder.write("inner/x.glib", "");
    folder.write("ball.frag", "");
    EXPECT_EQ(only_scene(folder.path()), folder.path()) << "no scene directly in it";
    const std::string scene = folder.write("ball.glib", "");
    EXPECT_EQ(only_scene(folder.path()), scene);
    EXPECT_EQ(only_scene(folder.path() + "/"), scene);
    EXPECT_EQ(only_scene(scene), scene);
    EXPECT_EQ(only_scene(""), "") << "not the folder where the program runs";
    folder.write("ball2.glib", "");
    EXPECT_EQ(only_scene(folder.path()), folder.path());
}

TEST(Folder, SaysWhyThereIsNothing) {
    const Scratch folder;
    EXPECT_NE(list_folder(folder.path("none"), false).error, "");
    EXPECT_NE(list_folder(folder.write("a.glib", ""), false).error, "");
    EXPECT_EQ(list_folder(folder.path(), false).error, "");
    // Pipes are no scenes, and links that lead nowhere are nothing.
    mkfifo(folder.path("pipe.glib").c_str(), 0600);
    std::filesystem::create_symlink("nowhere", folder.path("link.glib"));
    EXPECT_EQ(names(list_folder(folder.path(), false)), Names{"a.glib"});
}

TEST(Folder, TheTildeIsHome) {
    const Scratch folder;
    folder.write("scenes/a.glib", "");
    const char* before = std::getenv("HOME");
    const std::string kept = before ? before : "";
    setenv("HOME", folder.path().c_str(), 1);
    EXPECT_EQ(names(list_folder("~/scenes", false)), Names{"a.glib"});
    EXPECT_EQ(without_tilde("~"), folder.path());
    EXPECT_EQ(without_tilde("~ann/x"), "~ann/x");
    setenv("HOME", kept.c_str(), 1);
}

TEST(Folder, NamesInMessagesAreThoseOfTheScenesFolderAndOfHome) {
    const char* before = std::getenv("HOME");
    const std::string kept = before ? before : "";
    setenv("HOME", "/home/ann", 1);
    const std::string here = "/home/ann/scenes/room";
    EXPECT_EQ(near_names(here + "/a.frag:3:4", here), "a.frag:3:4");
    EXPECT_EQ(near_names("cannot read '" + here + "/a b.bmp' (" + here + "/c)", here), "cannot read 'a b.bmp' (c)");
    EXPECT_EQ(near_names("/home/ann/other/x.glib", here), "~/other/x.glib");
    EXPECT_EQ(near_names("/home/anna/x /x/home/ann/y " + here + "s/z", here),
              "/home/anna/x /x/home/ann/y ~/scenes/rooms/z");
    EXPECT_EQ(near_names("scenes/a/b.frag /scenes/a/b", "scenes/a"), "b.frag /scenes/a/b");
    EXPECT_EQ(near_names("a/b", ""), "a/b");
    EXPECT_EQ(near_names("/a /b", "/"), "/a /b");
    EXPECT_EQ(with_tilde("/home/ann"), "~");
    EXPECT_EQ(with_tilde("/home/ann/x"), "~/x");
    EXPECT_EQ(with_tilde("/home/anna"), "/home/anna");
    setenv("HOME", kept.c_str(), 1);
}

TEST(Settings, PathsThatJsonCannotHoldAreNotRecent) {
    std::vector<std::string> recent;
    remember(recent, "/scenes/one.glib");
    remember(recent, "/scenes/bad\xff\xfe.glib");
    remember(recent, "/scenes/\xc3\xa4.glib");
    EXPECT_EQ(recent, (std::vector<std::string>{"/scenes/\xc3\xa4.glib", "/scenes/one.glib"}));
}

TEST(Thumbnails, AreThoseThatWereMadeLastAndDamageIsNone) {
    const Scratch scratch;
    const std::string folder = scratch.path("cache/thumbnails");
    content::Image picture{.width = 160, .height = 90, .channels = 3};
    picture.pixels.assign(picture.bytes(), std::byte{200});
    EXPECT_FALSE(read_thumbnail(folder, "/a.glib"));
    keep_thumbnail(folder, "/a.glib", picture);
    keep_thumbnail(folder, "/b.glib", picture);
    const std::optional<content::Image> read = read_thumbnail(folder, "/a.glib");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->width, 160);
    EXPECT_EQ(read->height, 90);
    EXPECT_EQ(read->channels, 4);
    EXPECT_EQ(read->pixels[0], std::byte{200});
    // The oldest of many go, and other files are not ours.
    scratch.write("cache/thumbnails/notes.txt", "mine");
    const auto old = std::filesystem::file_time_type::clock::now() - std::chrono::hours(48);
    std::filesystem::last_write_time(thumbnail_file(folder, "/a.glib"), old);
    for (std::size_t i = 0; i + 2 < most_thumbnails; ++i) scratch.write(fmt::format("cache/thumbnails/{}.png", i), "");
    EXPECT_TRUE(read_thumbnail(folder, "/a.glib"));
    keep_thumbnail(folder, "/c.glib", picture);
    EXPECT_FALSE(read_thumbnail(folder, "/a.glib"));
    EXPECT_TRUE(read_thumbnail(folder, "/b.glib"));
    EXPECT_TRUE(std::filesystem::exists(folder + "/notes.txt"));
    const std::string file = thumbnail_file(folder, "/b.glib"), whole = bytes_of(file);
    picture.width = picture.height = 400;
    picture.pixels.assign(picture.bytes(), std::byte{200});
    for (const std::string& text : {std::string(), std::string("no picture"), whole.substr(0, whole.size() / 2),
                                    whole.substr(8), std::string(1 << 21, 'x'), content::encode_png(picture)}) {
        std::ofstream(file, std::ios::binary) << text;
        EXPECT_FALSE(read_thumbnail(folder, "/b.glib")) << text.size();
    }
    std::filesystem::remove(file);
    mkfifo(file.c_str(), 0600);
    EXPECT_FALSE(read_thumbnail(folder, "/b.glib")) << "nor is a pipe waited for";
    keep_thumbnail("", "/a.glib", picture);  // without a home
    keep_thumbnail("/proc/none", "/a.glib", picture);
}

TEST(WindowSettings, ComeBack) {
    const Scratch folder;
    const std::string file = folder.path("new/folder/window.json");
    EXPECT_EQ(read_settings(file), Settings{});
    Settings settings;
    settings.theme = ui::Theme::contrast;
    settings.zoom = 1.5;
    settings.panel_width = 30;
    settings.tools = true;
    settings.editor = "code -n";
    settings.open = {"Costs", "Files"};
    settings.width = 1024;
    settings.height = 768;
    settings.recent = {"/a.glib", "/b \xC3\xA4.glib"};
    ASSERT_EQ(write_settings(file, settings), "");
    EXPECT_EQ(read_settings(file), settings);
    EXPECT_EQ(folder.entries(), 3u) << "nothing is left beside it";
    ui::Memory memory;
    restore(settings, "/x/../a.glib", memory);
    Settings again;
    gather(memory, again);
    EXPECT_TRUE(again.tools);
    ui::Memory next;
    carry_looks(memory, next);
    EXPECT_EQ(next.tab, ui::Tab::controls) << "another scene begins with its sliders";
    restore(settings, "/c.glib", next);
    EXPECT_EQ(next.tab, ui::Tab::controls) << "also in the next window";
    EXPECT_EQ(again.theme, ui::Theme::contrast);
    EXPECT_EQ(again.zoom, 1.5);
    EXPECT_EQ(again.open, settings.open);
}

TEST(WindowSettings, TheThemeOfEarlierVersionsIsStillRead) {
    const Scratch folder;
    for (const auto& [text, theme] : {std::pair(R"({"dark": true})", ui::Theme::dark),
                                      {R"({"dark": false})", ui::Theme::light},
                                      {R"({"theme": "contrast", "dark": true})", ui::Theme::contrast},
                                      {R"({"theme": "?"})", ui::Theme::light}}) {
        folder.write("window.json", text);
        EXPECT_EQ(read_settings(folder.path("window.json")).theme, theme) << text;
    }
}

TEST(WindowSettings, WhatIsDamagedIsAsInAFirstRun) {
    const Scratch folder;
    for (const char* text : {"", "{", "[1]", "null", R"({"zoom": 1e300, "panel_width": -1, "width": "x", "recent": 5})",
                             R"({"zoom": 0, "open": [1, {}], "recent": [null], "height": 1e9})"})
        EXPECT_EQ(read_settings(folder.write("window.json", text)), Settings{}) << text;
}

TEST(WindowSettings, TwoWindowsShareTheListOfScenes) {
    const Scratch folder;
    const std::string file = folder.path("window.json");
    Settings one, two;
    remember(one.recent, "/one.glib");
    remember(two.recent, "/two.glib");
    ASSERT_EQ(write_settings(file, one), "");
    ASSERT_EQ(write_settings(file, two), "");
    EXPECT_EQ(read_settings(file).recent, (Names{"/two.glib", "/one.glib"}));
    remember(two.recent, "/x/../three.glib");
    remember(two.recent, "/two.glib");
    EXPECT_EQ(two.recent, (Names{"/two.glib", "/three.glib"}));
    for (int i = 0; i < 50; ++i) remember(two.recent, "/" + std::to_string(i));
    EXPECT_EQ(two.recent.size(), most_recent);
}

TEST(DroppedFiles, TheFirstSceneAmongThemIsOpened) {
    const Scratch folder;
    const std::string scene = folder.write("a.glib", ""), text = folder.write("a.txt", "");
    Opener opener(folder.path("window.json"));
    ui::Memory memory;
    EXPECT_EQ(opener.serve_dropped({text, scene}, memory), scene);
    EXPECT_EQ(opener.serve_dropped({folder.path("B.GLIB")}, memory), folder.path("B.GLIB")) << "as on Windows";
    EXPECT_EQ(opener.serve_dropped({text}, memory), std::nullopt);
    ASSERT_EQ(memory.failures.open.size(), 1U);
    EXPECT_NE(memory.failures.open[0].text.find("a.txt"), std::string::npos);
    EXPECT_FALSE(memory.browser.open);
    EXPECT_EQ(opener.serve_dropped({folder.path()}, memory), std::nullopt);
    EXPECT_TRUE(memory.browser.open) << "a folder is looked into";
    ui::Facts facts;
    opener.tell(facts, scene, {scene, text, folder.path() + "/x/../../shared/b.bmp", "/usr/share/c.bmp"}, false);
    EXPECT_EQ(names(*facts.listing), Names{"a.glib"});
    ASSERT_EQ(facts.files.size(), 4u);
    EXPECT_EQ(facts.files[1].name, "a.txt") << "from the scene's folder";
    EXPECT_EQ(facts.files[2].name, "../shared/b.bmp");
}

}  // namespace
}  // namespace snell
