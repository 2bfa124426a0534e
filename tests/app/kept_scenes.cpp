// What is kept of each scene: it comes back to the same bits, and nothing on the disk does harm.
#include "src/app/desktop/settings.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include <sys/stat.h>

#include "tests/plan/uniforms.h"
#include "tests/scratch.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

class KeptScenes : public testing::Test {
protected:
    std::string scene(const std::string& name) const { return disk_.write(name, "Sphere\n"); }
    std::string file() const {
        for (const auto& entry : fs::directory_iterator(folder_)) return entry.path().string();
        return {};
    }
    std::size_t files() const {
        const fs::directory_iterator all(folder_);
        return static_cast<std::size_t>(std::distance(begin(all), end(all)));
    }
    static Remembered some(double value = .1) {
        return {{{"--set Glass.uEta", numbers_text({value, 1. / 3, 1e-300})},
                 {"--range Glass.uEta", "-3,500"},
                 {"--ladder F", "exact"},
                 {"--view rotate_x", "30"},
                 {"--view object2.y", "0.5"},
                 {"--axes", "off"}},
                {{"--set Glass.uEta", "0.5,0.5,0.5"},
                 {"--range Glass.uEta", "0,1"},
                 {"--ladder F", "cheap"},
                 {"--view object2", "Torus=#0"}}};
    }

    Scratch disk_;
    std::string folder_ = disk_.path("state/scenes");
};

TEST_F(KeptScenes, WhatIsNoFileIsLeftAlone) {
    const std::string one = scene("one.glib");
    ASSERT_EQ(write_kept(folder_, one, some()), "");
    const std::string kept = file();
    fs::remove(kept);
    ASSERT_EQ(mkfifo(kept.c_str(), 0600), 0);
    EXPECT_NE(write_kept(folder_, one, some()), "") << "and it does not wait for a reader";
    EXPECT_EQ(read_kept(folder_, one), Remembered{});
    EXPECT_TRUE(fs::is_fifo(kept));
    fs::remove(kept);
    ASSERT_EQ(write_kept(folder_, one, some()), "");
}

TEST_F(KeptScenes, ComeBackToTheSameBits) {
    const std::string one = scene("one.glib"), two = scene("two.glib");
    EXPECT_EQ(read_kept(folder_, one), Remembered{});
    ASSERT_EQ(write_kept(folder_, one, some()), "");
    EXPECT_EQ(read_kept(folder_, one), some());
    EXPECT_EQ(read_kept(folder_, two), Remembered{});
    write_kept(folder_, one, {});
    EXPECT_EQ(files(), 0U) << "nothing is kept: there is no file";
    EXPECT_EQ(write_kept("", one, some()), "") << "without a home folder";
    EXPECT_EQ(read_kept("", one), Remembered{});
}

TEST_F(KeptScenes, AreNamedByTheirPathWithoutLinks) {
    const std::string one = scene("folder/one.glib");
    fs::create_directory_symlink(disk_.path("folder"), disk_.path("link"));
    fs::create_symlink(one, disk_.path("other.glib"));
    write_kept(folder_, one, some());
    EXPECT_EQ(read_kept(folder_, disk_.path("link/one.glib")), some());
    EXPECT_EQ(read_kept(folder_, disk_.path("other.glib")), some());
    EXPECT_EQ(read_kept(folder_, disk_.path("folder/../folder/one.glib")), some());
}

