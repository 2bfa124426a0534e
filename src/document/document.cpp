#include "src/document/document.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/gl/debug.h"
#include "src/plan/plan.h"
#include "src/plan/texts.h"

namespace snell {

namespace {

// An error of OpenGL means that a texture or a mesh may be missing.
void report_gl_errors(Diagnostics& diagnostics) {
    for (const std::string& error : gl::take_errors())
        if (error == "GL_OUT_OF_MEMORY")
            diagnostics.error(
                "out-of-graphics-memory", "OpenGL has not enough memory for everything that the scene loads",
                "smaller textures and fewer vertices take less; --limit texture-bytes=N refuses large ones");
        else
            diagnostics.warning("opengl-error", "loading made an error of OpenGL: " + error);
}

}  // namespace

std::vector<std::string> files_read_by(const std::string& path, const Access& access) {
    Files files(scene_folder(path), access);
    Sources sources;
    Diagnostics unheard(access.limits);  // these are reported when the scene is opened
    const auto plan = read_plan(path, files, sources, unheard);
    return plan ? used_files(*plan, sources, files) : std::vector<std::string>();
}

Access access_to(const std::string& path, Access access, bool grade) {
    if (grade && !access.confine) access.confine = scene_folder(path);
    return access;
}

std::unique_ptr<Document> open_document(const std::string& path, const gl::Caps& caps, const RungChooser& choose,
                                        const PlanReader& planned, const RuntimeOptions& options,
                                        const Access& access) {
    auto document = std::make_unique<Document>();
    document->diagnostics = Diagnostics(access.limits);
    document->path = path;
    document->files = std::make_unique<Files>(scene_folder(path), access);
    auto plan = read_plan(path, *document->files, document->sources, document->diagnostics);
    if (!plan) return document;
    if (choose) choose(plan->scene, plan->rungs);
    if (planned) planned(*plan, *document);
    document->runtime.emplace(std::move(*plan), *document->files, document->sources, caps, document->diagnostics,
                              options);
    report_gl_errors(document->diagnostics);
    document->controls = document->runtime->controls();
    document->diagnostics.append(document->runtime->value_problems());
    excuse_unsampled(*document);
    document->diagnostics.sort();
    return document;
}

bool follow_rungs(Document& document) {
    Runtime& runtime = *document.runtime;
    if (!runtime.choose(document.controls.rungs)) return false;
    Controls controls = runtime.controls();
    carry_over(document.controls, runtime.scene(), controls, runtime.scene());
    document.controls = std::move(controls);
    return true;
}

bool no_new_errors(const Diagnostics& before, const Diagnostics& now) {
    return ranges::all_of(now.items(), [&](const Diagnostic& error) {
        return error.severity != Severity::error || ranges::any_of(before.items(), [&](const Diagnostic& old) {
                   return old.severity == Severity::error && old.code == error.code && old.message == error.message;
               });
    });
}

std::string verbose_report(const Document& document) {
    std::string report;
    if (!document.runtime) return report;
    for (const std::string& path : document.files->read_paths())
        report += fmt::format("read {}\n", utf8::printable(path));
    const Scene& scene = document.scene();
    for (size_t i = 0; i < scene.programs.size(); ++i) {
        report += fmt::format("program '{}':", scene.programs[i].name);
        for (const ActiveUniform& uniform : document.runtime->active_uniforms()[i])
            report += fmt::format(" {} {}{}", uniform.glsl_type, uniform.name, uniform.system ? " (set by snell)" : "");
        report += '\n';
    }
    const Counters& c = document.runtime->counters();
    report += fmt::format(
        "{} draws in {} passes, {} programs, {} images decoded, {} textures, about {} bytes of GPU memory\n",
        scene.draws.size(), scene.passes.size(), c.programs_compiled, c.images_decoded, c.textures, c.gpu_bytes);
    return report;
}

namespace {

bool about_unsampled(const Document& document, const Diagnostic& diagnostic) {
    // A file outside of the folder that reading is confined to stays an error, even if nothing samples it.
    if (diagnostic.code != "file-not-found") return false;
    const auto& textures = document.scene().textures;
    const auto unsampled = [&](const Span& span) {
        for (Index i = 0; i < textures.size(); ++i)
            if (ranges::find(textures[i].files, span, &FileName::span) != textures[i].files.end() &&
                !document.runtime->sampled(i))
                return true;
        return false;
    };
    return unsampled(diagnostic.span) && ranges::all_of(diagnostic.also, unsampled);
}

bool known(const Diagnostics& diagnostics, const Diagnostic& diagnostic) {
    return ranges::any_of(diagnostics.items(),
                          [&](const Diagnostic& other) { return other.is_at(diagnostic.code, diagnostic.span); });
}

}  // namespace

void excuse_unsampled(Document& document) {
    if (!document.diagnostics.has_errors() || !document.scene().ladders.empty()) return;
    Diagnostics excused(document.files->limits());
    for (Diagnostic diagnostic : document.diagnostics.items()) {
        if (diagnostic.severity == Severity::error) {
            if (!about_unsampled(document, diagnostic)) return;
            diagnostic.severity = Severity::note;
            diagnostic.help += diagnostic.help.empty() ? "nothing samples it" : "; nothing samples it";
        }
        excused.add(std::move(diagnostic));
    }
    document.diagnostics = std::move(excused);
}

void check_unsampled(Document& document) {
    if (!document.runtime) return;
    const Scene& scene = document.scene();
    ImageCache images;
    Diagnostics found;
    for (Index i = 0; i < scene.textures.size(); ++i) {
        if (scene.textures[i].files.empty() || document.runtime->sampled(i)) continue;
        if (scene.textures[i].target == TextureTarget::cube)
            load_cube(scene, i, *document.files, found, &images);
        else
            load_texture(scene, i, *document.files, found, &images);
    }
    for (Diagnostic diagnostic : found.items()) {
        if (known(document.diagnostics, diagnostic)) continue;
        diagnostic.severity = std::min(diagnostic.severity, Severity::warning);
        if (diagnostic.help.empty()) diagnostic.help = "nothing samples it: the picture is the same";
        document.diagnostics.add(std::move(diagnostic));
    }
    document.diagnostics.sort();
}

}  // namespace snell
