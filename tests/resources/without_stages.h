// Scenes drawn by the driver's stages, and without them.
#pragma once

#include "tests/harness/harness.h"

namespace snell::test {

class Stages : public GlTest {
protected:
    // How many pixels are others by more than 8 of 255.
    static int far(const Picture& a, const Picture& b) {
        int count = 0;
        for (int y = 0; y < a.height; ++y)
            for (int x = 0; x < a.width; ++x) count += near(a.at(x, y), b.at(x, y), 8) ? 0 : 1;
        return count;
    }

    // Returns what the driver's stages draw.
    template <class Opened>
    Picture compare(const Opened& opened) {
        const gl::Caps whole = caps;
        const auto native = opened();
        gl::leave_stages(caps);
        const auto emulated = opened();
        caps = whole;
        expect_clean(*native);
        expect_clean(*emulated);
        Picture picture = draw(*native);
        EXPECT_EQ(far(picture, draw(*emulated)), 0);
        return picture;
    }

    // A scene from a seed, whose files it writes into the folder.
    using Random = std::function<std::string(unsigned seed, bool es, Folder& folder)>;

    // Draws so many of them, or as many as the environment says.
    void compare_random(const char* variable, int all, unsigned first, const Random& random) {
        if (const char* const wanted = std::getenv(variable)) all = std::atoi(wanted);
        int drawn = 0;
        for (int i = 0; i < all; ++i) {
            SCOPED_TRACE(first + static_cast<unsigned>(i));
            const std::string scene = random(first + static_cast<unsigned>(i), caps.es, folder);
            const Picture picture = compare([&] { return open(scene); });
            drawn += picture.count({0, 0, 0, 0}) < picture.width * picture.height ? 1 : 0;
        }
        EXPECT_GT(drawn, all / 2) << "most of them draw something";
    }
};

class StagesEs : public Stages {
protected:
    StagesEs() { request.es = true; }
};

}  // namespace snell::test