TEST_F(KeptScenes, DamagedOrHugeFilesAreAsNone) {
    const std::string one = scene("one.glib");
    write_kept(folder_, one, some());
    const std::string path = file(), fine = bytes_of(path);
    const auto put = [&](const std::string& text) { std::ofstream(path, std::ios::binary) << text; };
    for (const std::string& text :
         {std::string(), std::string("null"), std::string("[]"), std::string("{"), std::string(200000, '['),
          std::string(R"({"scene": 7})"), std::string("\xFF\xFE\0", 3), std::string("scene /another\n\n\n"),
          std::string("scene"), fine.substr(0, fine.find('\n') + 1), fine + std::string(300000, ' ')}) {
        put(text);
        EXPECT_EQ(read_kept(folder_, one), Remembered{}) << text.substr(0, 20);
    }
    std::mt19937 random(3);
    const Scene read = scene_with({{"Glass", {value_of("uEta", UniformValue::Kind::color, {.5, .5, .5})}}});
    ActiveUniform uniform = active("vec3");
    uniform.name = "uEta";
    for (int i = 0; i < 500; ++i) {  // any damage: no crash, and no value that is none
        std::string text = fine;
        for (int k = 0; k < 3; ++k) text[random() % text.size()] = "\n=,. -#0e9x\xFF"[random() % 12];
        put(text);
        Diagnostics ignored;
        Controls controls = make_controls(read, {{uniform}}, ignored);
        recall(read_kept(folder_, one), read, controls, Follow::memory);
        View view;
        apply_setup(read_kept(folder_, one).chosen, view);
        ASSERT_EQ(controls.items[0].value.size(), 3U);
        for (const double number : controls.items[0].value) EXPECT_TRUE(std::isfinite(number)) << text;
        EXPECT_TRUE(std::isfinite(view.scene.rotate_x)) << text;
    }
    fs::remove(path);
    fs::create_directory(path);
    EXPECT_EQ(read_kept(folder_, one), Remembered{});
    EXPECT_NE(write_kept(folder_, one, some()), "") << "a folder is in the way";
}

TEST_F(KeptScenes, TheOldestOfTooManyGo) {
    std::vector<std::string> scenes;
    for (std::size_t i = 0; i < most_kept_scenes; ++i) {
        scenes.push_back(scene("s" + std::to_string(i) + ".glib"));
        ASSERT_EQ(write_kept(folder_, scenes.back(), some()), "");
    }
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(1);
    for (const auto& entry : fs::directory_iterator(folder_)) fs::last_write_time(entry.path(), old);
    write_kept(folder_, scenes[7], some(.2));  // it was open since
    for (std::size_t i = 0; i + 1 < most_kept_scenes; ++i)
        write_kept(folder_, scene("t" + std::to_string(i) + ".glib"), some());
    EXPECT_EQ(files(), most_kept_scenes);
    EXPECT_EQ(read_kept(folder_, scenes[7]), some(.2));
    EXPECT_EQ(read_kept(folder_, scenes[8]), Remembered{});
}

TEST_F(KeptScenes, ReadingOneCountsAsUse) {
    const std::string one = scene("one.glib");
    write_kept(folder_, one, some());
    const auto old = fs::file_time_type::clock::now() - std::chrono::hours(24);
    fs::last_write_time(file(), old);
    EXPECT_EQ(read_kept(folder_, one), some());
    EXPECT_GT(fs::last_write_time(file()), old + std::chrono::hours(23));
}

TEST_F(KeptScenes, TooMuchOfOneSceneIsNotKept) {
    const std::string one = scene("one.glib");
    write_kept(folder_, one, some());
    Remembered much;
    for (int i = 0; i < 9000; ++i) much.chosen["--set P.u" + std::to_string(i)] = numbers_text({1. / 3, 1, 2});
    EXPECT_EQ(write_kept(folder_, one, much), "");
    EXPECT_EQ(read_kept(folder_, one), Remembered{}) << "and not the values of before either";
}

TEST_F(KeptScenes, WindowsThatWriteAtOnceLeaveWholeFiles) {
    const std::string one = scene("one.glib");
    write_kept(folder_, one, some());
    std::thread writer([&] {
        for (int i = 0; i < 300; ++i) write_kept(folder_, one, some(i + 1));
    });
    for (int i = 0; i < 300; ++i) EXPECT_EQ(read_kept(folder_, one).written, some().written);
    writer.join();
}

}  // namespace
}  // namespace snell
