#include "src/runtime/resources/store.h"

namespace snell::runtime {

void say_again(const Said& said, std::span<const Span> places, Diagnostics& diagnostics) {
    const auto moved = [&](const Span& span) {
        const auto old = ranges::find(said.places, span);
        const auto at = static_cast<std::size_t>(old - said.places.begin());
        return at < std::min(said.places.size(), places.size()) ? places[at] : span;
    };
    for (Diagnostic diagnostic : said.items) {
        diagnostic.span = moved(diagnostic.span);
        for (Note& note : diagnostic.notes) note.span = moved(note.span);
        for (Span& span : diagnostic.also) span = moved(span);
        diagnostics.add(std::move(diagnostic));
    }
}

void Store::prune() {
    textures.prune();
    harmonics.prune();
    meshes.prune();
    trees.prune();
    shaders.prune();
    programs.prune();
}

}  // namespace snell::runtime
