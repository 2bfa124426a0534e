#include "tests/harness/harness.h"
#include "src/gl/context.h"

namespace snell::test {

Pixel Picture::at(int x, int y) const {
    Pixel pixel{};
    const size_t at = (static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)) * 4;
    for (size_t i = 0; i < 4; ++i) pixel[i] = std::to_integer<int>(rgba.at(at + i));
    return pixel;
}

bool near(const Pixel& a, const Pixel& b, int tolerance) {
    for (size_t i = 0; i < 3; ++i)
        if (std::abs(a[i] - b[i]) > tolerance) return false;
    return true;
}

int Picture::count(const Pixel& color, int tolerance) const {
    int found = 0;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) found += near(at(x, y), color, tolerance);
    return found;
}

void GlTest::SetUp() {
    std::string error;
    context = HeadlessContext::make(request, error);
    if (!context) GTEST_SKIP() << "no graphics: " << error;
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    // For the rows of hard cases. The version that was asked for: drivers give more.
    const int version = request.version ? request.version : major * 10 + minor;
    RecordProperty("context", std::string(request.es ? "ES " : "GL ") + std::to_string(version / 10) + "." +
                                  std::to_string(version % 10));
    caps = gl::query_caps();
    gl::watch_messages(report);
}

void GlTest::TearDown() {
    if (context) expect_quiet();
}

void GlTest::expect_quiet() {
    for (const std::string& error : gl::take_errors()) ADD_FAILURE() << error;
    for (const std::string& complaint : complaints) ADD_FAILURE() << "the driver: " << complaint;
    complaints.clear();
}

std::unique_ptr<Document> GlTest::open(std::string_view scene) {
    folder.write("scene.glib", scene);
    return open_file(folder.path("scene.glib"));
}

std::unique_ptr<Document> GlTest::open_file(const std::string& path) { return open_document(path, caps); }

Picture GlTest::draw(Document& document, const Look& look) {
    Picture picture{look.width, look.height, {}};
    if (!document.runtime) {
        ADD_FAILURE() << "nothing to draw: " << render(document.diagnostics, document.sources);
        picture.rgba.resize(static_cast<size_t>(look.width * look.height) * 4);
        return picture;
    }
    Diagnostics problems;
    for (const std::string& set : look.sets) set_control(document.controls, document.scene(), set, problems);
    EXPECT_FALSE(problems.has_errors()) << render(problems, document.sources);
    const gl::Target target =
        gl::make_target(look.width, look.height, look.samples, document.runtime->display_pixels());
    Frame frame{look.time, look.view, document.controls};
    frame.enlarged = look.enlarged;
    document.runtime->draw(frame, {target.framebuffer.get(), look.width, look.height});
    picture.rgba = gl::read_rgba8(target.framebuffer.get(), look.width, look.height, target.samples, target.pixels);
    return picture;
}

Picture GlTest::draw(std::string_view scene, const Look& look) {
    auto document = open(scene);
    expect_clean(*document);
    return draw(*document, look);
}

void GlTest::expect_clean(const Document& document) {
    EXPECT_FALSE(document.diagnostics.has_errors()) << render(document.diagnostics, document.sources);
}

bool GlTest::has(const Document& document, std::string_view code) {
    for (const Diagnostic& diagnostic : document.diagnostics.items())
        if (diagnostic.code == code) return true;
    return false;
}

std::string bmp(int width, int height, const std::vector<std::array<int, 3>>& pixels) {
    const int row = (width * 3 + 3) / 4 * 4;
    std::string out(54 + static_cast<size_t>(row * height), '\0');
    const auto put = [&out](size_t at, unsigned value, int bytes) {
        for (int i = 0; i < bytes; ++i) out[at + static_cast<size_t>(i)] = static_cast<char>(value >> (8 * i) & 255);
    };
    out[0] = 'B';
    out[1] = 'M';
    put(2, static_cast<unsigned>(out.size()), 4);
    put(10, 54, 4);
    put(14, 40, 4);
    put(18, static_cast<unsigned>(width), 4);
    put(22, static_cast<unsigned>(height), 4);
    put(26, 1, 2);
    put(28, 24, 2);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 3; ++c)
                out[54 + static_cast<size_t>((height - 1 - y) * row + x * 3 + 2 - c)] =
                    static_cast<char>(pixels[static_cast<size_t>(y * width + x)][static_cast<size_t>(c)]);
    return out;
}

}  // namespace snell::test
