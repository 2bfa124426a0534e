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

// With twelve images, t0.bmp to t11.bmp.
class ImagesTest : public SettledTest {
protected:
    void SetUp() override {
        SettledTest::SetUp();
        for (int i = 0; i < 12; ++i)
            folder.write("t" + std::to_string(i) + ".bmp",
                         bmp(4, 4, std::vector<std::array<int, 3>>(16, {20 * i, 90, 30})));
    }
    // A quad over the whole picture, by a fragment shader.
    std::string quad(std::string_view declarations, std::string_view body, std::string_view uniforms) {
        folder.write("own.frag", "#version 330 compatibility\nin vec2 vST;\n" + std::string(declarations) +
                                     "\nvoid main() {\n" + std::string(body) + "\n}\n");
        return "Ortho -1 1 -1 1\nVertex plain.vert\nFragment own.frag\nProgram P " + std::string(uniforms) +
               "\nQuadXY\n";
    }
};

}  // namespace snell::test
