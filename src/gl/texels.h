// Texels of a texture, as a picture and as the numbers that shaders read.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "src/gl/handle.h"
#include "src/gl/target.h"

namespace snell::gl {

// A level of a texture laid out as a plane, from the upper left. Images have their first row at the bottom. The faces
// of a cube map form a cross, each as it is seen from within; of a 3D texture it is one slice. The texels of a 1D
// texture are drawn out to a band.
struct Plane {
    GLuint texture = 0;
    GLenum target = GL_TEXTURE_2D;
    std::array<int, 3> size{0, 1, 1};  // of level 0
    int level = 0, slice = 0;

    // In texels, of this level.
    int along(std::size_t axis) const;
    int width() const;
    int height() const;
    // The texel as texelFetch takes it; of a cube map z is the face, in OpenGL's order. Empty beside the plane, and
    // between the faces.
    std::optional<std::array<int, 3>> texel(int x, int y) const;
    // The coordinates at the middle of that texel: s, t, p, or a direction for cube maps.
    std::array<double, 3> coordinates(const std::array<int, 3>& texel) const;
};

// How texels become a picture.
struct TexelLook {
    double left = 0, top = 0;  // of the plane, at the picture's corner
    double zoom = 1;           // pixels per texel
    int channel = -1;          // 0 to 3; -1: red, green and blue
    float low = 0, high = 1;   // the values that are black and white
    bool light = false;        // values are encoded for the display
    bool flags = false;        // texels whose values are no colours are marked, all others dim grey
    // Of texels above 1, negative, infinite and NaN. The last two are always marked.
    std::array<std::array<float, 3>, 4> marks{};
    bool operator==(const TexelLook&) const = default;
};

class TexelViewer {
public:
    explicit TexelViewer(bool es);

    // The texture that draw() draws into, top row first, transparent where there is no texel. It has one name.
    GLuint picture() const { return picture_.get(); }
    // A pixel that covers several texels shows their mean, and marks the worst of them. Returns false if the context
    // refuses it.
    bool draw(const Plane& plane, const TexelLook& look, int width, int height);
    // Reads a rectangle of the plane as RGBA, top row first; zeros where there is no texel.
    bool read(const Plane& plane, int left, int top, int width, int height, std::vector<float>& rgba);

private:
    bool shoot(const Plane& plane, const TexelLook& look, bool exact, int width, int height);

    static constexpr std::size_t kinds = 4;
    bool es_;
    std::array<Program, kinds> programs_;  // by kind of texture, as they are needed
    VertexArray nothing_;
    Sampler sampler_;
    Texture picture_;
    Framebuffer framebuffer_;
    int width_ = 0, height_ = 0;
    Target exact_;
};

}  // namespace snell::gl
