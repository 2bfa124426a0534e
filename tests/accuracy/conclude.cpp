// What is concluded from errors and times that are written here.
#include <gtest/gtest.h>

#include <cmath>

#include "src/accuracy/report/report.h"

namespace snell::accuracy {
namespace {

SweepResult ladder_of(std::initializer_list<const char*> names) {
    SweepResult result;
    result.own_pixels = 1;
    for (const char* name : names) {
        result.sweep.rungs.push_back({name, {}, {}, {}});
        result.rungs.push_back({.name = name, .drawn = true});
    }
    result.sweep.reference = names.size() - 1;
    return result;
}

// A rung that looks nothing up has no direction, which is no angle of 0.
TEST(Conclusions, ARungWithoutDirectionsIsNotTheMostExact) {
    SweepResult result = ladder_of({"none", "far", "exact"});
    result.rungs[0].own.light.rmse = .3;
    result.rungs[0].degrees = Degrees{std::nan(""), std::nan(""), std::nan(""), 0};
    result.rungs[1].own.light.rmse = .1;
    result.rungs[1].degrees = Degrees{20, 20, 20, 5};
    result.rungs[2].degrees = Degrees{0, 0, 0, 5};
    conclude(result, {}, 1);
    EXPECT_EQ(result.metric, Metric::rmse) << "angles don't rank all of them";
    EXPECT_GT(result.error(result.rungs[0]), result.error(result.rungs[1]));
    EXPECT_TRUE(result.rungs[1].saturated);
    for (const std::string& text :
         {table_text(result), html_text({{}, {result}, {}}), markdown_text({{}, {result}, {}}, {})})
        EXPECT_EQ(text.find("nan"), std::string::npos) << text;
}

// As of everything together, where each combination is compared with a picture that is none of them.
TEST(Conclusions, TheSceneDoesNotUseAReferenceThatIsNoRung) {
    SweepResult result = ladder_of({"scene", "cheap"});
    result.sweep.reference = 2;
    result.reference = {1, 1, {1, 1, 1, 1}};
    for (RungResult& rung : result.rungs) rung.wall = std::vector<double>(9, &rung == &result.rungs[0] ? 4. : 2.);
    result.rungs[0].own.light.rmse = .1;
    conclude(result, result.rungs[0].wall, 1);
    ASSERT_TRUE(result.trusted());
    const std::string words = in_words(result);
    EXPECT_TRUE(words.starts_with("The best value is 'cheap': ")) << words;
    EXPECT_EQ(words.find("reference"), std::string::npos) << words;
}

// Counts that were not drawn may be as wrong as any.
TEST(Conclusions, WhatCountsLeaveIsNotKnownWithoutTheLastOnes) {
    for (const std::size_t missing : {std::size_t{4}, std::size_t{2}, std::size_t{1}}) {
        SweepResult result = ladder_of({"1", "2", "4", "8"});
        result.sweep.numeric = true;
        result.residual = 1e-4;
        for (std::size_t i = 0; i < 3; ++i) result.rungs[i].alone.rmse = .1 * std::exp2(-static_cast<double>(i));
        if (missing < 4) result.rungs[missing] = {.name = "missing"};
        conclude(result, {}, 1);
        EXPECT_EQ(result.residual.has_value(), missing == 4) << missing << ": " << result.reference_note;
        EXPECT_EQ(result.reference_note.find("not known") != std::string::npos, missing < 4) << result.reference_note;
    }
}

}  // namespace
}  // namespace snell::accuracy
