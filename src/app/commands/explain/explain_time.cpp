// Times frames, frames without some of their draws, and frames of other programs.
#include <algorithm>
#include <set>

#include "parser/text/ranges.h"
#include "src/accuracy/clock.h"
#include "src/accuracy/statistics.h"
#include "src/app/commands/explain/explain.h"
#include "src/gl/exact_target.h"
#include "src/gl/present.h"
#include "src/runtime/resources/stopwatch.h"

namespace snell::app {

namespace {

using Paid = Explanation::Paid;

// Times frames of which some draws are left out.
class Rounds {
public:
    Rounds(const Frame& frame, const Surface& surface, bool software)
        : frame_(frame), surface_(surface), software_(software) {}

    FrameCost once(Runtime& runtime, const std::vector<bool>& hidden = {}, int frames = 1) {
        Frame frame = frame_;
        frame.hidden = hidden.empty() ? nullptr : &hidden;
        gl::finish();
        const bool query = !software_ && query_.available();
        if (query) query_.begin();
        const double cpu = accuracy::cpu_milliseconds();
        const runtime::Stopwatch watch;
        for (int i = 0; i < frames; ++i) {
            runtime.draw(frame, surface_);
            gl::finish();
        }
        FrameCost cost{(accuracy::cpu_milliseconds() - cpu) / frames, watch.milliseconds() / frames, std::nullopt};
        if (query) cost.gpu = query_.end() / frames;
        return cost;
    }

    // A timer query is trusted if it agrees with the wall clock on a heavy load.
    bool calibrated(Runtime& runtime) {
        if (software_ || !query_.available()) return false;
        const int frames = std::clamp(static_cast<int>(200 / std::max(once(runtime).wall, .01)), 1, 1000);
        const FrameCost heavy = once(runtime, {}, frames);
        return heavy.gpu && *heavy.gpu > .8 * heavy.wall && *heavy.gpu < 1.2 * heavy.wall;
    }

private:
    Frame frame_;
    Surface surface_;
    bool software_;
    gl::TimerQuery query_;
};

// Compares times of the same rounds; the last round may be incomplete.
FrameCost median_difference(const std::vector<FrameCost>& with, const std::vector<FrameCost>& without, bool gpu) {
    const auto median = [&](auto value) {
        std::vector<double> differences;
        for (std::size_t i = 0; i < std::min(with.size(), without.size()); ++i)
            differences.push_back(value(with[i]) - value(without[i]));
        return accuracy::median(differences);
    };
    FrameCost cost{median([](const FrameCost& c) { return c.cpu; }), median([](const FrameCost& c) { return c.wall; }),
                   std::nullopt};
    if (gpu) cost.gpu = median([](const FrameCost& c) { return c.gpu.value_or(0); });
    return cost;
}

// What is timed in turns with the whole frame, and where the difference goes.
struct Timed {
    Runtime* runtime;
    std::vector<bool> hidden;  // as Frame::hidden
    std::optional<FrameCost>* result;
    bool more;  // it takes what the whole frame takes, and more
    std::vector<FrameCost> costs = {};
};

// Cube passes that are kept are not among the parts: they would be drawn only because their draws come and go.
std::vector<Timed> timed_parts(Explanation& explanation, Runtime& runtime, std::span<const Comparison> comparisons) {
    std::vector<Timed> parts;
    std::set<Index> kept;
    for (const Paid& paid : explanation.paid)
        if (paid.kept) kept.insert(paid.draws.begin(), paid.draws.end());
    for (Paid& paid : explanation.paid) {
        if (paid.draws.empty() || ranges::any_of(paid.draws, [&](Index draw) { return kept.contains(draw); })) continue;
        std::vector<bool> hidden(runtime.scene().draws.size(), false);
        for (const Index draw : paid.draws) hidden[draw] = true;
        parts.push_back({&runtime, std::move(hidden), &paid.frame, false});
    }
    for (const Comparison& comparison : comparisons) parts.push_back({comparison.runtime, {}, comparison.saved, true});
    return parts;
}

}  // namespace

double shown(const FrameCost& cost, bool software) { return cost.gpu ? *cost.gpu : software ? cost.cpu : cost.wall; }

void time_frames(ExplainReport& report, Runtime& runtime, const Frame& frame, const Surface& surface,
                 const Timing& timing, std::span<const Comparison> comparisons) {
    const runtime::Stopwatch watch;
    Rounds clock(frame, surface, report.caps.software);
    std::vector<Timed> parts = timed_parts(report.explanation, runtime, comparisons);
    const bool gpu = clock.calibrated(runtime);
    std::vector<FrameCost> whole;
    double longest = timing.frame;
    const auto fits = [&] { return watch.milliseconds() + longest < timing.milliseconds; };
    const auto timed = [&](Runtime& of, const std::vector<bool>& hidden) {
        const double share = std::max(watch.milliseconds() / std::max(timing.milliseconds, 1.),
                                      static_cast<double>(whole.size()) / static_cast<double>(timing.rounds));
        if (timing.report) timing.report(static_cast<int>(whole.size()), share);
        const FrameCost cost = clock.once(of, hidden);
        longest = std::max(longest, cost.wall);
        return cost;
    };
    for (int round = 0; round < timing.rounds && fits(); ++round) {
        whole.push_back(timed(runtime, {}));
        for (std::size_t i = 0; i < parts.size() && fits(); ++i)
            parts[i].costs.push_back(timed(*parts[i].runtime, parts[i].hidden));
    }
    if (whole.empty()) return;
    report.asked = timing.rounds;
    report.rounds = static_cast<int>(whole.size());
    report.clock = gpu                    ? "timer queries of the GPU"
                   : report.caps.software ? "CPU time of the process"
                                          : "the wall's clock";
    report.frame = median_difference(whole, std::vector<FrameCost>(whole.size()), gpu);
    for (const Timed& part : parts)
        if (!part.costs.empty())
            *part.result =
                part.more ? median_difference(part.costs, whole, gpu) : median_difference(whole, part.costs, gpu);
    std::vector<double> values;
    for (FrameCost& cost : whole) {
        if (!gpu) cost.gpu.reset();
        values.push_back(shown(cost, report.caps.software));
    }
    report.spread = accuracy::mad(values);
}

}  // namespace snell::app
