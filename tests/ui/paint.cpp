#include "tests/ui/paint.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <string_view>
#include <utility>

namespace snell::ui {

namespace {

struct Color {
    float r = 0, g = 0, b = 0, a = 0;
};

Color unpack(ImU32 c) {
    const auto byte = [&](int shift) { return static_cast<float>(c >> shift & 255) / 255; };
    return {byte(IM_COL32_R_SHIFT), byte(IM_COL32_G_SHIFT), byte(IM_COL32_B_SHIFT), byte(IM_COL32_A_SHIFT)};
}

// The atlas of letters; bilinear.
struct Texture {
    unsigned char* alpha = nullptr;
    int width = 0, height = 0;

    Texture() { ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&alpha, &width, &height); }
    float at(int x, int y) const {
        x = std::clamp(x, 0, width - 1);
        y = std::clamp(y, 0, height - 1);
        return static_cast<float>(alpha[y * width + x]) / 255;
    }
    float sample(float u, float v) const {
        const float x = u * static_cast<float>(width) - .5F, y = v * static_cast<float>(height) - .5F;
        const float fx = x - std::floor(x), fy = y - std::floor(y);
        const int ix = static_cast<int>(std::floor(x)), iy = static_cast<int>(std::floor(y));
        return (at(ix, iy) * (1 - fx) + at(ix + 1, iy) * fx) * (1 - fy) +
               (at(ix, iy + 1) * (1 - fx) + at(ix + 1, iy + 1) * fx) * fy;
    }
};

class Painting {
public:
    Painting(int width, int height, ImVec2 density) : width_(width), height_(height), density_(density) {
        pixels_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const float shade = .3F + .2F * static_cast<float>((x / 40 + y / 40) % 2);
                at(x, y) = {shade, shade, shade * 1.1F, 1};
            }
    }

    // `image`: with a texture that is not the atlas, of which only the place is known.
    void triangle(const ImDrawVert& a, const ImDrawVert& b, const ImDrawVert& c, const ImVec4& clip, bool image) {
        const auto place = [&](const ImDrawVert& v) { return ImVec2(v.pos.x * density_.x, v.pos.y * density_.y); };
        const ImVec2 p = place(a), q = place(b), r = place(c);
        const float area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        if (area == 0) return;
        const auto bound = [](float low, float high, float from, float to, int size) {
            return std::pair(std::clamp(static_cast<int>(std::floor(std::max(low, from))), 0, size),
                             std::clamp(static_cast<int>(std::ceil(std::min(high, to))), 0, size));
        };
        const auto [left, right] = bound(std::min({p.x, q.x, r.x}), std::max({p.x, q.x, r.x}), clip.x * density_.x,
                                         clip.z * density_.x, width_);
        const auto [top, bottom] = bound(std::min({p.y, q.y, r.y}), std::max({p.y, q.y, r.y}), clip.y * density_.y,
                                         clip.w * density_.y, height_);
        const Color ca = unpack(a.col), cb = unpack(b.col), cc = unpack(c.col);
        for (int y = top; y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const float px = static_cast<float>(x) + .5F, py = static_cast<float>(y) + .5F;
                const float wc = ((q.x - p.x) * (py - p.y) - (q.y - p.y) * (px - p.x)) / area;
                const float wb = ((px - p.x) * (r.y - p.y) - (py - p.y) * (r.x - p.x)) / area;
                const float wa = 1 - wb - wc;
                if (wa < 0 || wb < 0 || wc < 0) continue;
                const auto mix = [&](float x0, float x1, float x2) { return x0 * wa + x1 * wb + x2 * wc; };
                const float u = mix(a.uv.x, b.uv.x, c.uv.x), v = mix(a.uv.y, b.uv.y, c.uv.y);
                const float cover = mix(ca.a, cb.a, cc.a) * (image ? 1 : texture_.sample(u, v));
                Color& to = at(x, y);
                to.r += ((image ? u : mix(ca.r, cb.r, cc.r)) - to.r) * cover;
                to.g += ((image ? v : mix(ca.g, cb.g, cc.g)) - to.g) * cover;
                to.b += ((image ? .5F : mix(ca.b, cb.b, cc.b)) - to.b) * cover;
            }
    }

