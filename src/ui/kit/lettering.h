// Draws small text into pictures in memory, without GL.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace snell::ui {

class Lettering {
public:
    Lettering();
    ~Lettering();
    Lettering(const Lettering&) = delete;
    Lettering& operator=(const Lettering&) = delete;

    // Sizes in pixels.
    int line_height() const;
    int width(std::string_view text) const;
    // Draws white text over the RGB bytes of a picture that is `stride` pixels wide; (x, y) is the text's upper left
    // corner. Letters that would pass column `right` are left out. The line of text must lie within the picture
    // vertically.
    void draw(std::string_view text, std::span<std::uint8_t> rgb, int stride, int x, int y, int right) const;

private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace snell::ui
