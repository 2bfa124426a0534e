// Where variants of a scene are drawn, read back and timed. Needs a current context.
#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/gl/exact_target.h"
#include "src/plan/knobs.h"
#include "src/runtime/runtime.h"

namespace snell::accuracy {

// One way to draw the scene.
struct Variant {
    Rungs rungs;  // by Scene::ladders
    Knobs knobs;
};

// What one frame took, in milliseconds. gpu: 0 where there is no timer query, or it may not be asked.
struct Times {
    double cpu = 0, wall = 0, gpu = 0;
};

// Which of them is believed.
enum class ClockKind { cpu, gpu, wall };
std::string_view name(ClockKind clock);
double chosen(const Times& times, ClockKind clock);

struct BenchSettings {
    int width = 512, height = 512;
    double time = 0;                // seconds since the scene began
    std::vector<std::string> sets;  // assignments to uniforms, as set_control takes them
};

// A shader that tests SNELL_OUTPUT can show the direction it looks up in the environment, instead of a colour:
//     #if defined(SNELL_OUTPUT) && SNELL_OUTPUT == SNELL_OUTPUT_direction
class Bench {
public:
    // `files` and `sources` outlive the bench.
    Bench(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, BenchSettings settings);
    ~Bench();

    const Scene& scene() const { return plan_.scene; }
    const BenchSettings& settings() const { return settings_; }
    // Draws with programs whose shaders name the ladder.
    std::vector<bool> draws_of(std::size_t ladder) const;
    // Some shader can show directions.
    bool has_directions() const { return directions_; }

    // Empty: the context can't draw that. `hidden`: by draw, what is left out.
    std::optional<Picture> picture(const Variant& variant, const std::vector<bool>* hidden = nullptr);
    std::optional<Picture> directions(const Variant& variant);

    // Compiles, loads and draws until two frames in a row differ by less than a fifth, at most five times; what the
    // last one took. Nothing: can't be drawn.
    std::optional<double> warm_up(const Variant& variant, ClockKind clock);
    // One frame after another one that was not timed, until `at_least` milliseconds went by; what one of them took.
    // Precondition: warm_up succeeded.
    Times time(const Variant& variant, double at_least);

    // Process CPU time on software renderers. Elsewhere timer queries if they agree with the wall within a fifth on a
    // heavy load made of frames of `variant`, else the wall's clock. query_over_wall() is what was found; 0: not asked.
    ClockKind choose_clock(const Variant& variant);
    double query_over_wall() const { return query_over_wall_; }

    // What went wrong when variants were made, once each.
    const Diagnostics& problems() const { return problems_; }

private:
    struct Stage;  // a runtime for one set of knobs
    Stage* stage(const PlanKnobs& knobs);
    gl::ExactTarget* target(int multisample);
    bool ready(const Variant& variant, bool directions);
    void draw(const std::vector<bool>* hidden);
    Times timed(int frames);

    Plan plan_;
    Files* files_;
    Sources* sources_;
    gl::Caps caps_;
    BenchSettings settings_;
    bool directions_ = false;
    std::deque<std::unique_ptr<Stage>> stages_;
    std::deque<std::pair<int, std::unique_ptr<gl::ExactTarget>>> targets_;
    gl::TimerQuery query_;
    double query_over_wall_ = 0;
    Diagnostics problems_;

    // What draw() draws.
    Stage* current_ = nullptr;
    gl::ExactTarget* into_ = nullptr;
    Controls controls_;
    Knobs knobs_;
};

}  // namespace snell::accuracy
