// Draws variants of a scene, reads them back and times them. Needs a current context.
#pragma once

#include <array>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/accuracy/timing.h"
#include "src/gl/target.h"
#include "src/plan/plan.h"
#include "src/runtime/runtime.h"

namespace snell::accuracy {

// A way to draw the scene.
struct Variant {
    Rungs rungs;  // in the order of Scene::ladders
    Knobs knobs;
};

// Called between frames; returns true to stop.
using Stop = std::function<bool()>;

struct BenchSettings {
    int width = 512, height = 512;
    double time = 0;                // seconds since the scene began
    std::vector<std::string> sets;  // assignments to uniforms, as for set_control
    bool specialise = true;         // programs are compiled for these values
    View view = {};
    std::vector<std::string> varying = {};  // "Program.uniform": programs take any value of these
    // Of the same context: what did not change is shared with it.
    const Runtime* previous = nullptr;
};

// Where a scene is drawn: what a user may change while it runs.
struct Place {
    View view;
    double time = 0;
    std::vector<std::string> sets;
    bool operator==(const Place&) const = default;
};

// A shader can write the direction in which it looks up the environment, instead of a colour, if it tests SNELL_OUTPUT:
//   #if defined(SNELL_OUTPUT) && SNELL_OUTPUT == SNELL_OUTPUT_direction
class Bench {
public:
    // `files` and `sources` must outlive the bench.
    Bench(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, BenchSettings settings);
    ~Bench();

    const Scene& scene() const { return plan_.scene; }
    const BenchSettings& settings() const { return settings_; }
    // Pictures and times from now on are of this place.
    void at(const Place& place);
    // Pictures and times from now on are of this size.
    void resize(int width, int height);
    // The runtime that draws the scene at its own knobs.
    const Runtime& runtime();
    // For each draw, whether the shaders of its program mention the ladder.
    std::vector<bool> draws_of(std::size_t ladder) const;

    // Draws a picture; returns nullopt if the context cannot draw it, or `stop` ended it. `hidden` tells for each draw
    // whether it is left out.
    std::optional<Picture> picture(const Variant& variant, const std::vector<bool>* hidden = nullptr,
                                   const Stop& stop = {});
    // Draws the directions in which the shaders look up the environment; returns nullopt if the context cannot draw it.
    std::optional<Picture> directions(const Variant& variant);

    // Compiles, loads, and draws as FrameClock::warm_up. Returns nullopt if the variant cannot be drawn.
    std::optional<double> warm_up(const Variant& variant, ClockKind clock);
    // As FrameClock::sample. warm_up must have succeeded.
    Times time(const Variant& variant, double at_least);
    // As FrameClock::choose, by frames of `variant`.
    ClockKind choose_clock(const Variant& variant);
    double query_over_wall() const { return clock_.query_over_wall(); }

    // The problems that occurred when variants were made, once each.
    const Diagnostics& problems() const { return problems_; }

private:
    struct Stage;  // a runtime for one set of knobs
    Stage* stage(const PlanKnobs& knobs);
    void tell(const Diagnostics& found);
    gl::ExactTarget* target(int multisample);
    bool ready(const Variant& variant, bool directions);
    bool draw(const std::vector<bool>* hidden, const Stop& stop = {});

    Plan plan_;
    Files* files_;
    Sources* sources_;
    gl::Caps caps_;
    BenchSettings settings_;
    bool directions_ = false;
    std::deque<std::unique_ptr<Stage>> stages_;
    std::deque<std::pair<int, std::unique_ptr<gl::ExactTarget>>> targets_;
    FrameClock clock_;
    Diagnostics problems_;

    // The inputs of draw().
    Stage* current_ = nullptr;
    gl::ExactTarget* into_ = nullptr;
    Controls controls_;
    Knobs knobs_;
};

// The pictures that errors are measured against: the last rungs, with finer knobs than any scene is drawn with, and the
// mean of many pictures that are shifted by fractions of a pixel.

// The finest picture that the time allowed, and the same at half its knobs. The knobs are doubled until then, so the
// picture is nearer to the limit than the distance of the two.
struct Reference {
    Picture picture;  // empty if this context cannot draw it
    Picture half;     // empty if there was no time for finer knobs than the scene's own
    Knobs knobs;      // of `picture`
};

// Draws references on demand and keeps them, because the sweeps of a report share them.
class References {
public:
    // For each reference, at most about `seconds` are used.
    explicit References(double seconds) : seconds_(seconds) {}
    double seconds() const { return seconds_; }
    const Reference& of(Bench& bench, const Rungs& rungs, const Stop& stop);

private:
    double seconds_;
    std::map<Rungs, Reference> known_;
};

// A picture as the mean of many, each shifted by a fraction of a pixel. Needs a current context.

// The shift of a sample in pixels, at most half a pixel. The first one is 0, and any number of the first samples is
// evenly distributed (Halton sequence, bases 2 and 3).
std::array<double, 2> sample_position(int index);

// The values that a display gets of a picture of floats that the runtime drew: encoded if the scene's output is light.
Picture displayed(Picture picture, const Runtime& runtime);

class SampleMean {
public:
    SampleMean(int width, int height, bool es) : target_(width, height, 1, es) {}

    // If false, the context has no float targets, and the functions below must not be called.
    bool valid() const { return target_.valid(); }
    int samples() const { return samples_; }
    void restart() { samples_ = 0; }
    // Draws the next sample, and returns the time of the drawing; frame.shift is ignored.
    Times add(Runtime& runtime, Frame frame, const FrameClock& clock);
    // Where samples are drawn.
    Surface surface() const { return {target_.framebuffer(), target_.width(), target_.height()}; }
    // What a display gets of the mean. samples() must be above 0; `runtime` drew them.
    Picture picture(const Runtime& runtime) const;

private:
    gl::ExactTarget target_;
    int samples_ = 0;
};

}  // namespace snell::accuracy
