// What was made, by what it was made of: a scene that is read again takes over what did not change.
#pragma once

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "parser/text/diagnostic.h"
#include "parser/text/ranges.h"
#include "src/content/cube/convolve.h"
#include "src/gl/handle.h"

namespace snell::runtime {

// What was said when something was made, and of which places in the text: of the same statements elsewhere the same
// is to be said.
struct Said {
    std::vector<Diagnostic> items;
    std::vector<Span> places;
};

// Spans among `places` become those of the same number.
inline void say_again(const Said& said, std::span<const Span> places, Diagnostics& diagnostics) {
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

// Holds nothing itself: what the last scene lets go of is gone.
template <class Resource>
class Shelf {
public:
    // Null: there is none.
    std::shared_ptr<Resource> take(const std::string& key, std::span<const Span> places, Diagnostics& diagnostics) {
        const auto found = entries_.find(key);
        auto resource = found == entries_.end() ? nullptr : found->second.resource.lock();
        if (resource) say_again(found->second.said, places, diagnostics);
        return resource;
    }

    // What was said about it is in `diagnostics` from `first` on. What has errors is made anew every time.
    void put(const std::string& key, const std::shared_ptr<Resource>& resource, std::span<const Span> places,
             const Diagnostics& diagnostics, std::size_t first) {
        const auto said = std::span(diagnostics.items()).subspan(first);
        if (key.empty() || ranges::any_of(said, [](const Diagnostic& d) { return d.severity == Severity::error; }))
            return;
        entries_[key] = {resource, {{said.begin(), said.end()}, {places.begin(), places.end()}}};
    }

    bool has(const std::string& key) const {
        const auto found = entries_.find(key);
        return found != entries_.end() && !found->second.resource.expired();
    }

    void prune() {
        std::erase_if(entries_, [](const auto& entry) { return entry.second.resource.expired(); });
    }

private:
    struct Entry {
        std::weak_ptr<Resource> resource;
        Said said;
    };
    std::map<std::string, Entry> entries_;
};

struct GpuMesh;
struct GpuTexture;
struct GpuTree;
struct LinkedProgram;

struct Store {
    Shelf<GpuTexture> textures;
    Shelf<content::Harmonics> harmonics;
    Shelf<GpuMesh> meshes;
    Shelf<GpuTree> trees;
    Shelf<gl::Shader> shaders;
    Shelf<LinkedProgram> programs;

    void prune() {
        textures.prune();
        harmonics.prune();
        meshes.prune();
        trees.prune();
        shaders.prune();
        programs.prune();
    }
};

}  // namespace snell::runtime
