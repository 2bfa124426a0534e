// What a scene pays for and why, what it does not pay for, and what it declares for nothing. Plain values, for
// reports and panels.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
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
        pass,
        sampler,
        uniform
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
        Index texture = none;            // of an image, a cube map, an empty or computed texture: Scene::textures
        int noise = 0;                   // of noise: 2 or 3
        std::vector<Index> programs;     // of a program, those that are compiled to it: Scene::programs
    };
    struct Unpaid {
        std::string name, why;
    };
    struct Unused {
        std::string name, why;
        Span span;
        Index texture = none;  // Scene::textures, if it is one
    };
    // What the value of a uniform switches off in the programs that are compiled for it.
    struct SwitchedOff {
        struct Part {
            Kind kind = Kind::sampler;
            std::string name;
            std::vector<std::string> functions = {};  // of the shaders that name it, such as "main (fragment)"
            std::vector<std::string> files = {};      // that are not opened
            std::uint64_t bytes = 0;                  // of these files
            std::optional<Span> span = {};            // of the statement that declares it
        };
        Index program = none;  // Scene::programs
        std::string program_name,
            uniform;  // without `uniform`: what only all values of the program together switch off
        std::string value;
        std::optional<Span> span;  // of the value in the scene
        std::vector<Part> parts;
        std::optional<FrameCost> saved;  // none: not measured
    };
    std::string redraw;  // when another frame is drawn, and why
    std::vector<Paid> paid;
    std::vector<Unpaid> unpaid;
    std::vector<Unused> unused;
    std::vector<SwitchedOff> switched_off;  // as far as Runtime::find_switched_off() found it
};

std::string_view name(Explanation::Kind kind);
// The statement of a texture with its first file.
std::string title_of(const Texture& texture);

}  // namespace snell
