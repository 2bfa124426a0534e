#include "src/document/document.h"

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/utf8.h"
#include "src/document/unsampled.h"
#include "src/gl/debug.h"
#include "src/plan/plan.h"
#include "src/plan/used_files.h"

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
    auto parsed = parse_document(path, files, sources, unheard);
    if (!parsed) return {};
    const Plan plan = make_plan(std::move(parsed->scene), files, sources, unheard);
    return used_files(plan, sources, files);
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
    auto parsed = parse_document(path, *document->files, document->sources, document->diagnostics);
    if (!parsed) return document;
    Plan plan = make_plan(std::move(parsed->scene), *document->files, document->sources, document->diagnostics);
    if (choose) choose(plan.scene, plan.rungs);
    if (planned) planned(plan, *document);
    document->runtime.emplace(std::move(plan), *document->files, document->sources, caps, document->diagnostics,
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

}  // namespace snell
