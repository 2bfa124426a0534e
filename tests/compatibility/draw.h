// Draws a test object with any program, in any context, with one and the same state.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "tests/compatibility/cases.h"

namespace snell::oracle {

inline constexpr int picture_size = 128;

// RGBA, 8 bits each, of every target, bottom row first.
struct Picture {
    std::vector<std::uint8_t> pixels;
};

struct Program {
    unsigned id = 0;  // 0: it did not compile or link
    std::string log;
    ~Program();
    Program() = default;
    Program(Program&& other) noexcept : id(std::exchange(other.id, 0)), log(std::move(other.log)) {}
    Program& operator=(Program&&) = delete;
};
// In the current context.
Program build(const Texts& texts);

enum class Kind : std::uint8_t { core, compatibility, es };

// Everything that draws need in one context: the object, textures, targets. The context must be current.
class Stand {
public:
    explicit Stand(Kind kind);
    ~Stand();
    Stand(const Stand&) = delete;
    Stand& operator=(const Stand&) = delete;

    // `translation` tells which uniforms have values of their own, and which have got new names.
    Picture draw(const Program& program, const Needs& needs, const glsl::Translation& translation);

private:
    void arrays();
    void fixed_function(const Needs& needs);
    Kind kind_;
    unsigned vao_ = 0, buffer_ = 0, framebuffer_ = 0, depth_ = 0;
    std::array<unsigned, 4> targets_{};
    std::vector<unsigned> textures_;
    int vertices_ = 0;
};

// How many pixels of two pictures differ by more than one step in any channel; and how many were drawn at all.
struct Difference {
    int differing = 0, drawn = 0, pixels = 0, largest = 0;
};
Difference difference(const Picture& a, const Picture& b);

}  // namespace snell::oracle
