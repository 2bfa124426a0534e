// What reports say of results that are written here by hand.
#include "src/accuracy/report/report.h"

#include <gtest/gtest.h>

#include <cmath>

namespace snell::test {
namespace {

using namespace accuracy;

SweepResult sweep_of_two_rungs() {
    SweepResult result;
    result.scene = "a<b>&c.glib";
    result.own_pixels = 1;
    for (const char* name : {"rough", "exact"}) {
        result.sweep.rungs.push_back({name, {}, {}, {}});
        result.rungs.push_back({.name = name, .drawn = true});
    }
    result.sweep.reference = 1;
    return result;
}

TEST(Report, OnePixelIsSingular) {
    SweepResult sweep = sweep_of_two_rungs();
    sweep.rungs[0].own.nonfinite = 1;
    EXPECT_NE(notes_text(sweep, sweep.rungs[0]).find("1 pixel NaN"), std::string::npos);
    for (const std::string& text :
         {table_text(sweep), html_text({{}, {sweep}, {}}), markdown_text({{}, {sweep}, {}}, {})})
        EXPECT_EQ(text.find("1 pixels"), std::string::npos) << text;
}

// A lattice varies some of them; the others are at their last rungs.
TEST(Report, OtherLaddersAreNotAsInALattice) {
    for (const char* from : {"reference", "scene", "lattice"}) {
        const Report report{.where = {.from = from}, .sweeps = {sweep_of_two_rungs()}};
        const std::string words =
            std::string("ther ladders are as in the ") + (from == std::string("scene") ? "scene" : "reference");
        EXPECT_NE(header_text(report).find(words), std::string::npos) << header_text(report);
        for (const std::string& text : {html_text(report), markdown_text(report, {})})
            EXPECT_EQ(text.find("as in the lattice"), std::string::npos);
    }
}

TEST(Report, PageShowsTheNameOfTheScene) {
    const std::string page = markdown_text({{}, {sweep_of_two_rungs()}, {}}, {});
    EXPECT_NE(page.find("## a&lt;b&gt;&amp;c.glib: "), std::string::npos) << page;
}

// The errors next to them are from the reference, which has finer samples than any rung.
TEST(Report, DifferencesAreThoseFromTheReference) {
    SweepResult sweep = sweep_of_two_rungs();
    sweep.sweep.kind = SweepKind::ladder;
    for (RungResult& rung : sweep.rungs) rung.picture = {1, 1, {.25, .25, .25, 1}};
    const auto shown = [&] {
        const std::string page = html_text({{}, {sweep}, {}});
        const auto source_before = [&](std::string_view alt) {
            const std::size_t end = page.find(alt), begin = page.rfind("src=", end);
            return end == std::string::npos ? "" : page.substr(begin, end - begin);
        };
        const std::string off = source_before("\" alt=\"difference of exact from the reference");
        EXPECT_FALSE(off.empty());
        return off;
    };
    const std::string none = shown();
    sweep.reference = {1, 1, {.75, .75, .75, 1}};
    EXPECT_NE(shown(), none);
}

TEST(Report, PicturesOfAnyShapeAreShown) {
    for (const auto& [width, height] : {std::pair{600, 1}, {1, 600}, {3, 3}}) {
        SweepResult sweep = sweep_of_two_rungs();
        for (RungResult& rung : sweep.rungs)
            rung.picture = {width, height, std::vector<float>(static_cast<std::size_t>(4 * width * height), .5F)};
        const std::string page = html_text({{}, {sweep}, {}});
        EXPECT_NE(page.find("base64,iVBOR"), std::string::npos) << width;
        EXPECT_EQ(page.find("base64,\""), std::string::npos) << width;
    }
}

TEST(Report, UnknownNumbersAreQuestionMarks) {
    SweepResult sweep = sweep_of_two_rungs();
    RungResult& rung = sweep.rungs[0];
    rung.own.light = rung.own.display = rung.whole.light = rung.alone = unknown_figures;
    rung.flip = std::nan("");
    for (const std::string& text :
         {table_text(sweep), html_text({{}, {sweep}, {}}), markdown_text({{}, {sweep}, {}}, {})})
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

}  // namespace
}  // namespace snell::test
