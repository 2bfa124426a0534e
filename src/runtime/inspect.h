// What pixels of a picture are before they are made bytes, what drew them, and colours that bytes can't show.
// Which draw is seen at each pixel, by drawing the scene with its own programs: whatever these move, make or discard is
// where the picture has it.
//
// One draw at a time goes to a cover, whose alpha is 1 before: blending leaves 0 where a fragment of it passed, or,
// where the draw blends by its alpha, what that lets through. So the same bits that make an object invisible in the
// picture leave no trace of it here. Then a pass over the screen writes the draw's number wherever the cover is not 1.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "parser/scene.h"
#include "src/gl/handle.h"
#include "src/gl/target.h"
#include "src/runtime/runtime.h"

namespace snell {

// A square of pixels about one of them.
struct Inspection {
    int x = 0, y = 0;  // that pixel, from the left and from the top
    int radius = 0;    // the square is 2 radius + 1 wide
    std::vector<float> rgba;
    std::vector<char> inside;        // of the picture: 0 or 1, as many as there are pixels in the square
    std::optional<double> depth;     // of the pixel: 0 to 1; none: the context does not tell
    std::optional<double> distance;  // of the eye, along the view axis, in the scene's units; none: nothing there
    Index draw = none;               // Scene::draws: what is seen there
    bool light = false;              // the values are light, and encoded for the display

    // `right` and `down` of the pixel, at most `radius` away. Rows are kept top first.
    std::size_t at(int right, int down) const {
        return static_cast<std::size_t>((down + radius) * (2 * radius + 1) + right + radius);
    }
    std::span<const float, 4> pixel(int right = 0, int down = 0) const {
        return std::span<const float>(rgba).subspan(4 * at(right, down)).first<4>();
    }
};

// A picture in 32-bit floats, one sample at the middle of each pixel. Off-screen targets hold bytes as ever. Nothing is
// clamped, not even before blending, where bytes are: an alpha of 3 would triple its colour and take the background
// away twice. Where the last fragment has an alpha beyond 0 to 1, its pixel is therefore what that fragment wrote.
class FloatPicture {
public:
    // False: the context refused it. Nothing happens where it has that size.
    bool resize(int width, int height);
    int width() const { return target_.width; }
    int height() const { return target_.height; }

    // Draws the frame, and reads it: rows top first. `part`: only that, into the place that it has among them.
    void draw(Runtime& runtime, const Frame& frame, std::vector<float>& rgba,
              const std::optional<PixelRect>& part = {});
    // Draws only the square, to the same values, and reads it with its depth.
    void inspect(Runtime& runtime, const Frame& frame, int x, int y, int radius, Inspection& found);

private:
    void take(Runtime& runtime, const Frame& frame, const Surface& surface, std::vector<float>& rows);

    gl::Target target_;
    std::vector<float> rows_, written_;
};

// Colours that a picture of bytes can't show: of one kind or none, by what is worst about them.

enum class Flag : std::uint8_t { none, above_one, negative, infinite, nan };
inline constexpr std::size_t flag_count = 5;

// "NaN"; of none "".
std::string_view name(Flag flag);
// RGB bytes that pixels are painted with, told apart by who sees fewer colours, too.
std::array<std::uint8_t, 3> color_of(Flag flag);

// Of one channel.
Flag flag_of(float value);
// Of RGBA: alpha only where it is no number, since what is beyond 0 to 1 there shows nowhere.
Flag flag_of(std::span<const float, 4> rgba);

// Pixels by Flag; each counts once.
struct FlagCounts {
    std::array<std::size_t, flag_count> pixels{};
    std::size_t operator[](Flag flag) const { return pixels[static_cast<std::size_t>(flag)]; }
    bool operator==(const FlagCounts&) const = default;
    FlagCounts& operator+=(const FlagCounts& more) {
        for (std::size_t i = 0; i < flag_count; ++i) pixels[i] += more.pixels[i];
        return *this;
    }
};
FlagCounts count_flags(std::span<const float> rgba);
// Of each of so many columns, one or more.
std::vector<FlagCounts> count_flags(std::span<const float> rgba, int columns);

// RGBA bytes of as many pixels: flagged ones in their colours, the others in dim greys.
void paint_flags(std::span<const float> rgba, std::vector<std::byte>& picture);

}  // namespace snell

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
