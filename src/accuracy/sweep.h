// Sweeps: lists of variants to compare. They are the rungs of a ladder, the settings of a knob, or all combinations of
// a few ladders; or rungs that were found (src/accuracy/found/search.h).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/text/diagnostic.h"
#include "src/accuracy/bench.h"

namespace snell::accuracy {

enum class SweepKind { ladder, knob, lattice, found };

// The rungs of those ladders that a sweep does not vary.
enum class From { reference, scene };

struct SweepRung {
    std::string name;  // for a lattice, the rungs' names separated by blanks
    Variant variant;
    std::vector<std::size_t> steps;  // for a lattice, the rung of each of its ladders
    // For a ladder, with the others at the other place: where the scene stands, or at the reference. Empty if both
    // places are the same.
    Rungs elsewhere;
};

struct Sweep {
    SweepKind kind = SweepKind::ladder;
    std::string name;                // for a lattice, the ladders' names
    std::vector<SweepRung> rungs;    // cheapest first, in the scene's order
    std::size_t reference = 0;       // index of the rung that errors are measured against
    std::size_t current = 0;         // index of the scene's own rung, the base of all ratios
    std::vector<std::size_t> moved;  // the ladders that vary, as indices into Scene::ladders
    bool numeric = false;            // the rungs' names are counts
    std::string_view elsewhere;      // the other place of SweepRung::elsewhere, as reports name it
};

inline constexpr std::array<std::string_view, 5> knob_names{"samples", "tessellation", "filter", "cube-size",
                                                            "cube-precision"};

// The last rung of every ladder.
Rungs last_rungs(const Scene& scene);

// How many combinations the rungs of these ladders have; at most 2^20 are counted.
std::size_t count_combinations(const Scene& scene, const std::vector<std::size_t>& ladders);
// These, with the other ladders at their last rungs. The last of the ladders changes first.
std::vector<Rungs> all_combinations(const Scene& scene, const std::vector<std::size_t>& ladders);
// A sweep over such combinations, against the reference, with ratios to `base`; both are added if they are missing.
Sweep combination_sweep(const Scene& scene, const std::vector<std::size_t>& ladders, std::vector<Rungs> all,
                        const Rungs& base);

// Returns a sweep for each named ladder; without names, for all ladders. Reports an error for an unknown name.
std::vector<Sweep> ladder_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                                 Diagnostics& diagnostics);
// Returns a sweep over all combinations of two or three ladders; without names, of the scene's first three.
std::vector<Sweep> lattice_sweep(const Scene& scene, const Rungs& now, const std::vector<std::string>& names,
                                 Diagnostics& diagnostics);
// Returns a sweep for each named knob that affects the scene. On a software renderer, cube maps have no anisotropic
// filter, and none is offered for scenes with cube maps.
std::vector<Sweep> knob_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                               bool software, Diagnostics& diagnostics);

}  // namespace snell::accuracy
