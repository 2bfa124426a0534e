#include "src/document/unsampled.h"

#include <algorithm>
#include <utility>

#include "parser/text/ranges.h"
#include "src/plan/plan.h"

namespace snell {

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
