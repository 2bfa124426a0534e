#include "src/accuracy/bench.h"

#include <algorithm>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/content/image/image.h"
#include "src/gl/present.h"
#include "src/glsl/read/lexer.h"
#include "src/plan/texts.h"
#include "src/plan/values/controls.h"

namespace snell::accuracy {

namespace {

constexpr std::size_t most_stages = 8;  // of one sweep; memory may be too small for the textures of many more

// The words by which a shader mentions a ladder: FRESNEL, FRESNEL_exact.
std::vector<std::string> words_of(const Ladder& ladder) {
    std::vector<std::string> words{ladder.name};
    for (const std::string& rung : ladder.rungs) words.push_back(ladder.name + "_" + rung);
    return words;
}

bool names_any(std::string_view text, const std::vector<std::string>& words) {
    for (std::size_t at = glsl::skip_trivia(text, 0).end; at < text.size();) {
        const glsl::Lexeme lexeme = glsl::lex(text, at);
        if (ranges::find(words, lexeme.text) != words.end()) return true;
        at = glsl::skip_trivia(text, at + std::max<std::size_t>(lexeme.text.size(), 1)).end;
    }
    return false;
}

bool any_stage_names(const PlannedProgram& program, const Sources& sources, const Files& files, const Ladder& ladder) {
    Files reader(files.folder(), files.access());
    return ranges::any_of(shader_texts(program, sources, reader), [words = words_of(ladder)](const ShaderText& shader) {
        return names_any(shader.text, words);
    });
}

// The kind of output, which every program then sees.
Ladder output_ladder() {
    Ladder ladder;
    ladder.name = "SNELL_OUTPUT";
    ladder.rungs = {"color", "direction"};
    ladder.rung_spans.resize(2);
    return ladder;
}

// Adds that ladder before the scene's own.
Plan with_output(Plan plan) {
    plan.scene.ladders.insert(plan.scene.ladders.begin(), output_ladder());
    for (Program& program : plan.scene.programs) ++program.ladders;
    plan.rungs.insert(plan.rungs.begin(), 0);
    return plan;
}

}  // namespace

struct Bench::Stage {
    PlanKnobs knobs;
    Diagnostics diagnostics;
    Runtime runtime;

