// The refraction room drawn by snell and by hand, in one process. Each has a context of its own, so that neither
// finds state that the other left.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/runtime/runtime.h"
#include "tests/bench/timing.h"

namespace snell::bench {

enum class Who { snell, by_hand, by_hand_constants };
inline constexpr std::array<Who, 3> everybody{Who::snell, Who::by_hand, Who::by_hand_constants};

// Programs are compiled for the values of the scene's text, as without a window.
RuntimeOptions for_values();

struct NoGraphics : std::runtime_error {
    using std::runtime_error::runtime_error;
};

class Rooms {
public:
    // `root` is the repository. Throws NoGraphics, or others where the scene does not open.
    explicit Rooms(const std::string& root);
    ~Rooms();

    void resize(int width, int height);
    // So many frames, after one more that is not timed; what one of them took until all of them were there.
    Times frames(Who who, int count);
    // RGBA, rows top first.
    std::vector<std::byte> picture(Who who);

    struct OwnCost {
        double calls = 0;  // of OpenGL
        Times time;
    };
    // What a frame takes without OpenGL: all of its functions that frames call do nothing. Nothing can be drawn
    // afterwards.
    OwnCost own_cost(Who who, int count);
    // For counting instructions. Precondition: own_cost was asked.
    void draw(Who who);

private:
    struct Room;
    std::array<std::unique_ptr<Room>, everybody.size()> rooms_;
};

}  // namespace snell::bench
