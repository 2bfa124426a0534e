// Finds rungs: tries every change of a scene at several places, then combinations of those that save time, and times
// what is worth it. Needs a current context, but for places.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "src/accuracy/bench.h"
#include "src/accuracy/found/change.h"
#include "src/accuracy/measure.h"
#include "src/plan/values/controls.h"

namespace snell::accuracy {

// Where changes are tried: views, times and values of sliders, from a seed.

struct PlaceOptions {
    std::size_t searched = 4, held_out = 4;  // how many; the scene's own is the first of those that are searched
    std::uint64_t seed = 1;
};

// Returns places: the scene's own first, then those that are searched, then those that are held out. Each but the first
// turns the view by up to 30° and scales it by .7 to 1.4, and, if `animated`, has another time. Every slider, check box
// and colour of `controls` has other values there, within its range:
//   - Sliders of whole numbers have all values in turn, if there are at most as many as places; otherwise as below.
//   - Check boxes have the other value in every second place, of those that are searched and of those held out.
//   - Others have both ends of the range at one place each and a value in each of equal parts of it at the rest, except
//     for half of the places, where they keep the scene's own value. Each component of a vector has an order of its
//     own.
// What `own` assigns keeps its value. The same arguments give the same places on every machine.
std::vector<Place> make_places(const Controls& controls, const Scene& scene, bool animated, const Place& own,
                               const PlaceOptions& options);

// The uniforms that any of the places assigns and `own` does not, as "Program.uniform".
std::vector<std::string> varying(std::span<const Place> places, const Place& own);

// The place as options of `snell render`, such as "--view rotate_x=12,scale=1.1" and "--set Glass.uEta=1.31".
std::vector<std::string> place_options(const Place& place, const Place& own);
// The same in one line; "the scene's own" for the first.
std::string place_text(const Place& place, const Place& own);

// How much a changed picture differs from that of the scene as it is, at the same place.
struct Difference {
    Error whole, own;                 // over the whole picture, and over the pixels in which the scene draws
    std::size_t pixels_changed = 0;   // in which any channel differs by any bit
    std::optional<double> flip = {};  // mean over `own`; nullopt: not computed, because it is costly
    bool operator<(const Difference& other) const { return own.light.rmse < other.own.light.rmse; }
};

enum class Outcome : std::uint8_t {
    tried,
    refused,    // the changed scene has an error or a warning that the scene has not: FoundRung::reason
    not_tried,  // the time was up, or it was stopped
};

// A change, or a combination of compatible changes, that was tried.
struct FoundRung {
    std::string name;                  // such as "3", or "3+7+12": numbers of changes, from 1
    std::vector<std::size_t> changes;  // indices into FoundResult::changes, ascending
    Aim aim = Aim::cheaper;
    Outcome outcome = Outcome::not_tried;
    std::string reason;  // why it was refused, not tried, or tried but not held out

    // By FoundResult::places; as many as were drawn. For a better change: the error that the scene makes.
    std::vector<Difference> at;
    std::size_t worst_searched = 0, worst_held_out = 0;  // indices into `at`, by the light's RMSE over `own`
    std::size_t pixels_changed = 0;                      // at all places together
    int width = 0, height = 0;                           // of the pictures that were compared
    bool held_out = false;                               // it was drawn at the places that are held out, too
    // It was harmless only where it was searched: its error is not visible there, but at a place that is held out, and
    // more than twice as large. The larger one counts.
    bool only_where_tried = false;

    double quick_ratio = 0;            // of its time to the scene's, by a few frames of quick_size; 0: not known
    bool quicker = false;              // than the scene, as far as these frames tell: beyond their noise
    bool saves = false;                // time, as far as these frames tell; a combination: more than what it adds to
    std::optional<std::size_t> timed;  // index into FoundResult::timed (cheaper) or costs (better, unused)
    // Unused only: what the scene would not need without it.
    std::int64_t gpu_bytes = 0, bytes_decoded = 0;
    std::optional<double> load_ms;  // of loading; 0: less than can be measured; nullopt: not measured

