#include "src/app/open/headless.h"

#include <fmt/format.h>

#include "src/app/open/complain.h"
#include "src/app/open/ending.h"
#include "src/gl/context.h"

namespace snell::app {

bool parse_context(const std::string& text, ContextRequest& request) {
    std::string version = text;
    request.es = version.starts_with("es");
    if (request.es) version.erase(0, 2);
    if (version.empty()) return true;
    if (version.size() != 3 || version[1] != '.' || version[0] < '1' || version[0] > '9' || version[2] < '0' ||
        version[2] > '9')
        return false;
    request.version = (version[0] - '0') * 10 + (version[2] - '0');
    return true;
}

std::unique_ptr<HeadlessContext> headless_context(const std::string& text) {
    ContextRequest request;
    parse_context(text, request);
#ifndef NDEBUG
    request.debug = true;
#endif
    std::string error;
    auto context = HeadlessContext::make(request, error);
    if (!context) {
        if (short_of_memory(whole_driver)) out_of_memory();
        const bool old = error.find("context") != std::string::npos;
        const std::string missing = HeadlessContext::missing_package();
        complain("no graphics: " + error,
                 old ? "snell needs OpenGL 3.3 or OpenGL ES 3.0, or the version that --context asks for"
                 : missing.empty()
                     ? "Mesa's EGL and drivers are installed; a variable such as LIBGL_DRIVERS_PATH may hide "
                       "them, and EGL_LOG_LEVEL=debug prints more"
                     : fmt::format("{} is missing: install it", missing));
    }
    // The process ends with it: to take it apart costs a sixteenth of what a small picture does.
    if (context) context->keep();
    static const gl::MessageReport print = [](const char* message) {
        complain(fmt::format("OpenGL driver: {}", message));
    };
    if (context && request.debug) gl::watch_messages(print);
    return context;
}

}  // namespace snell::app
