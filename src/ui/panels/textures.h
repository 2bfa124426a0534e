// The texture panel: the images, cube maps, noise and render targets that the scene has on the GPU, as texels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "src/ui/kit/kit.h"
#include "src/ui/kit/style.h"
#include "src/ui/panels/pixels.h"

namespace snell::ui {

struct Facts;
struct Memory;

struct TextureRow {
    std::string name;    // such as "Texture2D 5 wall.bmp"; no two rows have the same
    std::string size;    // such as "256 x 256"
    std::string format;  // such as "RGBA8, 9 levels"
    std::string why;     // what reads it, or why it is not loaded
    bool loaded = false;
};

struct TextureFacts {
    std::span<const TextureRow> rows;
    std::uintptr_t picture = 0;  // what TextureMemory asks for, as a GL texture; 0: there is none
    int width = 0, height = 0;   // of the texture that is shown, in texels; a cube map's faces form a cross
    int levels = 1, slices = 1;
    bool floats = false;                // its values may lie outside of 0 to 1
    PixelFacts texel;                   // with an inspection while TextureMemory::inspecting, counts while marks are on
    std::uint64_t drawn = 0, read = 0;  // how often the picture was drawn, and texels were read
};

struct TextureMemory {
    bool open = false;   // in sight
    std::string chosen;  // TextureRow::name
    int level = 0, slice = 0;
    int channel = -1;              // 0 to 3: red, green, blue, alpha; -1: the first three
    double low = 0, high = 1;      // the values shown as black and white, of textures of floats
    double scale = 1;              // 1: all texels fit
    double x = .5, y = .5;         // what is in the middle of the picture, as fractions of the texture
    float width = 0, height = 0;   // of the picture, in window coordinates
    bool aimed = false;            // the pointer was moved over the picture, so that the wheel does not scroll
    bool inspecting = false;       // I is held while the pointer is over the picture
    int texel_x = 0, texel_y = 0;  // under the pointer, from the left and from the top
};

// The row that is shown: the chosen one, else the first that is loaded. rows.size() if there is none.
std::size_t chosen_row(std::span<const TextureRow> rows, const TextureMemory& memory);

// The part of a texture of that size that the picture shows.
struct TexturePart {
    double left = 0, top = 0;  // the texel at the picture's corner
    double zoom = 1;           // window coordinates per texel
};
TexturePart texture_part(const TextureMemory& memory, int width, int height);

// Draws the section; TextureMemory::open says whether it is open.
void textures_section(const Facts& facts, Memory& memory, Layout& layout);
// Draws the values of the texel under the pointer, after all panels.
void texel_inspector(const Facts& facts, TextureMemory& memory, const Fonts& fonts, Layout& layout);

}  // namespace snell::ui