    const Difference* searched() const { return at.empty() ? nullptr : &at[worst_searched]; }
    const Difference* unseen() const { return held_out ? &at[worst_held_out] : nullptr; }
    // The worst of all places; null if it was not drawn.
    const Difference* worst() const;
    std::size_t worst_place() const;
    // The largest mean of FLIP of the places where it was computed: the scene's own, and the worst by RMSE, which may
    // be a place with a few bright pixels; nullopt: not at the worst.
    std::optional<double> flip() const;
};

// Above it, anyone sees the difference: such rungs are folded in reports, and on no plot.
inline constexpr double most_flip = .06;
inline bool plainly_visible(const FoundRung& rung) { return rung.flip() > most_flip; }

// Where the scene as it is has pixels that are not finite.
struct BrokenPlace {
    std::size_t place = 0;  // index into FoundResult::places
    NonFinite pixels;
};

// The errors of the worst place, and whether there are any.
void take_errors(RungResult& shown, const FoundRung& rung);

struct FoundResult {
    std::string scene;  // as the user gave it
    // Why nothing is sought: every rung is refused for this reason. Empty: nothing is wrong with the scene as it is.
    std::string cannot_say;
    std::optional<BrokenPlace> broken;  // the first such place
    std::uint64_t seed = 1;
    std::vector<Change> changes;                   // as find_changes lists them
    std::vector<std::string> positions;            // file:line:column of each change
    std::vector<std::vector<std::string>> others;  // edits of each change at other places: other_edits
    std::vector<Place> places;                     // the scene's own first
    std::size_t searched = 0;                      // how many of the places were searched on; the others are held out
    // One for each change, in their order, then combinations. Of Aim::unused, those that change any pixel have the
    // places up to the first where they do so.
    std::vector<FoundRung> rungs;
    // The times of those that are cheaper and may be on the front, with their verdicts, and the scene as it is, which
    // is the last rung, the reference and the current one. Errors are those of the worst place, FLIP too; pictures are
    // of the scene's own place. Fit for plots, choose() and standing_text().
    SweepResult timed;
    // The times of those that are better, and of those that change no pixel; the scene is the last rung.
    SweepResult costs;
    int width = 0, height = 0;                // of the scene's picture
    int search_width = 0, search_height = 0;  // of the pictures that are compared
    // Of the pictures whose times `timed` and `costs` have: smaller, where frames are slow.
    std::array<int, 2> timed_size{0, 0}, costs_size{0, 0};
    std::array<int, 2> quick_size{0, 0};  // of the pictures of quick_ratio: smaller, where frames are not fast
    bool interrupted = false, late = false;
    bool with_times = true;  // times were wanted

    // The rungs on the front: cheaper, with the cheapest first. The scene itself is not among them.
    std::vector<const FoundRung*> front() const;
    // The times and the standing of a rung; null if it was not timed.
    const RungResult* times(const FoundRung& rung) const;
    const SweepResult& sweep_of(const FoundRung& rung) const { return rung.aim == Aim::cheaper ? timed : costs; }
    const FoundRung* find(std::string_view name) const;
    // What a rung is called: the words of its changes, with the places of those that are called alike.
    std::string words(std::span<const std::size_t> of) const;
    std::string words(const FoundRung& rung) const { return words(rung.changes); }
    // Every rung is refused for this reason: cannot_say.
    void refuse_all(const std::string& reason);
    // What is broken, in words, with the place unless it is the scene's own.
    std::string broken_words() const;
    // Those that change no pixel at any place, and were held out, too.
    std::vector<const FoundRung*> without_effect() const;
};

// The scene whose rungs are sought: what read_plan gave for it, with the rungs that are chosen.
struct Original {
    std::string path;
    const Plan& plan;
    Files& files;
    Sources& sources;
};

struct SearchOptions {
    PlaceOptions places;
    double seconds = 30;
    // Of the times at the end; fewer if they do not fit. All pairs of rungs are compared, so there are more than a
    // ladder needs.
    int rounds = 93;
    bool times = true;
    // The pictures that are compared have at most so many pixels: their sides are halved until then. By the time that
    // is granted, not by what is left of it, so that errors do not depend on the machine.
    std::size_t pixels = 131072;
    double at_least = 20;           // minimum milliseconds of a sample
    std::size_t combinations = 32;  // at most so many are tried
    Stop stop = {};
    std::function<void(const Progress&)> report = {};
};

// What is known before anything is tried: a rung for each change, and the sizes.
FoundResult untried(const Original& original, std::vector<Change> changes, const BenchSettings& settings,
                    const SearchOptions& options);

// A search, a step at a time: one change is tried, or one round is timed. What it draws is the scene's plan with one
// sample a pixel. Errors come first and in a fixed order, so that the single rungs and their errors do not depend on
// time as long as it suffices.
class Search {
public:
    Search(const Original& original, std::vector<Change> changes, const gl::Caps& caps, const BenchSettings& settings,
           SearchOptions options);
    ~Search();
    Search(Search&&) noexcept;