    content::Image image() const {
        content::Image image;
        image.width = width_;
        image.height = height_;
        image.channels = 3;
        const auto byte = [](float v) { return static_cast<std::byte>(std::lround(255 * std::clamp(v, 0.0F, 1.0F))); };
        for (const Color& c : pixels_) image.pixels.insert(image.pixels.end(), {byte(c.r), byte(c.g), byte(c.b)});
        return image;
    }

private:
    Color& at(int x, int y) { return pixels_[static_cast<std::size_t>(y * width_ + x)]; }

    int width_, height_;
    ImVec2 density_;
    Texture texture_;
    std::vector<Color> pixels_;
};

// A letter on the screen.
struct Letter {
    ImVec4 box;  // of its ink
    ImWchar code = 0;
    int list = 0;
};

std::string text_of(ImWchar code) { return code < 128 ? std::string(1, static_cast<char>(code)) : "?"; }

struct Reading {
    std::vector<Letter> letters;
    std::vector<std::string> flaws;
};

std::string near(const std::vector<Letter>& letters, const ImVec4& box) {
    std::string text;
    for (const Letter& letter : letters)
        if (std::abs(letter.box.y - box.y) < 12 && letter.box.x > box.x - 220 && letter.box.x < box.x + 60)
            text += text_of(letter.code);
    return text + " at " + std::to_string(static_cast<int>(box.x)) + "," + std::to_string(static_cast<int>(box.y));
}

using Corner = std::pair<float, float>;

std::map<Corner, const ImFontGlyph*> glyphs_by_corner() {
    std::map<Corner, const ImFontGlyph*> found;
    for (const ImFont* font : ImGui::GetIO().Fonts->Fonts)
        for (const ImFontGlyph& glyph : font->Glyphs)
            if (glyph.Visible) found.emplace(Corner(glyph.U0, glyph.V0), &glyph);
    return found;
}

// Letters are quads: two triangles of four vertices in a row, whose first is at the corner of a glyph in the atlas.
void read(const ImDrawList& list, int index, const std::map<Corner, const ImFontGlyph*>& glyphs, Reading& reading) {
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const ImVec4 clip = command.ClipRect;
        for (unsigned i = command.IdxOffset; i + 5 < command.IdxOffset + command.ElemCount; i += 3) {
            const auto corner = [&](unsigned k) -> const ImDrawVert& {
                return list.VtxBuffer[static_cast<int>(command.VtxOffset) + list.IdxBuffer[static_cast<int>(i + k)]];
            };
            const ImDrawVert &first = corner(0), &last = corner(2);
            const auto glyph = glyphs.find({first.uv.x, first.uv.y});
            if (glyph == glyphs.end() || list.IdxBuffer[static_cast<int>(i + 3)] != list.IdxBuffer[static_cast<int>(i)])
                continue;
            const ImVec4 box(first.pos.x, first.pos.y, last.pos.x, last.pos.y);
            if (box.y >= clip.w || box.w <= clip.y) continue;  // scrolled away
            constexpr float little = 1.01F;                    // the edge of a letter is soft
            const bool trimmed = last.uv.x < glyph->second->U1 - 1e-6F;
            reading.letters.push_back({box, static_cast<ImWchar>(glyph->second->Codepoint), index});
            if (trimmed || box.x < clip.x - little || box.z > clip.z + little)
                reading.flaws.push_back("cut off: " + near(reading.letters, box));
        }
    }
}

std::string_view owner_of(const ImDrawList& list) { return list._OwnerName ? list._OwnerName : ""; }

