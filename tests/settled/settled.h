// Scenes whose programs are compiled for values.
#pragma once

#include "src/plan/values/controls.h"
#include "tests/harness/plain.h"

namespace snell::test {

class SettledTest : public PlainTest {
protected:
    // Programs are compiled for the values of the text, after these assignments.
    static RuntimeOptions settled_for(std::vector<std::string> sets = {}) {
        RuntimeOptions options;
        options.settle = [sets = std::move(sets)](Controls& controls, const Scene& scene) {
            Diagnostics unheard;
            for (const std::string& set : sets) set_control(controls, scene, set, unheard);
        };
        return options;
    }
    std::unique_ptr<Document> open_settled(const std::string& path, std::vector<std::string> sets = {}) {
        return open_document(path, caps, nullptr, nullptr, settled_for(std::move(sets)));
    }
    std::unique_ptr<Document> settle(std::string_view scene, std::vector<std::string> sets = {}) {
        folder.write("scene.glib", scene);
        return open_settled(folder.path("scene.glib"), std::move(sets));
    }
    // The largest difference of a channel, of 255.
    static int difference(const Picture& a, const Picture& b) {
        int most = a.rgba.size() == b.rgba.size() ? 0 : 255;
        for (std::size_t i = 0; i < std::min(a.rgba.size(), b.rgba.size()); ++i)
            most = std::max(most, std::abs(std::to_integer<int>(a.rgba[i]) - std::to_integer<int>(b.rgba[i])));
        return most;
    }
};

}  // namespace snell::test