    // False: there is nothing left to do.
    bool step();
    // What is known by now. conclude()d after the last step.
    const FoundResult& result() const;
    FoundResult take();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// All steps of a search, for the changes that find_changes lists.
FoundResult search(const Original& original, const gl::Caps& caps, const BenchSettings& settings,
                   const SearchOptions& options);

// Numbers of changes such as "3+7", as indices from 0; nullopt and `wrong` if it is none of `changes`, or two of them
// are not compatible.
std::optional<std::vector<std::size_t>> parse_rung(std::string_view name, std::span<const Change> changes,
                                                   std::string& wrong);
std::string rung_name(std::span<const std::size_t> changes);
// "mirror.glib:21" of one of FoundResult::positions.
std::string near_place(std::string_view position);

// Which combinations of changes are tried, and which rungs are worth more time. No GL.

// Adds one change after the other while the error of the picture stays below a limit. Each climb has another limit, or
// another order: by error first, then by time, then as a generator with that seed shuffles. What is plain to see comes
// last: it is on no front as long as there is anything else.
class Climbs {
public:
    struct Single {
        std::size_t change = 0;
        double error = 0;  // mean FLIP
        double ratio = 1;  // of its time to the scene's
    };
    // `singles` are those that save time.
    Climbs(std::vector<Single> singles, std::span<const Change> changes, std::uint64_t seed);

    // The next combination whose error is wanted, of at least two changes, ascending; nullopt: there is none left.
    std::optional<std::vector<std::size_t>> next();
    // What next() added a change to.
    const std::vector<std::size_t>& before() const { return chosen_; }
    // Tells the error of the last one; infinite: it is of no use.
    void tell(double error);

private:
    struct Climb {
        double limit = 0;
        std::vector<Single> order;
    };
    bool fits(std::size_t change) const;

    std::span<const Change> changes_;
    std::vector<Climb> climbs_;
    std::size_t climb_ = 0, step_ = 0;
    std::vector<std::size_t> chosen_;
    std::vector<std::pair<std::vector<std::size_t>, double>> known_;
};

// At most so many of these rungs, which save time: first those that save at least 5 % of the quick time of whatever is
// more exact, then those that only these surpass, and so on. Those whose error is plain to see only if there is little
// else.
std::vector<std::size_t> in_layers(const FoundResult& found, std::vector<std::size_t> rungs, std::size_t most);
// At most so many of these, evenly spaced.
std::vector<std::size_t> spread(const std::vector<std::size_t>& all, std::size_t most);

// The numbers that changes of the kind expression-mean lack until they are drawn.

// Draws the expressions of these changes as colours, at the places of the scene that are searched on, and writes their
// means into the changes: those over all pixels in which the expression is computed and shows. View, time and values
// are the scene's own, and the size is fixed, so that whoever applies a change gets the number that was measured.
// Changes that need no number stay as they are, and so do those whose expression shows nowhere, or if `stop` says so:
// choose_changes refuses them.
void fill_averages(const Original& original, std::span<Change*> changes, const gl::Caps& caps, const Stop& stop = {});
void fill_averages(const Original& original, std::vector<Change>& changes, const gl::Caps& caps, const Stop& stop = {});

}  // namespace snell::accuracy