// Over and under all windows: the values over the picture have edges in letters of their own.
bool is_no_window(const ImDrawList& list) {
    return owner_of(list).starts_with("##Background") || owner_of(list).starts_with("##Foreground");
}

// It is meant to hide what is under it.
bool covers(const ImDrawList& list) {
    const std::string_view owner = owner_of(list);
    return owner.starts_with("##Tooltip") || owner.starts_with("##Popup") || owner.starts_with("##Combo") ||
           owner.starts_with("##inspector");
}

// Where the picture has no room for it, it lies over the panel, and hides what is there.
bool lies_over(const ImDrawList& list) {
    const std::string_view owner = owner_of(list);
    return owner.starts_with("##states") || owner.starts_with("##problems") || owner.starts_with("##message") ||
           owner.starts_with("##legend");
}

bool is_dialog(const ImDrawList& list) {
    const std::string_view owner = owner_of(list);
    return !owner.empty() && !owner.starts_with("##");
}

}  // namespace

content::Image paint(const ImDrawData& data) {
    const ImVec2 density = data.FramebufferScale;
    Painting painting(static_cast<int>(std::lround(data.DisplaySize.x * density.x)),
                      static_cast<int>(std::lround(data.DisplaySize.y * density.y)), density);
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        for (const ImDrawCmd& command : list.CmdBuffer)
            for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
                const auto corner = [&](unsigned k) -> const ImDrawVert& {
                    return list.VtxBuffer[static_cast<int>(command.VtxOffset) +
                                          list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)]];
                };
                painting.triangle(corner(0), corner(1), corner(2), command.ClipRect,
                                  command.TextureId != ImGui::GetIO().Fonts->TexID);
            }
    }
    return painting.image();
}

std::vector<std::string> flaws(const ImDrawData& data) {
    Reading reading;
    const auto glyphs = glyphs_by_corner();
    const std::span<ImDrawList* const> lists(data.CmdLists, static_cast<std::size_t>(data.CmdListsCount));
    // Dialogs, which lie over all the rest, are the windows whose name is a title.
    const bool dialog = std::ranges::any_of(lists, [](const ImDrawList* list) { return is_dialog(*list); });
    for (std::size_t n = 0; n < lists.size(); ++n)
        if (!is_no_window(*lists[n]) && (!dialog || is_dialog(*lists[n])))
            read(*lists[n], static_cast<int>(n), glyphs, reading);
    std::vector<Letter>& letters = reading.letters;
    std::erase_if(letters, [&](const Letter& letter) { return covers(*lists[static_cast<std::size_t>(letter.list)]); });
    std::ranges::sort(letters, [](const Letter& a, const Letter& b) { return a.box.x < b.box.x; });
    for (std::size_t i = 0; i < letters.size(); ++i)
        for (std::size_t k = i + 1; k < letters.size() && letters[k].box.x < letters[i].box.z; ++k) {
            const auto over = [&](std::size_t one, std::size_t other) {
                const auto list_of = [&](std::size_t n) -> const ImDrawList& {
                    return *lists[static_cast<std::size_t>(letters[n].list)];
                };
                return lies_over(list_of(one)) && owner_of(list_of(other)).starts_with("##panel");
            };
            if (over(i, k) || over(k, i)) continue;
            const ImVec4 &a = letters[i].box, &b = letters[k].box;
            const float wide = std::min(a.z, b.z) - std::max(a.x, b.x), high = std::min(a.w, b.w) - std::max(a.y, b.y);
            // Neighbours may touch; what is written over something else covers it.
            const float share = .35F * std::min({a.z - a.x, b.z - b.x, a.w - a.y, b.w - b.y});
            if (wide > std::max(1.5F, share) && high > std::max(1.5F, share))
                reading.flaws.push_back("upon each other: " + near(letters, a) + " and " + near(letters, b));
        }
    constexpr std::size_t most = 8;
    if (reading.flaws.size() > most) reading.flaws.resize(most);
    return reading.flaws;
}

}  // namespace snell::ui