    Stage(const PlanKnobs& k, Plan plan, Files& files, Sources& sources, const gl::Caps& caps,
          const RuntimeOptions& options)
        : knobs(k), runtime(std::move(plan), files, sources, caps, diagnostics, options) {}
};

Bench::Bench(Plan plan, Files& files, Sources& sources, const gl::Caps& caps, BenchSettings settings)
    : plan_(std::move(plan)),
      files_(&files),
      sources_(&sources),
      caps_(caps),
      settings_(std::move(settings)),
      clock_(caps.software) {
    directions_ = ranges::any_of(
        plan_.programs, [&](const PlannedProgram& p) { return any_stage_names(p, sources, files, output_ladder()); });
}

Bench::~Bench() = default;

std::vector<bool> Bench::draws_of(std::size_t ladder) const {
    std::vector<bool> own;
    for (const Draw& draw : plan_.scene.draws)
        own.push_back(draw.program != none && ladder < plan_.scene.programs[draw.program].ladders &&
                      any_stage_names(plan_.programs[draw.program], *sources_, *files_, plan_.scene.ladders[ladder]));
    return own;
}

Bench::Stage* Bench::stage(const PlanKnobs& knobs) {
    const auto found = ranges::find_if(stages_, [&](const auto& stage) { return stage->knobs == knobs; });
    if (found != stages_.end()) return found->get();
    if (stages_.size() >= most_stages) stages_.erase(stages_.begin());
    Plan plan = with_knobs(plan_, knobs);
    if (directions_) plan = with_output(std::move(plan));
    RuntimeOptions how;
    how.previous = settings_.previous;
    if (settings_.specialise)
        how.settle = [this](Controls& controls, const Scene& scene) {
            Diagnostics unheard;  // opening the scene has reported these
            for (const std::string& set : settings_.sets) set_control(controls, scene, set, unheard);
            for (snell::Control& control : controls.items)
                if (ranges::find(settings_.varying, scene.programs[control.program].name + "." + control.name) !=
                    settings_.varying.end())
                    control.varies = true;
        };
    stages_.push_back(std::make_unique<Stage>(knobs, std::move(plan), *files_, *sources_, caps_, how));
    tell(stages_.back()->diagnostics);
    return stages_.back().get();
}

void Bench::tell(const Diagnostics& found) {
    for (const Diagnostic& diagnostic : found.items())
        if (ranges::none_of(problems_.items(), [&](const Diagnostic& other) {
                return other.code == diagnostic.code && other.span == diagnostic.span;
            }))
            problems_.add(diagnostic);
}

void Bench::at(const Place& place) {
    settings_.view = place.view;
    settings_.time = place.time;
    settings_.sets = place.sets;
}

void Bench::resize(int width, int height) {
    if (width != settings_.width || height != settings_.height) targets_.clear();
    settings_.width = width;
    settings_.height = height;
}

const Runtime& Bench::runtime() { return stage({})->runtime; }

gl::ExactTarget* Bench::target(int multisample) {
    const auto found = ranges::find(targets_, multisample, [](const auto& target) { return target.first; });
    if (found != targets_.end()) return found->second.get();
    targets_.emplace_back(multisample,
                          std::make_unique<gl::ExactTarget>(settings_.width, settings_.height, multisample, caps_.es));
    return targets_.back().second.get();
}

bool Bench::ready(const Variant& variant, bool directions) {
    current_ = stage(variant.knobs.plan);
    into_ = target(variant.knobs.multisample);
    knobs_ = variant.knobs;
    Rungs rungs = variant.rungs;
    if (directions_) rungs.insert(rungs.begin(), directions ? 1 : 0);
    current_->runtime.choose(rungs);
    Diagnostics heard;  // opening the scene has already reported these
    controls_ = current_->runtime.controls();
    for (const std::string& set : settings_.sets) set_control(controls_, current_->runtime.scene(), set, heard);
    controls_.rungs = std::move(rungs);
    // A program that does not compile with these rungs would be drawn as it was with others.
    const Diagnostics& wrong = current_->runtime.ladder_problems();
    if (wrong.has_errors()) tell(wrong);
    return into_->valid() && !wrong.has_errors();
}

// Samples are on a regular grid within the pixel; a single sample is at its usual position. Returns false if `stop`
// ended it.
bool Bench::draw(const std::vector<bool>* hidden, const Stop& stop) {
    const bool several = knobs_.grid > 1;  // without this, the sum would add a cost that the scene does not have
    if (several) into_->begin();
    for (int i = 0; i < knobs_.grid; ++i)
        for (int j = 0; j < knobs_.grid; ++j) {
            if (stop) {
                gl::finish();
                if (stop()) return false;
            }
            Frame frame{.time = settings_.time, .view = settings_.view, .controls = controls_};
            frame.shift = {.5 - (i + .5) / knobs_.grid, .5 - (j + .5) / knobs_.grid};
            frame.hidden = hidden;
            current_->runtime.draw(frame, {into_->framebuffer(), into_->width(), into_->height()});
            if (several) into_->add(1 / static_cast<float>(knobs_.grid * knobs_.grid));
        }
    if (!several) into_->resolve();
    return true;
}

std::optional<Picture> Bench::picture(const Variant& variant, const std::vector<bool>* hidden, const Stop& stop) {
    if (!ready(variant, false) || !draw(hidden, stop)) return std::nullopt;
    return displayed({settings_.width, settings_.height, into_->read(knobs_.grid > 1)}, current_->runtime);
}

std::optional<Picture> Bench::directions(const Variant& variant) {
    Variant single = variant;
    single.knobs.grid = single.knobs.multisample = 1;  // directions have no meaningful mean
    if (!directions_ || !ready(single, true)) return std::nullopt;
    draw(nullptr);
    return Picture{settings_.width, settings_.height, into_->read(false)};
}

std::optional<double> Bench::warm_up(const Variant& variant, ClockKind clock) {
    if (!ready(variant, false)) return std::nullopt;
    return clock_.warm_up([this] { draw(nullptr); }, clock);
}

Times Bench::time(const Variant& variant, double at_least) {
    ready(variant, false);
    return clock_.sample([this] { draw(nullptr); }, at_least);
}

ClockKind Bench::choose_clock(const Variant& variant) {
    if (caps_.software || !warm_up(variant, ClockKind::wall)) return clock_.plain();
    return clock_.choose([this] { draw(nullptr); });
}

namespace {

constexpr int finest = 8;  // samples along each side of a pixel, and the factor of tessellation

// Filters approximate what many samples of linearly interpolated texels give.
Variant variant_of(const Scene& scene, const Rungs& rungs, int fineness) {
    Variant variant{rungs, {.grid = fineness}};
    if (has_round_shapes(scene)) variant.knobs.plan.tessellation = fineness;
    if (has_textures(scene)) variant.knobs.plan.filter = Filter{Filter::Mode::linear, 1};
    return variant;
}

// The digits of the number, mirrored at the point (radical inverse).
double halton(int number, int base) {
    double result = 0, place = 1;
    for (; number > 0; number /= base) {
        place /= base;
        result += place * (number % base);
    }
    return result;
}

}  // namespace

const Reference& References::of(Bench& bench, const Rungs& rungs, const Stop& stop) {
    if (const auto found = known_.find(rungs); found != known_.end()) return found->second;
    Reference& reference = known_[rungs];
    const double start = wall_milliseconds(), end = start + 1e3 * seconds_;
    const Stop enough = [&] { return wall_milliseconds() > end || (stop && stop()); };
    double took = 0;
    for (int fineness = 1; fineness <= finest; fineness *= 2) {
        // Four times the samples, at least; of the first picture, most of the time goes into compiling and loading.
        const double begin = wall_milliseconds();
        if (begin + (fineness > 2 ? 4 : 1) * took > end && fineness > 1) break;
        const Variant variant = variant_of(bench.scene(), rungs, fineness);
        auto finer = bench.picture(variant, nullptr, fineness > 1 ? enough : stop);
        if (!finer) break;
        took = wall_milliseconds() - begin;
        reference = {std::move(*finer), std::move(reference.picture), variant.knobs};
    }
    return reference;
}

std::array<double, 2> sample_position(int index) {
    const auto around_first = [index](int base) {
        const double moved = halton(index + 1, base) - halton(1, base);
        return moved - std::floor(moved + .5);
    };
    return {around_first(2), around_first(3)};
}

Times SampleMean::add(Runtime& runtime, Frame frame, const FrameClock& clock) {
    // Within a pixel of the picture that it is on the screen: an enlarged one has some of its pixels, not their means.
    const auto [right, up] = sample_position(samples_);
    frame.shift = {right / frame.enlarged, up / frame.enlarged};
    const Times took = clock.of([&] { runtime.draw(frame, surface()); });
    if (samples_++ == 0) target_.begin();
    target_.add(1);
    return took;
}

Picture displayed(Picture picture, const Runtime& runtime) {
    if (runtime.display_pixels() != gl::Pixels::srgb8) return picture;
    for (std::size_t i = 0; i < picture.rgba.size(); ++i)
        if (i % 4 != 3) picture.rgba[i] = static_cast<float>(content::srgb_of_light(picture.rgba[i]));
    return picture;
}

Picture SampleMean::picture(const Runtime& runtime) const {
    Picture picture{target_.width(), target_.height(), target_.read(true)};
    for (float& value : picture.rgba) value /= static_cast<float>(samples_);
    return displayed(std::move(picture), runtime);
}

}  // namespace snell::accuracy
