// A scene as changes leave it: opened again with other texts, drawn, and compared with the scene as it is.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "src/accuracy/found/search.h"
#include "src/accuracy/rounds.h"

namespace snell::accuracy {

struct Trial {
    std::string refused;  // why it is not worth drawing; empty if it is
    std::unique_ptr<Files> files;
    std::unique_ptr<Sources> sources;
    std::unique_ptr<Bench> bench;
    Diagnostics problems;
};

// What opening a scene took.
struct Loading {
    double milliseconds = 0;  // of the process where it is judged by that, otherwise by the wall clock
    std::uint64_t bytes_decoded = 0;
};

// Tries changes of one scene. Pictures of the scene as it is are kept.
class Trials {
public:
    // `original` and `changes` must outlive this.
    Trials(const Original& original, std::span<const Change> changes, const gl::Caps& caps,
           const BenchSettings& settings);

    // Opens the scene as it is, and makes the places: it tells what sliders there are.
    void open_scene(const PlaceOptions& options);
    const std::vector<Place>& places() const { return places_; }
    // Why nothing can be compared with the scene as it is; empty: it has no errors.
    std::string scene_error() const;
    // Draws at its own place, in the size of the settings, until told otherwise.
    Bench& scene() { return *scene_.bench; }
    // All pictures are of this size from now on.
    void resize(int width, int height);

    // Opens the scene with these changes, which are compatible; with none, as it is. `shared`: with the textures,
    // meshes and programs of the scene as it is.
    Trial open(std::span<const std::size_t> changes, bool shared = true);
    std::optional<Picture> picture(Trial& trial, std::size_t place);
    const Picture& original(std::size_t place);
    // The difference of that picture at a place, over the pixels in which the scene draws, the same for all changes,
    // and those that differ; `only_changed`: over the latter alone. `flip`: with FLIP.
    Difference compare(const Picture& picture, std::size_t place, bool only_changed, bool flip);

    // The ratio of its time to that of the scene as it is, by a few frames in turn; 0: not known. `high`:
    // two of three are no larger. `warm`: the milliseconds of its frames.
    struct Quick {
        double middle = 0, high = 0;
    };
    Quick quick_ratio(Trial& trial, double warm, ClockKind clock, const Stop& stop);
    // Times frames of that size.
    Entrant entrant(Bench& bench, std::array<int, 2> size) const;
    // What plots and tables show: the error of the worst place, and the picture of the scene's own.
    RungResult summary(const FoundRung& rung, Trial& trial);
    RungResult scene_summary();
    // How many bytes of GPU memory the scene as it is takes more.
    std::int64_t saved_memory(Trial& trial);
    // Opens the scene with these changes, sharing nothing.
    Loading load(std::span<const std::size_t> changes, ClockKind clock);

    // Of the scene with its own rungs.
    Variant variant() const { return {original_.plan.rungs, {}}; }

private:
    void judge(Trial& trial) const;
    Place seen_by(Trial& trial, std::size_t place) const;
    // The pixels in which the scene as it is draws; empty: all.
    const Region& region(std::size_t place);

    Original original_;
    std::span<const Change> changes_;
    gl::Caps caps_;
    BenchSettings settings_;
    std::vector<Place> places_;
    Trial scene_;  // as it is
    // By place and size.
    using Key = std::array<std::size_t, 3>;
    Key key(std::size_t place) const;
    std::map<Key, Picture> pictures_;
    std::map<Key, Region> regions_;
};

}  // namespace snell::accuracy
