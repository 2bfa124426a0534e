// Small text in pictures, without GL.
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

    int line_height() const;
    int width(std::string_view text) const;
    // White, over the RGB bytes of a picture that is `stride` pixels wide; (x, y) is the upper left corner. Letters
    // that would pass `right` are left out. The text's line must lie within the picture.
    void draw(std::string_view text, std::span<std::uint8_t> rgb, int stride, int x, int y, int right) const;

private:
    struct Font;
    std::unique_ptr<Font> font_;
};

}  // namespace snell::ui
