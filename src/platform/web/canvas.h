// A WebGL 2 context on a canvas of the page.
#pragma once

#include <memory>
#include <string>

namespace snell {

// The context is current from the moment it is made until it is destroyed.
class CanvasContext {
public:
    // `canvas` is a CSS selector, or a name that the page gave the canvas in Emscripten's table of event targets.
    // Returns null and sets `error` if the browser makes no such context.
    static std::unique_ptr<CanvasContext> make(const std::string& canvas, std::string& error);
    ~CanvasContext();
    CanvasContext(const CanvasContext&) = delete;
    CanvasContext& operator=(const CanvasContext&) = delete;

    // Forgets all objects of contexts that were lost, whose names in C++ may then be deleted without effect.
    static void forget_objects();

    // True from the moment that the browser takes the context away. When it gives the canvas back, call
    // forget_objects, and make another CanvasContext.
    bool lost() const;
    // Changes the number of pixels of the canvas, which clears it.
    void resize(int width, int height) const;

private:
    explicit CanvasContext(std::string canvas) : canvas_(std::move(canvas)) {}
    std::string canvas_;
    long handle_ = 0;
};

}  // namespace snell
