// embed SCENE PICTURE.ppm: draws a scene into a framebuffer of this program.
#include <cstdio>
#include <vector>

#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/platform/headless.h"

// Any current context of OpenGL 3.3 or OpenGL ES 3 will do: here one without a window.
#include <snell_opengl.h>

namespace {

constexpr int width = 320, height = 240;

unsigned make_framebuffer() {
    GLuint framebuffer = 0, buffers[2];
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, buffers);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[0]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, buffers[0]);
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[1]);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, buffers[1]);
    return framebuffer;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    std::string error;
    const auto context = snell::HeadlessContext::make({}, error);
    if (!context) return std::fprintf(stderr, "no graphics: %s\n", error.c_str()), 3;

    const auto document = snell::open_document(argv[1], snell::gl::query_caps());
    std::fputs(snell::render(document->diagnostics, document->sources).c_str(), stderr);
    if (!document->runtime) return 1;

    const unsigned framebuffer = make_framebuffer();
    const snell::View view;
    const snell::Surface surface{.framebuffer = framebuffer, .width = width, .height = height};
    document->runtime->draw({.time = 0, .view = view, .controls = document->controls}, surface);

    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * height * 4);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
    std::FILE* file = std::fopen(argv[2], "wb");
    if (!file) return 1;
    std::fprintf(file, "P6\n%d %d\n255\n", width, height);
    for (int y = height; y-- > 0;)
        for (int x = 0; x < width; ++x) std::fwrite(&pixels[static_cast<std::size_t>(y * width + x) * 4], 1, 3, file);
    return std::fclose(file) == 0 ? 0 : 1;
}
