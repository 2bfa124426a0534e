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
    using SampleMean = accuracy::SampleMean;

    // Discards all results; call it when something other than the rungs changes.
    void forget();
    // Records that these rungs were drawn, with one time for each drawing.
    void visit(const Rungs& rungs, double error, std::span<const double> times);

    // Starts measuring all rungs of the ladder, with the other ladders as chosen: first errors, then times in
    // interleaved rounds.
    void begin(std::size_t ladder, const Scene& scene, const Rungs& chosen);
    void stop();
    bool measuring() const { return job_.has_value(); }
    double done() const;  // 0..1
    // Draws one or two pictures with a runtime that nothing else uses. `reference` must have as many samples as
    // `samples`; the rungs in `frame` are ignored. Returns true if there are new results.
    bool step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
              const gl::Caps& caps);

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
    struct Job {
        std::vector<std::string> names;          // of the ladder's rungs
        std::size_t chosen = 0;                  // index into `names`
        std::vector<Rungs> rungs;                // in the order of `names`, then the chosen one again as the control
        std::vector<double> errors;              // in the order of `names`
        std::vector<std::vector<double>> times;  // in the order of `rungs`, by round
        std::size_t next = 0;                    // index into `rungs`
        bool timing = false;
        int rounds = 0, wanted = 21;
        double spent = 0;  // in milliseconds
        std::unique_ptr<SampleMean> mean;
    };
    bool error_step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples, bool cpu);
    bool time_step(Runtime& runtime, const Frame& frame, bool cpu);
    void conclude();

    std::map<Rungs, Known> known_;
    std::optional<Job> job_;
    std::string remark_;
};

}  // namespace snell
