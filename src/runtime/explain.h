// What a scene pays for and why, what it does not pay for, and what it declares for nothing. Plain values, for
// reports and panels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parser/scene.h"

namespace snell {

// Milliseconds of each frame. gpu: only where the GPU's clock is known to be right.
struct FrameCost {
    double cpu = 0, wall = 0;
    std::optional<double> gpu;
};

struct Explanation {
    enum class Kind : std::uint8_t {
        image,
        cube_map,
        empty_texture,
        computed,
        noise,
        mesh,
        tree,
        program,
        target,
        pass
    };
    // A resource or a pass, by the statement that asked for it.
    struct Paid {
        Kind kind = Kind::image;
        std::string name, why;
        std::optional<Span> span;        // none: no statement did
        std::uint64_t bytes = 0;         // of GPU memory, estimated
        std::optional<double> load_ms;   // by the wall's clock, when it was made; none: nothing was to be loaded
        std::vector<Index> draws;        // of a pass or a program: Scene::draws
        std::uint64_t triangles = 0;     // of a mesh, of all draws of a pass
        bool kept = false;               // a pass that is drawn again only when what it shows changed
        std::optional<FrameCost> frame;  // of a pass or a program; none: not measured
        Index pass = none;               // of a pass: Scene::passes
    };
    struct Unpaid {
        std::string name, why;
    };
    struct Unused {
        std::string name, why;
        Span span;
    };
    std::string redraw;  // when another frame is drawn, and why
    std::vector<Paid> paid;
    std::vector<Unpaid> unpaid;
    std::vector<Unused> unused;
};

std::string_view name(Explanation::Kind kind);

}  // namespace snell
