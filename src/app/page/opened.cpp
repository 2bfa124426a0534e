#include "src/app/page/opened.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/open/headless.h"
#include "src/app/open/quality.h"
#include "src/plan/setup.h"

namespace snell::app {

namespace {

std::optional<gl::Caps> current_caps(std::unique_ptr<HeadlessContext>& context, const std::string& request) {
    if (!context) context = headless_context(request);
    if (!context || !context->make_current()) return std::nullopt;
    return gl::query_caps();
}

}  // namespace

std::optional<gl::Caps> PageContexts::web() {
    const auto caps = current_caps(web_, "es3.0");
    return caps ? std::optional(web_caps(*caps)) : std::nullopt;
}

std::optional<gl::Caps> PageContexts::native() { return current_caps(native_, native_request_); }

gl::Caps web_caps(gl::Caps caps) {
    caps.version = "WebGL 2";
    caps.glsl = 300;
    caps.fp64 = caps.geometry = caps.tessellation = caps.program_interface_query = false;
    caps.max_line_width = 1;
    return caps;
}

OpenedScene opened_scene(const std::string& scene, const Start& start, const gl::Caps& caps, const Access& access) {
    OpenedScene opened;
    Diagnostics problems;
    const auto choose = [&](const Scene& read, Rungs& rungs) {
        choose_rungs(scene, {start.quality, start.ladders, {}}, access, read, rungs, problems);
    };
    opened.document = open_document(scene, caps, choose, nullptr, {}, access);
    Document& document = *opened.document;
    if (document.runtime) {
        document.controls.rungs = document.runtime->rungs();
        for (const std::string& set : start.sets) set_control(document.controls, document.scene(), set, problems);
    }
    parse_view(start.view, opened.view);
    problems.append(document.diagnostics);
    Diagnostics shown;
    for (const Diagnostic& diagnostic : problems.items())
        if (diagnostic.severity != Severity::note) shown.add(diagnostic);
    opened.text = snell::render(shown, document.sources);
    const auto error = ranges::find(problems.items(), Severity::error, &Diagnostic::severity);
    opened.fits = error == problems.items().end();
    if (!opened.fits) {
        opened.first_error = short_text(*error, document.sources);
    }
    return opened;
}

std::string short_text(const Diagnostic& error, const Sources& sources) {
    if (!error.has_span) return utf8::printable(error.message);
    const Position at = sources.position(error.span.file, error.span.begin);
    const std::string name = std::filesystem::path(sources.name(error.span.file)).filename().string();
    return utf8::printable(fmt::format("{}:{}:{}: {}", name, at.line, at.column, error.message));
}

StartTexts start_texts(const Document& document, const View& view) {
    const Setup changed = changed_setup(document.scene(), document.controls);
    return {set_arguments(document.scene(), document.controls), arguments_of(changed, ladder_option), view_text(view)};
}

}  // namespace snell::app
