// Which pictures a sweep has: values, names, shards.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "src/app/batch/shots.h"
#include "src/content/html_page.h"

namespace snell::app {

namespace {

Axis axis(const std::string& text) {
    std::string error;
    const auto parsed = parse_axis(text, error);
    EXPECT_TRUE(parsed) << error;
    return parsed.value_or(Axis{});
}

std::string axis_error(const std::string& text) {
    std::string error;
    EXPECT_FALSE(parse_axis(text, error)) << text;
    return error;
}

std::vector<std::string> files(const std::vector<std::string>& axes, const std::string& pattern) {
    std::vector<Axis> parsed;
    for (const std::string& text : axes) parsed.push_back(axis(text));
    std::string error;
    const auto shots = plan_shots({"scenes/room.glib"}, parsed, pattern, error);
    EXPECT_TRUE(shots) << error;
    return shots ? shots->files : std::vector<std::string>{};
}

std::string pattern_error(const std::vector<std::string>& scenes, const std::vector<std::string>& axes,
                          const std::string& pattern) {
    std::vector<Axis> parsed;
    for (const std::string& text : axes) parsed.push_back(axis(text));
    std::string error;
    EXPECT_FALSE(plan_shots(scenes, parsed, pattern, error)) << pattern;
    return error;
}

// Tenths and the like come out as a person would write them, which is the double nearest to them.
TEST(CliShots, RangesHaveBothEndsAndTheNearestNumbersBetween) {
    const Axis eta = axis("uEta=1.0:2.5:16");
    ASSERT_EQ(eta.values.size(), 16U);
    for (std::size_t k = 0; k < 16; ++k) {
        const std::string decimal = std::to_string((10 + k) / 10) + "." + std::to_string((10 + k) % 10);
        EXPECT_EQ(*eta.values[k].number, std::strtod(decimal.c_str(), nullptr));
    }
    EXPECT_EQ(*axis("u=.1:.9:9").values[2].number, .3);
    EXPECT_EQ(*axis("u=-1e-3:7e30:3").values.back().number, 7e30);
    EXPECT_EQ(*axis("u=1e308:-1e308:5").values[2].number, 0.) << "no overflow on the way";
    EXPECT_EQ(axis("u=3:3:1").values.size(), 1U);
    EXPECT_EQ(*axis("u=2:1:2").values[0].number, 2.) << "downwards";
}

TEST(CliShots, ListsAreNumbersWordsAndVectors) {
    const Axis color = axis("uColor=[1,0,0], [.5,.5,0]");
    ASSERT_EQ(color.values.size(), 2U);
    EXPECT_EQ(color.values[1].written, "[.5,.5,0]");
    EXPECT_EQ(color.values[1].shown(), ".5,.5,0");
    const Axis mix = axis("uMix=0,0.50,1");
    EXPECT_EQ(mix.values[1].shown(), "0.5");
    EXPECT_EQ(axis("FRESNEL=f0,exact").values[1].written, "exact");
}

TEST(CliShots, WhatIsNoAxisSaysWhy) {
    for (const char* text : {"", "uEta", "=1,2", "uEta=", "uEta=1,,2", "uEta=1,2,", "uEta=1:2", "uEta=1:2:3:4",
                             "uEta=1:2:0", "uEta=1:2:-3", "uEta=1:2:2.5", "uEta=1:2:1", "uEta=a:2:3", "uEta=nan,1",
                             "uEta=1:inf:3", "uEta=1e999,1", "uEta=1:2:1000001", "uEta=1:2:nan"})
        EXPECT_NE(axis_error(text), "") << text;
}

TEST(CliShots, TheLastAxisVariesFastest) {
    EXPECT_EQ(files({"a=1,2", "b=x,y"}, "{stem}/{a}_{b}.png"),
              (std::vector<std::string>{"room/1_x.png", "room/1_y.png", "room/2_x.png", "room/2_y.png"}));
}

TEST(CliShots, PlaceholdersTakeFormats) {
    EXPECT_EQ(files({"a=1,2.345"}, "{{{a:.2f}}}{index:03}.png"),
              (std::vector<std::string>{"{1.00}000.png", "{2.35}001.png"}));
    EXPECT_EQ(files({"n=7"}, "{n:04}.png"), std::vector<std::string>{"0007.png"});
    EXPECT_EQ(files({"n=a/../b"}, "{n}.png"), std::vector<std::string>{"a_.._b.png"}) << "a value is no folder";
    EXPECT_NE(pattern_error({"s"}, {"uEta=1,2"}, "{uEtta}.png").find("did you mean {uEta}?"), std::string::npos);
    for (const char* pattern : {"{uEta", "uEta}.png", "{uEta:.2q}.png", "{}.png", "{uEta:d}{uMix}.png"})
        pattern_error({"s"}, {"uEta=1.5,2"}, pattern);
    for (const char* pattern : {"{n:0999999999}.png", "{n:.999999999f}.png", "{n:99999999999999999999}.png"})
        EXPECT_NE(pattern_error({"s"}, {"n=1,2"}, pattern).find("characters of a file's name"), std::string::npos);
}

TEST(CliShots, TwoPicturesNeverBecomeOneFile) {
    const std::string same = pattern_error({"s"}, {"a=1,2", "b=1,2"}, "{a}.png");
    EXPECT_NE(same.find("{b}"), std::string::npos) << same;
    pattern_error({"s"}, {"a=1.001,1.002"}, "{a:.2f}.png");
    pattern_error({"s"}, {"a=1,1.0"}, "{a}.png");
    pattern_error({"s"}, {"a=1,2", "a=1,2"}, "{index}.png");
    const std::string scenes = pattern_error({"one/s.glib", "two/s.glib"}, {}, "o/{stem}.png");
    EXPECT_NE(scenes.find("'one/s.glib' and 'two/s.glib'"), std::string::npos) << scenes;
    EXPECT_NE(pattern_error({"s"}, {"a=0:1:1000000", "b=1,2"}, "{index}.png").find("1000000"), std::string::npos);
}

TEST(CliShots, FramesAreNumbered) {
    std::string error;
    const auto shots = plan_shots({"a.glib"}, {frames_axis(3)}, "out/f.png", error);
    ASSERT_TRUE(shots) << error;
    EXPECT_EQ(shots->files[2], "out/f-0002.png");
    EXPECT_EQ(plan_shots({"a.glib"}, {frames_axis(3)}, "{frame}.png", error)->files[2], "2.png");
}

// A partition whose parts differ by one, in which no part gets all of one value.
TEST(CliShots, ShardsAreAPartitionInEqualParts) {
    for (const std::size_t pictures : {1U, 7U, 32U, 60U})
        for (const std::size_t count : {1U, 2U, 3U, 8U, 64U}) {
            std::vector<std::size_t> sizes(count);
            for (std::size_t k = 0; k < pictures; ++k) {
                std::size_t owners = 0;
                for (std::size_t index = 0; index < count; ++index) {
                    owners += Shard{index, count}.has(k);
                    sizes[index] += Shard{index, count}.has(k);
                }
                EXPECT_EQ(owners, 1U);
            }
            const auto [least, most] = std::ranges::minmax_element(sizes);
            EXPECT_LE(*most - *least, 1U);
        }
    for (std::size_t index = 0; index < 4; ++index) {  // an axis of 4 values, 4 shards
        std::set<std::size_t> values;
        for (std::size_t k = 0; k < 32; ++k)
            if (Shard{index, 4}.has(k)) values.insert(k % 4);
        EXPECT_EQ(values.size(), 4U);
    }
    for (const char* text : {"", "1", "8/8", "-1/8", "1/0", "a/8", "1/8x", "0x1/8", "/8"})
        EXPECT_FALSE(parse_shard(text));
    EXPECT_EQ(parse_shard("7/8")->index, 7U);
}

// The examples of FIPS 180-4, and the lengths at which the padding changes.
TEST(CliShots, HashesAreSha256) {
    EXPECT_EQ(content::sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(content::sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    EXPECT_EQ(content::sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
              "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    // The longest of one block.
    EXPECT_EQ(content::sha256(std::string(55, 'a')),
              "9f4390f8d30c2dd92ec9f095b65e2b9ae9b0a925a5258e241c9f1e910f734318");
    EXPECT_EQ(content::sha256(std::string(1000000, 'a')),
              "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace

}  // namespace snell::app
