// Which draw is seen at each pixel, by drawing the scene with its own programs: whatever these move, make or discard is
// where the picture has it.
//
// One draw at a time goes to a cover, whose alpha is 1 before: blending leaves 0 where a fragment of it passed, or,
// where the draw blends by its alpha, what that lets through. So the same bits that make an object invisible in the
// picture leave no trace of it here. Then a pass over the screen writes the draw's number wherever the cover is not 1.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "parser/scene.h"
#include "src/gl/handle.h"
#include "src/gl/target.h"
#include "src/runtime/runtime.h"

namespace snell::runtime {

class Picker {
public:
    explicit Picker(bool es) : es_(es) {}

    // False: the context refused it. Nothing happens where it has that size.
    bool resize(int width, int height);
    std::size_t bytes() const;
    // Programs made so far.
    int programs() const { return (ids_program_ ? 1 : 0) + (outline_program_ ? 1 : 0); }

    // Numbers, in `region` alone. begin: none yet.
    void begin(const PixelRect& region);
    // For a draw by itself, everywhere.
    void whole();
    // Before a draw into what is bound then. The first one after clear() meets no depths of others.
    void cover();
    // After it: these pixels are the draw's.
    void commit(Index draw);
    // Everything is erased.
    void clear();
    // By pixel of the region, the bottom row first.
    std::vector<Index> read();

    // After cover() and a draw: its outline, so many pixels wide, over what `framebuffer` shows.
    void outline(GLuint framebuffer, float width);

private:
    void pass(GLuint program);
    void scissor() const;

    bool es_;
    bool fresh_ = true;
    int width_ = 0, height_ = 0;
    PixelRect region_;
    gl::Texture cover_, ids_;
    gl::TextureTarget cover_target_, ids_target_;
    gl::Program ids_program_, outline_program_;
    gl::VertexArray nothing_;
};

// What the blending must be for a draw into the cover. Instead of the scene's.
void blend_into_cover(const RasterState& raster);

}  // namespace snell::runtime
