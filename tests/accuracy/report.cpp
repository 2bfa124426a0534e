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

TEST(Report, PageShowsTheNameOfTheScene) {
    const std::string page = markdown_text({{}, {sweep_of_two_rungs()}, {}}, {});
    EXPECT_NE(page.find("## a&lt;b&gt;&amp;c.glib: "), std::string::npos) << page;
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
