#include "src/document/document.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "parser/read/parse.h"
#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/plan/locate.h"
#include "src/plan/plan.h"

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

std::unique_ptr<Document> open_beside(const Document& scene, const gl::Caps& caps, const RungChooser& choose,
                                      std::map<std::string, std::string> texts, std::string& error) {
    RuntimeOptions options;
    options.previous = &*scene.runtime;
    auto document =
        open_document(scene.path, caps, choose, nullptr, options, scene.files->access().with(std::move(texts)));
    if (document->runtime && no_new_errors(scene.diagnostics, document->diagnostics)) return document;
    const Diagnostic* const first = first_error(document->diagnostics);
    error = first ? first->message : "it cannot be drawn";
    return nullptr;
}

std::unique_ptr<Document> compile_document(const std::string& path, const Plan& plan, const Sources& sources,
                                           const Controls& controls, const gl::Caps& caps, const Access& access,
                                           const RuntimeOptions& options) {
    auto document = std::make_unique<Document>();
    document->path = path;
    document->files = std::make_unique<Files>(scene_folder(path), access);
    document->sources = sources;
    document->runtime.emplace(plan, *document->files, document->sources, caps, document->diagnostics, options);
    document->controls = document->runtime->controls();
    document->diagnostics.append(document->runtime->value_problems());
    carry_over(controls, plan.scene, document->controls, document->scene());
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

const Diagnostic* first_error(const Diagnostics& diagnostics) {
    const auto error = ranges::find(diagnostics.items(), Severity::error, &Diagnostic::severity);
    return error == diagnostics.items().end() ? nullptr : &*error;
}

Diagnostics errors_of(const Diagnostics& diagnostics) {
    Diagnostics errors;
    for (const Diagnostic& diagnostic : diagnostics.items())
        if (diagnostic.severity == Severity::error) errors.add(diagnostic);
    return errors;
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

namespace {

namespace fs = std::filesystem;

// Returns the scene as it would be read after saving.
Scene read_again(const Document& document, const std::vector<SavedFile>& files) {
    std::map<std::string, std::string_view, std::less<>> texts;
    for (FileId file = 0; file < document.sources.size(); ++file)
        texts.emplace(document.sources.name(file), document.sources.text(file));
    for (const SavedFile& file : files) texts[file.path] = file.after;
    const auto include = [&](std::string_view from, std::string_view name) -> std::optional<IncludedText> {
        const std::string path = document.files->resolve_beside(from, name, scene_extensions()).path;
        const auto text = texts.find(path);
        if (text == texts.end()) return std::nullopt;
        return IncludedText{path, std::string(text->second)};
    };
    Sources sources;
    const FileId file = sources.add(document.path, std::string(texts[document.path]));
    return parse(file, sources, include).scene;
}

// Returns the files of the scene that it would not find from another folder.
std::string not_found_from(const fs::path& folder, const Document& document) {
    const fs::path old = fs::path(document.path).parent_path().lexically_normal();
    std::string lost;
    std::error_code error;
    for (const std::string& path : document.files->read_paths()) {
        const fs::path relative = fs::path(path).lexically_normal().lexically_relative(old);
        const bool whole =  // it is named by its path
            fs::path(path).is_absolute() && document.sources.text(0).find(path) != std::string_view::npos;
        if (path == document.path || whole || (!relative.empty() && fs::exists(folder / relative, error))) continue;
        lost += (lost.empty() ? "" : ", ") + fs::path(path).filename().string();
    }
    return lost;
}

}  // namespace

std::size_t changed_values(const Document& document, std::span<const Animated> moving) {
    const auto moves = [&](const Control& control, std::size_t component) {
        return ranges::any_of(moving, [&](const Animated& motion) { return motion.moves(control, component); });
    };
    const auto& rungs = document.controls.rungs;
    std::size_t count = 0;
    for (const Control& control : document.controls.items) {
        bool changed = control.value.size() != control.initial.size();
        for (std::size_t i = 0; !changed && i < control.value.size(); ++i)
            changed = control.value[i] != control.initial[i] && !moves(control, i);
        count += changed;
    }
    for (std::size_t i = 0; i < rungs.size() && i < document.scene().ladders.size(); ++i)
        count += rungs[i] != document.scene().ladders[i].current;
    return count;
}

namespace {

// The new texts, whatever the files on the disk are now.
Saved new_texts(const Document& document, std::span<const Animated> moving) {
    Saved saved;
    if (!document.runtime) {
        saved.error = "the scene cannot be read";
        return saved;
    }
    WriteBack back = write_back(document.scene(), at_rest(document.controls, moving), document.sources);
    saved.unwritten = std::move(back.unwritten);
    for (Index i = 0; i < back.programs.size(); ++i)
        for (std::size_t u = 0; u < back.programs[i].uniforms.size(); ++u) {
            const UniformValue &before = document.scene().programs[i].uniforms[u],
                               &after = back.programs[i].uniforms[u];
            if (after.kind != UniformValue::Kind::range) continue;
            for (const std::size_t end : {0, 2})
                if (after.values[end] != before.values[end])
                    saved.widened.push_back(fmt::format("{} widened to {}", after.name, after.values[end]));
        }
    for (const Animated& motion : moving)
        if (ranges::find(saved.moving, motion.name) == saved.moving.end()) saved.moving.push_back(motion.name);
    const std::size_t changed = changed_values(document, moving);
    saved.values = changed - std::min(changed, saved.unwritten.size());
    for (FileId file = 0; file < document.sources.size(); ++file) {
        const auto edits = ranges::count(back.edits, file, [](const Edit& edit) { return edit.span.file; });
        if (edits == 0) continue;
        const std::string_view before = document.sources.text(file);
        saved.files.push_back(
            {std::string(document.sources.name(file)), std::string(before), with_edits(before, file, back.edits)});
    }
    if (!reads_back(back, read_again(document, saved.files))) {
        saved.error = "the new text would not say these values: nothing is written";
        saved.files.clear();
    }
    return saved;
}

}  // namespace

Saved saved_values(const Document& document, std::span<const Animated> moving) {
    Saved saved = new_texts(document, moving);
    std::error_code error;
    const auto check_there = [&](const std::string& path) {
        const bool there = fs::exists(path, error);
        if (!there)
            saved.error =
                utf8::printable(path) + " is gone: save as another file, which writes the scene as snell has it";
        return there;
    };
    if (check_there(document.path))  // also where no value was changed
        for (const SavedFile& file : saved.files)
            if (check_there(file.path) && content::whole_file(file.path) != file.before)
                saved.error = utf8::printable(file.path) +
                              " has changed since it was read: reload it, or correct its errors, first";
    if (!saved.error.empty()) saved.files.clear();
    return saved;
}

SavedAs saved_as(const Document& document, const std::string& name, std::span<const Animated> moving) {
    const Saved saved = new_texts(document, moving);
    SavedAs as{{{}, {}, std::string(document.sources.text(0))}, false, saved.error, saved.moving};
    const fs::path given = fs::path(name).filename();
    if (as.error.empty() && (given.empty() || given == "." || given == "..")) as.error = "the scene needs a name";
    if (!as.error.empty()) return as;
    const fs::path old_folder = fs::path(document.path).parent_path();
    const fs::path path = old_folder / name;
    as.file.path = path.lexically_normal().string();
    std::error_code error;
    as.exists = fs::exists(path, error);
    if (fs::equivalent(path, document.path, error))
        as.error = "this is the scene itself, which is saved without another name";
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const bool gone = !old_folder.empty() && !fs::is_directory(old_folder, error);
    as.missing = as.error.empty() && !gone && !fs::exists(folder, error);
    if (as.error.empty() && !fs::is_directory(folder, error))
        as.error = fmt::format("there is no folder {}{}", folder.string(),
                               gone ? " any more: give the path of another one, such as ~/" + given.string() : "");
    // Where the folder is gone, nowhere else has its files: the text is what can be rescued.
    const bool moves = !gone && path.parent_path().lexically_normal() != old_folder.lexically_normal();
    const std::string lost = as.error.empty() && moves ? not_found_from(folder, document) : "";
    as.lacks = !lost.empty();
    if (as.lacks) as.error = "the scene would not find " + lost + " from there";
    for (const SavedFile& file : saved.files) {
        as.texts[file.path] = file.after;
        if (file.path == document.path)
            as.file.after = file.after;
        else if (as.error.empty())
            as.error = utf8::printable(fs::path(file.path).filename().string()) +
                       " has some of these values: save them there first";
    }
    return as;
}

}  // namespace snell
