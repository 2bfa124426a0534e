// A scene as a page opens it: by WebGL 2, which is OpenGL ES 3.0.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/document/document.h"
#include "src/gl/caps.h"
#include "src/platform/headless.h"

namespace snell::app {

// What the page begins with, as the command line says it.
struct Start {
    std::vector<std::string> sets, ladders;
    std::string quality, view;
};

// Both contexts of a command, made when they are first needed.
class PageContexts {
public:
    explicit PageContexts(std::string native) : native_request_(std::move(native)) {}
    // Each makes its context current and returns its capabilities, or nullopt after it printed why there is none. What
    // was made in the one must be destroyed before the other is asked for.
    std::optional<gl::Caps> web();
    std::optional<gl::Caps> native();

private:
    std::string native_request_;
    std::unique_ptr<HeadlessContext> web_, native_;
};

// A context of OpenGL ES 3.0 at best, whatever more the driver has.
gl::Caps web_caps(gl::Caps caps);

struct OpenedScene {
    std::unique_ptr<Document> document;  // null without graphics; with values, rungs and view of the start
    View view;
    std::string text;         // all errors and warnings
    std::string first_error;  // the message of the first one; "" if there is none
    bool fits = false;        // there are no errors
};
OpenedScene opened_scene(const std::string& scene, const Start& start, const gl::Caps& caps, const Access& access);

// The diagnostic in one line, without the folder, whose name would tell of the author's machine.
std::string short_text(const Diagnostic& diagnostic, const Sources& sources);

// Values, rungs and view that differ from the scene's own, as Engine::open of web/page/engine.ts takes them.
struct StartTexts {
    std::vector<std::string> values, rungs;
    std::string view;
};
StartTexts start_texts(const Document& document, const View& view);

}  // namespace snell::app
