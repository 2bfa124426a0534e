// A scene as changes leave it: opened again with other texts, drawn, and compared with the scene as it is.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/accuracy/found/search.h"
#include "src/accuracy/timing.h"
#include "src/runtime/resources/counters.h"

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

    // The size that quick ratios are of: the largest, up to that of the scene's picture, whose frames are fast. In
    // small pictures, work that does not depend on pixels counts for more. At least the present size.
    std::array<int, 2> quick_size(std::array<int, 2> whole, ClockKind clock);
    // The ratio of its time to that of the scene as it is, by a few frames in turn; 0: not known. `high`:
    // two of three are no larger. `warm`: the milliseconds of its frames, in the size that it is timed in. Leaves the
    // scene in that size.
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

// The steps of a search. Each is a task; a task may put others ahead of those that wait.

// When each part of the search must end, as parts of its time: what is left over goes to the next.
inline constexpr double singles_end = .42, combinations_end = .52, held_out_end = .62, times_end = .86,
                        unused_end = .94;

inline constexpr std::size_t few_finalists = 4;  // that are timed, if possible, whatever else there is no time for

// A rung that is drawn, a place in each step.
struct Attempt {
    Trial trial;
    std::size_t rung = 0;  // index into FoundResult::rungs
    std::size_t to = 0;    // places
    // Then `then` is called, with FoundRung::at as far as it got.
    std::function<void(Attempt&)> then;
};

struct Search::Impl {
    Impl(const Original& scene, std::vector<Change> changes, const gl::Caps& caps, const BenchSettings& how,
         SearchOptions wanted);

    // ---- search.cpp: the order of things, pictures, combinations and places that are held out -------------------
    void plan();
    bool step();
    bool advance();
    void soon(std::function<void()> task) { tasks.push_front(std::move(task)); }
    double spent() const;
    double left(double part) const { return part * options.seconds - spent(); }
    bool stopped();
    bool over(double part) { return stopped() || left(part) <= 0; }
    void say(std::string_view what, double done);
    const char* out_of_time() const { return result.interrupted ? "the search was stopped" : "the time was up"; }
    bool skipped(FoundRung& rung, double part);
    FoundRung& rung_of(const Attempt& attempt) { return result.rungs[attempt.rung]; }

    void open();
    void give_up(const std::string& reason);
    bool is_broken(std::size_t place);
    void small() { trials->resize(result.search_width, result.search_height); }
    void whole() { trials->resize(settings.width, settings.height); }
    void try_places(Trial trial, std::size_t rung, std::size_t to, std::function<void(Attempt&)> then);
    void draw_on(const std::shared_ptr<Attempt>& attempt);
    void draw_next(Attempt& attempt);
    void try_rung(std::size_t i, double part, std::function<void()> then);
    bool useful(const FoundRung& rung) const;
    void begin_combinations();
    void combine();
    void begin_hold_out();
    void hold_out(std::size_t i);
    void find_flip(Trial& trial, FoundRung& rung, std::size_t place);

    // ---- times, and what may be left out ------------------------------------------------------------------
    void begin_times();
    std::size_t fitting(std::size_t most, double part, std::array<int, 2>& size);
    void begin_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part, std::array<int, 2> size);
    void start_rounds(SweepResult& sweep, const std::vector<std::size_t>& of, double part, std::array<int, 2> size);
    void end_rounds();
    void omission(std::size_t i);
    bool is_set(const Change& change) const;
    void omitted(Attempt& attempt);
    void load(std::size_t i, std::vector<Loading> with, std::vector<Loading> without);
    void begin_costs();

    Original original;
    SearchOptions options;
    BenchSettings settings;
    FoundResult result;
    std::optional<Trials> trials;
    std::optional<Climbs> climbs;
    std::map<std::size_t, Trial> kept, finalists;  // by index into result.rungs
    std::optional<Rounds> rounds;
    SweepResult* timing = nullptr;
    ClockKind clock = ClockKind::wall;
    std::string_view doing = "opening the scene";
    std::deque<std::function<void()>> tasks;
    double before = 0;  // seconds of the steps before this one
    runtime::Stopwatch entered;
};

inline double rmse_of(const FoundRung& rung) { return rung.worst()->own.light.rmse; }
inline double flip_of(const FoundRung& rung) { return rung.flip().value_or(1); }

}  // namespace snell::accuracy
