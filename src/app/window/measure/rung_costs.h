// Errors and costs of choices of rungs, while nothing else changes: of those that the user visited and, on request, of
// all rungs of a ladder.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/reference.h"
#include "src/ui/panels/accuracy.h"

namespace snell {

class RungCosts {
public:
    RungCosts();
    ~RungCosts();

    // Discards all results; call it when something other than the rungs changes.
    void forget();
    // Records that these rungs were drawn, with one time for each drawing.
    void visit(const Rungs& rungs, double error, std::span<const double> times);

    // Starts measuring all rungs of the ladder, with the other ladders as chosen: first errors, then times in
    // interleaved rounds.
    void begin(std::size_t ladder, const Scene& scene, const Rungs& chosen);
    void stop();
    bool measuring() const { return job_ != nullptr; }
    double done() const;  // 0..1
    // Draws one sample of one rung with a runtime that nothing else uses. `reference` must have as many samples as
    // `samples`; the rungs in `frame` are ignored. Returns true if there are new results.
    bool step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
              const accuracy::FrameClock& clock, bool es);

    // The results as points of a plot of that ladder.
    std::vector<ui::AccuracyPoint> points(const Scene& scene, std::size_t ladder, const Rungs& chosen) const;
    // A note on the last measurement.
    const std::string& remark() const { return remark_; }

private:
    struct Known {
        double error = 0;
        std::vector<double> times;  // if it was compared, from the same rounds as the others'
        ui::AccuracyPoint::Standing standing = ui::AccuracyPoint::Standing::visited;
        std::string by;
    };
    struct Job;
    bool error_step(const accuracy::Picture& reference, int samples, const accuracy::FrameClock& clock);
    void begin_rounds(const accuracy::FrameClock& clock);
    void conclude(accuracy::ClockKind clock);

    std::map<Rungs, Known> known_;
    std::unique_ptr<Job> job_;
    std::string remark_;
};

}  // namespace snell
