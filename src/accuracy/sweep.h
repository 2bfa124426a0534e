// What is to be compared: the rungs of a ladder, the settings of a knob, or all combinations of a few ladders.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "parser/diagnostic.h"
#include "src/accuracy/bench.h"

namespace snell::accuracy {

enum class SweepKind { ladder, knob, lattice };

// Where the ladders stand that a sweep does not move.
enum class From { reference, scene };

struct SweepRung {
    std::string name;  // of a lattice: the rungs' names, by blanks
    Variant variant;
    std::vector<std::size_t> steps;  // of a lattice: the rung of each of its ladders
};

struct Sweep {
    SweepKind kind = SweepKind::ladder;
    std::string name;                // of a lattice: the ladders' names
    std::vector<SweepRung> rungs;    // cheapest first, as the scene says
    std::size_t reference = 0;       // the rung that errors are measured against
    std::size_t current = 0;         // where the scene stands; the base of all ratios
    std::vector<std::size_t> moved;  // ladders, by Scene::ladders
    bool numeric = false;            // the rungs' names are counts
};

inline constexpr std::array<std::string_view, 5> knob_names{"samples", "tessellation", "filter", "cube-size",
                                                            "cube-precision"};

// One for each ladder that is named; of no names, for each there is. A name that there is not is an error.
std::vector<Sweep> ladder_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                                 Diagnostics& diagnostics);
// Of two or three ladders; of no names, the first three of the scene.
std::vector<Sweep> lattice_sweep(const Scene& scene, const Rungs& now, const std::vector<std::string>& names,
                                 Diagnostics& diagnostics);
// One for each knob that is named and that the scene has a use for.
std::vector<Sweep> knob_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                               Diagnostics& diagnostics);

}  // namespace snell::accuracy
