// Scenes from text, drawn headless, looked at pixel by pixel.
#pragma once

#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/gl/target.h"
#include "src/plan/view.h"
#include "src/platform/headless.h"
#include "tests/scratch.h"
#include "tests/std.h"

namespace snell::test {

using Pixel = std::array<int, 4>;

struct Picture {
    int width = 0, height = 0;
    std::vector<std::byte> rgba;  // rows top first
    Pixel at(int x, int y) const;
    Pixel center() const { return at(width / 2, height / 2); }
    // How many pixels are within `tolerance` of a colour (alpha aside).
    int count(const Pixel& color, int tolerance = 2) const;
    bool operator==(const Picture&) const = default;
};

bool near(const Pixel& a, const Pixel& b, int tolerance = 2);

using Folder = Scratch;

struct Look {
    int width = 64, height = 64, samples = 1;
    double time = 0;
    View view;
    std::vector<std::string> sets;
    int enlarged = 1;  // as Frame::enlarged
};

// Every test that draws derives from this. A context of the best version; any GL error or driver complaint
// fails the test. Skips where there is no EGL.
class GlTest : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    // The scene's text is written as scene.glib into `folder`, with a preamble of nothing.
    std::unique_ptr<Document> open(std::string_view scene);
    std::unique_ptr<Document> open_file(const std::string& path);
    Picture draw(Document& document, const Look& look = {});
    Picture draw(std::string_view scene, const Look& look = {});
    // Fails for every GL error and complaint of the driver so far, and forgets them.
    void expect_quiet();
    // No error among the diagnostics, else the test fails with their text.
    static void expect_clean(const Document& document);
    static bool has(const Document& document, std::string_view code);

    Folder folder;
    ContextRequest request{0, false, false, true};
    std::unique_ptr<HeadlessContext> context;
    gl::Caps caps;
    std::vector<std::string> complaints;
    gl::MessageReport report = [this](const char* message) { complaints.emplace_back(message); };
};

// OpenGL 3.3, 4.5 and ES 3.2, for tests with a context as parameter, and the parameter's name.
inline const auto all_contexts =
    testing::Values(ContextRequest{33, false, false, true}, ContextRequest{45, false, false, true},
                    ContextRequest{32, true, false, true});
inline std::string context_name(const testing::TestParamInfo<ContextRequest>& context) {
    return (context.param.es ? "Es" : "Core") + std::to_string(context.param.version);
}

// Shaders that tests use again and again.
inline constexpr std::string_view plain_vertex =
    "#version 330 compatibility\nout vec2 vST;\nvoid main() { vST = gl_MultiTexCoord0.st; "
    "gl_Position = gl_ModelViewProjectionMatrix * gl_Vertex; }\n";
inline constexpr std::string_view color_fragment =
    "#version 330 compatibility\nuniform vec4 uColor;\nvoid main() { gl_FragColor = uColor; }\n";
inline constexpr std::string_view texture_fragment =
    "#version 330 compatibility\nuniform sampler2D uUnit;\nin vec2 vST;\n"
    "void main() { gl_FragColor = texture(uUnit, vST); }\n";

// A 24-bit BMP of the colours given, rows top first.
std::string bmp(int width, int height, const std::vector<std::array<int, 3>>& pixels);

}  // namespace snell::test
