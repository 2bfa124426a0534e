// What choices of rungs are off by and what they cost, while nothing else changes: of those that were visited, and of
// all of a ladder when they are asked for.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/sample_mean.h"
#include "src/ui/accuracy.h"

namespace snell {

class RungCosts {
public:
    using SampleMean = accuracy::SampleMean;

    // Something else changed.
    void forget();
    // The rungs were drawn: once for each of `times`.
    void visit(const Rungs& rungs, double error, std::span<const double> times);

    // Measures all rungs of the ladder, the others as chosen: first errors, then times in interleaved rounds.
    void begin(std::size_t ladder, const Scene& scene, const Rungs& chosen);
    void stop();
    bool measuring() const { return job_.has_value(); }
    double done() const;  // 0..1
    // One or two pictures by a runtime that is nobody else's. `reference`: of as many samples. `frame`'s rungs are
    // ignored. True: something more is known.
    bool step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
              const gl::Caps& caps);

    std::vector<ui::AccuracyPoint> points(const Scene& scene, std::size_t ladder, const Rungs& chosen) const;
    // Of the last measurement.
    const std::string& remark() const { return remark_; }

private:
    struct Known {
        double error = 0;
        std::vector<double> times;  // of the same rounds as others' where it was compared
        ui::AccuracyPoint::Standing standing = ui::AccuracyPoint::Standing::visited;
        std::string by;
    };
    struct Job {
        std::vector<std::string> names;          // of the ladder's rungs
        std::size_t chosen = 0;                  // of these
        std::vector<Rungs> rungs;                // as `names`, and the chosen one again: the control
        std::vector<double> errors;              // as `names`
        std::vector<std::vector<double>> times;  // as `rungs`, by round
        std::size_t next = 0;                    // of `rungs`
        bool timing = false;
        int rounds = 0, wanted = 21;
        double spent = 0;  // milliseconds
        std::unique_ptr<SampleMean> mean;
    };
    bool error_step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples, bool cpu);
    bool time_step(Runtime& runtime, const Frame& frame, bool cpu);
    static bool noisy(const Job& job);
    void conclude();

    std::map<Rungs, Known> known_;
    std::optional<Job> job_;
    std::string remark_;
};

}  // namespace snell
