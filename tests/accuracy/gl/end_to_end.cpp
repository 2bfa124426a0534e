// The methods of scenes/light/end-to-end are as far from the reference as such methods were measured to be, by others,
// in a room of the same size, with another pattern on its walls.
#include "tests/accuracy/gl/common.h"

namespace snell::test {
namespace {

using namespace accuracy;

constexpr const char* scenes = SNELL_ROOT "/scenes/light/end-to-end/";

struct Row {
    const char* rung;
    double decibel;
};
// In the order of the ladder.
constexpr Row rows[]{{"o_mirror", 9.0},      {"d_offsets", 13.4},    {"b_defaults", 13.6}, {"r_schlick2", 13.7},
                     {"b_eta", 15.0},        {"single", 13.1},       {"single_box", 14.1}, {"exit", 12.6},
                     {"exit_box", 27.4},     {"sphere_map_2", 36.8}, {"sphere_2", 36.8},   {"sphere_5", 39.8},
                     {"sphere_5_2x2", 48.9}, {"sphere_8_4x4", 58.3}};

class EndToEnd : public AccuracyTest {};

TEST_F(EndToEnd, EveryMethodIsWithinADecibelOfItsDocumentedError) {
    Bench& b = bench_of(std::string(scenes) + "end-to-end.glib", 384, 384);
    const Ladder& ladder = plan().scene.ladders.at(0);
    const std::size_t last = ladder.rungs.size() - 1;
    const auto reference = b.picture({{last}, {}});
    ASSERT_TRUE(reference);
    const std::vector<bool> own = b.draws_of(0);
    const Region disc = where_different(*reference, *b.picture({{last}, {}}, &own));
    double without_exit = 0, with_exit = 0;
    for (std::size_t i = 0; i < std::size(rows); ++i) {
        ASSERT_EQ(ladder.rungs.at(i), rows[i].rung);
        const Error error = compare(*b.picture({{i}, {}}), *reference, disc);
        EXPECT_EQ(error.nonfinite, 0U);
        EXPECT_NEAR(error.display.psnr, rows[i].decibel, 1) << rows[i].rung;
        if (std::string_view(rows[i].rung) == "single_box") without_exit = error.display.psnr;
        if (std::string_view(rows[i].rung) == "exit_box") with_exit = error.display.psnr;
    }
    EXPECT_GT(with_exit, without_exit + 10) << "either correction alone is worth nothing, both are worth everything";
    EXPECT_FALSE(b.problems().has_errors());

    Bench& fine = bench_of(std::string(scenes) + "mesh-120.glib", 384, 384);
    const Error error = compare(*fine.picture({{0}, {}}), *reference, disc);
    EXPECT_NEAR(error.display.psnr, 27.6, 1);
}

}  // namespace
}  // namespace snell::test
