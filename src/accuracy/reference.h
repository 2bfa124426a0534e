// The pictures that errors are measured against: the last rungs, with finer knobs than any scene is drawn with.
#pragma once

#include <functional>
#include <map>

#include "src/accuracy/bench.h"

namespace snell::accuracy {

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

}  // namespace snell::accuracy
