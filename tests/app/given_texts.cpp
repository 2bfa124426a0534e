// Texts that an editor gives: each holds until its file is saved.
#include <gtest/gtest.h>

#include "src/app/desktop/watch.h"
#include "tests/scratch.h"

namespace snell {
namespace {

using Texts = std::map<std::string, std::string>;

Access given(Texts texts) {
    Access access;
    access.instead = std::make_shared<const Texts>(std::move(texts));
    return access;
}

void save(const Scratch& folder, const std::string& name, const std::string& text) {
    const std::string path = folder.write(name, text);
    const auto now = std::filesystem::last_write_time(path);
    std::filesystem::last_write_time(path, now + std::chrono::seconds(1));  // clocks of file systems are coarse
}

TEST(GivenTexts, HoldUntilTheirFilesAreSaved) {
    const Scratch folder;
    const std::string a = folder.write("a", "1"), b = folder.write("b", "2");
    Access access = given({{a, "one"}, {b, "two"}});
    const GivenTexts texts(access);
    texts.remove_saved(access);
    EXPECT_EQ(*access.instead, (Texts{{a, "one"}, {b, "two"}}));
    save(folder, "a", "once");
    texts.remove_saved(access);
    EXPECT_EQ(*access.instead, (Texts{{b, "two"}}));
}

// Otherwise the window could not write values into files that an editor only shows.
TEST(GivenTexts, OfFilesThatSayTheSameAreNotKept) {
    const Scratch folder;
    const std::string a = folder.write("a", "1"), marked = folder.write("b",
                                                                        "\xEF\xBB\xBF"
                                                                        "2");
    Access access = given({{a, "1"}, {marked, "2"}});
    GivenTexts(access).remove_saved(access);
    EXPECT_TRUE(access.instead->empty());
}

TEST(GivenTexts, NoneAreNone) {
    Access access;
    GivenTexts(access).remove_saved(access);
    EXPECT_EQ(access.instead, nullptr);
}

}  // namespace
}  // namespace snell
