// A folder for the program's files, and graphics, without which the test is skipped.
#pragma once

#include "src/content/image/image.h"
#include "tests/cli/run.h"
#include "tests/harness/harness.h"

namespace snell::test {

// An image without pixels where there is none.
inline content::Image picture_of(const std::string& path) {
    auto result = content::decode_image(path, bytes_of(path));
    return result.image ? std::move(*result.image) : content::Image{};
}

class CommandTest : public testing::Test {
protected:
    void SetUp() override {
        static const std::string missing = [] {
            std::string error;
            return HeadlessContext::make({}, error) ? "" : "no graphics: " + error;
        }();
        if (!missing.empty()) GTEST_SKIP() << missing;
    }
    std::string at(const std::string& name) const { return folder.path(name); }
    content::Image picture(const std::string& name) const { return picture_of(at(name)); }

    Folder folder;
};

}  // namespace snell::test
