#include "src/ui/kit/lettering.h"

#include <imgui.h>

#include <algorithm>

namespace snell::ui {

struct Lettering::Font {
    ImFontAtlas atlas;
    ImFont* font = nullptr;
    unsigned char* alpha = nullptr;
    int width = 0, height = 0;
};

Lettering::Lettering() : font_(std::make_unique<Font>()) {
    font_->font = font_->atlas.AddFontDefault();
    font_->atlas.GetTexDataAsAlpha8(&font_->alpha, &font_->width, &font_->height);
}
Lettering::~Lettering() = default;

int Lettering::line_height() const { return static_cast<int>(font_->font->FontSize) + 1; }

int Lettering::width(std::string_view text) const {
    float width = 0;
    for (const char c : text) width += font_->font->GetCharAdvance(static_cast<unsigned char>(c));
    return static_cast<int>(width);
}

void Lettering::draw(std::string_view text, std::span<std::uint8_t> rgb, int stride, int x, int y, int right) const {
    for (const char c : text) {
        const ImFontGlyph* glyph = font_->font->FindGlyph(static_cast<unsigned char>(c));
        if (x + static_cast<int>(glyph->AdvanceX) > right) return;
        const int left = static_cast<int>(glyph->U0 * static_cast<float>(font_->width) + .5F);
        const int top = static_cast<int>(glyph->V0 * static_cast<float>(font_->height) + .5F);
        const int columns = static_cast<int>(glyph->X1 - glyph->X0), rows = static_cast<int>(glyph->Y1 - glyph->Y0);
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column) {
                const std::uint8_t alpha = font_->alpha[(top + row) * font_->width + left + column];
                const auto at = static_cast<std::size_t>((y + static_cast<int>(glyph->Y0) + row) * stride + x +
                                                         static_cast<int>(glyph->X0) + column);
                if (at * 3 + 2 >= rgb.size()) continue;
                for (std::size_t channel = 0; channel < 3; ++channel)
                    rgb[at * 3 + channel] = std::max(rgb[at * 3 + channel], alpha);
            }
        x += static_cast<int>(glyph->AdvanceX);
    }
}

}  // namespace snell::ui
