// The pictures of docs/language.md are the cases, drawn. To draw anew those that are missing or differ, and look at
// them:
//   SNELL_UPDATE_PICTURES=1 ./build/release/bin/pictures_tests --gtest_filter='Pictures.*'
#include "parser/commands/commands.h"
#include "src/content/image/image.h"
#include "tests/harness/harness.h"

namespace snell::test {
namespace {

constexpr int page_side = 160;

class Pictures : public GlTest {};

content::Image rgb(const Picture& picture) {
    content::Image image;
    image.width = picture.width;
    image.height = picture.height;
    image.channels = 3;
    image.pixels.resize(picture.rgba.size() / 4 * 3);
    for (size_t i = 0; i < picture.rgba.size() / 4; ++i) std::memcpy(&image.pixels[i * 3], &picture.rgba[i * 4], 3);
    return image;
}

content::Image stored(const std::string& path) {
    auto result = content::decode_image(path, bytes_of(path));
    return result.image ? *result.image : content::Image{};
}

// Correct drivers differ in isolated pixels, by much; on the whole, by little.
testing::AssertionResult shows(const content::Image& old, const content::Image& image) {
    if (old.pixels.size() != image.pixels.size())
        return testing::AssertionFailure() << "no picture, or of another size";
    int far = 0;
    double squares = 0;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const int difference = std::to_integer<int>(image.pixels[i]) - std::to_integer<int>(old.pixels[i]);
        far += std::abs(difference) > 2;
        squares += difference * difference;
    }
    const double count = static_cast<double>(image.pixels.size());
    const double share = far / count, rmse = std::sqrt(squares / count) / 255;
    if (share <= .005 && rmse <= .02) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "a share of " << share << " differs, RMSE " << rmse;
}

TEST_F(Pictures, ShowWhatTheCasesDraw) {
    const bool update = std::getenv("SNELL_UPDATE_PICTURES") != nullptr;
    for (const Command& command : commands()) {
        SCOPED_TRACE(command.name);
        auto document = open_file(SNELL_ROOT "/tests/cases/" + std::string(command.name) + ".glib");
        expect_clean(*document);
        const content::Image image =
            rgb(draw(*document, {.width = page_side, .height = page_side, .samples = 4, .time = 1.3}));
        const std::string path = SNELL_ROOT "/docs/images/" + std::string(command.name) + ".png";
        const testing::AssertionResult same = shows(stored(path), image);
        if (update && !same) {
            EXPECT_EQ(content::write_image(path, image), "");
        } else {
            EXPECT_TRUE(same) << path;
        }
    }
}

}  // namespace
}  // namespace snell::test
