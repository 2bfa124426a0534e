#include "src/app/picture/sheet.h"

#include <algorithm>

#include "src/ui/kit/lettering.h"

namespace snell::app {

namespace {

constexpr int largest = 160, gap = 4;
constexpr std::uint8_t paper = 32;

content::Image blank(int width, int height, std::uint8_t gray) {
    content::Image image{.width = width, .height = height, .channels = 3};
    image.pixels.assign(image.bytes(), std::byte{gray});
    return image;
}

// Breaks the label into lines that are at most as wide as its tile.
std::vector<std::string> lines_of(const ui::Lettering& letters, const std::string& label, int width) {
    std::vector<std::string> lines(1);
    for (std::size_t begin = 0; begin < label.size();) {
        const std::size_t end = std::min(label.find(' ', begin), label.size());
        const std::string word = label.substr(begin, end - begin);
        const std::string longer = lines.back().empty() ? word : lines.back() + " " + word;
        if (lines.back().empty() || letters.width(longer) <= width)
            lines.back() = longer;
        else
            lines.push_back(word);
        begin = end + 1;
    }
    return lines;
}

void place(content::Image& sheet, const content::Image& tile, int x, int y) {
    for (int row = 0; row < tile.height; ++row)
        std::copy_n(tile.pixels.begin() + static_cast<std::ptrdiff_t>(tile.row_bytes()) * row, tile.row_bytes(),
                    sheet.pixels.begin() + (static_cast<std::ptrdiff_t>(y + row) * sheet.width + x) * 3);
}

}  // namespace

content::Image thumbnail(const content::Image& picture, bool light) {
    const auto channels = static_cast<std::size_t>(picture.channels);
    return content::reduced(picture.width, picture.height, largest, largest, [&](int x, int y, std::size_t channel) {
        const auto pixel =
            static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
        // A picture with one or two channels is grey.
        const double value = content::value_at(picture, pixel * channels + (channels < 3 ? 0 : channel));
        return light ? content::srgb_of_light(value) : value;
    });
}

content::Image contact_sheet(const std::vector<Tile>& tiles, std::size_t columns, bool labels) {
    const ui::Lettering letters;
    int width = 1, height = 1;
    for (const Tile& tile : tiles) {
        width = std::max(width, tile.picture.width);
        height = std::max(height, tile.picture.height);
    }
    width = labels ? std::max(width, 96) : width;
    std::size_t lines = 0;
    for (const Tile& tile : tiles) lines = std::max(lines, labels ? lines_of(letters, tile.label, width).size() : 0);
    const int step_x = width + gap, step_y = height + gap + static_cast<int>(lines) * letters.line_height();
    columns = std::clamp<std::size_t>(columns, 1, std::max<std::size_t>(tiles.size(), 1));
    const auto rows = static_cast<int>((tiles.size() + columns - 1) / columns);
    content::Image sheet = blank(static_cast<int>(columns) * step_x + gap, std::max(rows, 1) * step_y + gap, paper);
    const std::span<std::uint8_t> rgb(reinterpret_cast<std::uint8_t*>(sheet.pixels.data()), sheet.pixels.size());
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const int x = gap + static_cast<int>(i % columns) * step_x, y = gap + static_cast<int>(i / columns) * step_y;
        place(sheet, tiles[i].picture, x + (width - tiles[i].picture.width) / 2, y);
        if (!labels) continue;
        int line = y + height + 1;
        for (const std::string& text : lines_of(letters, tiles[i].label, width)) {
            letters.draw(text, rgb, sheet.width, x, line, x + width);
            line += letters.line_height();
        }
    }
    return sheet;
}

}  // namespace snell::app
