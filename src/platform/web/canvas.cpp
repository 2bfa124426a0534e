#include "src/platform/web/canvas.h"

#include <emscripten.h>
#include <emscripten/html5.h>

// The tables in which Emscripten keeps the browser's objects by their names in C++.
// clang-format off
EM_JS(void, snell_forget_objects, (), {
    for (const table of [GL.buffers, GL.framebuffers, GL.programs, GL.queries, GL.renderbuffers, GL.samplers, GL.shaders,
                         GL.syncs, GL.textures, GL.vaos])
        table.fill(null);
});
// clang-format on

namespace snell {

std::unique_ptr<CanvasContext> CanvasContext::make(const std::string& canvas, std::string& error) {
    EmscriptenWebGLContextAttributes wanted;
    emscripten_webgl_init_context_attributes(&wanted);
    wanted.majorVersion = 2;
    wanted.enableExtensionsByDefault = true;
    std::unique_ptr<CanvasContext> made(new CanvasContext(canvas));
    made->handle_ = emscripten_webgl_create_context(canvas.c_str(), &wanted);
    if (made->handle_ <= 0 || emscripten_webgl_make_context_current(made->handle_) != EMSCRIPTEN_RESULT_SUCCESS) {
        error =
            "this browser has no WebGL 2 here; switch on hardware acceleration in its settings, or use another browser";
        return nullptr;
    }
    return made;
}

CanvasContext::~CanvasContext() {
    if (handle_ > 0) emscripten_webgl_destroy_context(handle_);
}

void CanvasContext::forget_objects() { snell_forget_objects(); }

bool CanvasContext::lost() const { return emscripten_is_webgl_context_lost(handle_); }

void CanvasContext::resize(int width, int height) const {
    int now_width = 0, now_height = 0;
    emscripten_get_canvas_element_size(canvas_.c_str(), &now_width, &now_height);
    if (now_width != width || now_height != height) emscripten_set_canvas_element_size(canvas_.c_str(), width, height);
}

}  // namespace snell
