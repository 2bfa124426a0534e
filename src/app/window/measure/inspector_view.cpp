#include "src/app/window/measure/inspector_view.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/plan/locate.h"
#include "src/runtime/explain.h"

namespace snell {

Frame drawn_again(const Document& shown, const Stand& stand, View& view) {
    view = stand.view;
    view.axes = false;
    Frame frame{.time = stand.time, .view = view, .controls = shown.controls, .paced = true};
    frame.standing = true;
    frame.enlarged = stand.enlarged;
    return frame;
}

bool PixelView::follow(const Sight& sight, const ui::PixelMemory& memory) {
    const Stand& stand = sight.stand;
    const bool wanted = (memory.inspecting || memory.flags) && stand.width > 0 && stand.height > 0;
    if (!wanted) {
        const bool had = pixels_ != nullptr;
        if (had) *this = {};
        return had;
    }
    if (!pixels_) pixels_ = std::make_unique<FloatPicture>();
    if (!pixels_->resize(stand.width, stand.height)) {
        facts_.note = "The graphics driver has no pictures of floats.";
        return false;
    }
    const bool none = ranges::none_of(sight.halves, [](const Half& half) { return half.document != nullptr; });
    facts_.note = sight.heat ? "The heat map has no marks." : none ? "There is no picture to be marked." : "";
    const bool fresh = follow_pointer(sight, memory);
    return follow_flags(sight, memory.flags && facts_.note.empty()) || fresh;
}

bool PixelView::follow_pointer(const Sight& sight, const ui::PixelMemory& memory) {
    const Stand& stand = sight.stand;
    const int x = std::clamp(static_cast<int>(std::floor(memory.x * sight.density)), 0, stand.width - 1);
    const int y = std::clamp(static_cast<int>(std::floor(memory.y * sight.density)), 0, stand.height - 1);
    const Half& half = sight.halves[sight.halves.size() > 1 && x >= sight.divider ? 1 : 0];
    if (!memory.inspecting || !half.document) {
        looked_ = 0;
        return std::exchange(facts_.inspection, nullptr) != nullptr;
    }
    if (looked_ == sight.picture && found_.x == x && found_.y == y && half_ == half.name) return false;
    half_ = half.name;
    look(*half.document, stand, x, y);
    looked_ = sight.picture;
    return true;
}

bool PixelView::follow_flags(const Sight& sight, bool wanted) {
    if (!wanted) return unflag();
    bool fresh = false;
    std::pair now{sight.picture, std::vector<std::string>()};
    for (const Half& half : sight.halves) now.second.push_back(half.name);
    if (flagged_ != now) {
        const bool waits = sight.lasts > 0 && !sight.sharp, waited = facts_.drawn.value_or(1) == 0;
        if (!waits || !waited) fresh = unflag();
        if (waits) {
            facts_.drawn = 0;
            return !waited;
        }
        flagged_ = std::move(now);
    }
    if (marked_.size() < sight.halves.size()) {
        flag(sight);
        fresh = true;
    }
    return count(sight) || fresh;
}

bool PixelView::unflag() {
    const bool had = !facts_.flags.empty() || facts_.drawn.has_value();
    facts_.flags.clear();
    facts_.drawn.reset();
    strips_.reset();
    marked_.clear();
    flagged_ = {};
    return had;
}

void PixelView::look(Document& shown, const Stand& stand, int x, int y) {
    pixels_->inspect(*shown.runtime, drawn_again(shown, stand, view_), x, y, radius, found_);
    facts_.inspection = &found_;
    facts_.at = fmt::format("pixel {}, {}", found_.x, found_.y);
    facts_.half = half_;
    facts_.statement.clear();
    facts_.place.clear();
    if (found_.draw >= shown.scene().draws.size()) return;
    const Span& span = shown.scene().draws[found_.draw].span;
    facts_.statement = statement_text(span, shown.sources);
    facts_.place = statement_place(span, shown.sources);
}

void PixelView::flag(const Sight& sight) {
    using Clock = std::chrono::steady_clock;
    const Stand& stand = sight.stand;
    const std::size_t count = sight.halves.size();
    while (marked_.size() < count) {
        Document* const shown = sight.halves[marked_.size()].document;
        if (shown) {
            if (!strips_) strips_.emplace(stand.width, stand.height, sight.lasts);
            const bool whole = strips_->draw([&](const PixelRect& strip) {
                const Clock::time_point start = Clock::now();
                pixels_->draw(*shown->runtime, drawn_again(*shown, stand, view_), rgba_, strip);
                return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
            });
            facts_.drawn = (static_cast<double>(marked_.size()) + strips_->share()) / static_cast<double>(count);
            if (!whole) return;
        }
        strips_.reset();
        Marked& marked = marked_.emplace_back();
        if (!shown) continue;
        marked.columns = count_flags(rgba_, stand.width);
        paint_flags(rgba_, painted_);
        marked.still.set(stand.width, stand.height, painted_);
    }
    facts_.drawn.reset();
}

bool PixelView::count(const Sight& sight) {
    std::vector<ui::Flagged> seen;
    for (std::size_t i = 0; marked_.size() == sight.halves.size() && i < marked_.size(); ++i) {
        const std::vector<FlagCounts>& columns = marked_[i].columns;
        if (columns.empty()) continue;
        const std::ptrdiff_t divider = sight.divider;
        FlagCounts counts;
        std::for_each(i == 0 ? columns.begin() : columns.begin() + divider,
                      i == 0 && marked_.size() > 1 ? columns.begin() + divider : columns.end(),
                      [&](const FlagCounts& column) { counts += column; });
        seen.push_back({sight.halves[i].name, counts});
    }
    return std::exchange(facts_.flags, seen) != seen;
}

void PixelView::show(int y, std::optional<int> divider) const {
    if (facts_.flags.empty()) return;
    marked_.front().still.show(0, y, 1);
    if (divider && marked_.size() > 1) marked_.back().still.show(0, y, 1, *divider);
}

namespace {

constexpr int radius = 4;       // of the magnified area, in texels
constexpr int strip = 1 << 20;  // texels that are read at once to count them
constexpr std::array<const char*, 6> face_names{"+X", "-X", "+Y", "-Y", "+Z", "-Z"};

bool is_cube(const gl::Plane& plane) { return plane.target == GL_TEXTURE_CUBE_MAP; }

std::string size_text(const gl::Plane& plane) {
    const std::string size = fmt::format("{} x {}", plane.size[0], plane.size[1]);
    if (is_cube(plane)) return "6 x " + size;
    return plane.target == GL_TEXTURE_1D   ? fmt::format("{}", plane.size[0])
           : plane.target == GL_TEXTURE_3D ? fmt::format("{} x {}", size, plane.size[2])
                                           : size;
}

std::string_view format_name(gl::Pixels pixels) {
    constexpr std::array<std::string_view, 4> names{"RGBA8", "sRGB8", "RGBA16F", "RGBA32F"};  // as gl::Pixels
    return names[static_cast<std::size_t>(pixels)];
}

bool are_floats(gl::Pixels pixels) { return pixels == gl::Pixels::rgba16f || pixels == gl::Pixels::rgba32f; }

std::array<std::array<float, 3>, 4> marks() {
    std::array<std::array<float, 3>, 4> colors{};
    for (std::size_t flag = 0; flag < colors.size(); ++flag)
        ranges::transform(color_of(static_cast<Flag>(flag + 1)), colors[flag].begin(),
                          [](std::uint8_t byte) { return static_cast<float>(byte) / 255; });
    return colors;
}

std::string texel_text(const gl::Plane& plane, const std::array<int, 3>& texel) {
    if (is_cube(plane))
        return fmt::format("{} texel {}, {}", face_names[static_cast<std::size_t>(texel[2])], texel[0], texel[1]);
    if (plane.target == GL_TEXTURE_1D) return fmt::format("texel {}", texel[0]);
    if (plane.target == GL_TEXTURE_3D) return fmt::format("texel {}, {}, {}", texel[0], texel[1], texel[2]);
    return fmt::format("texel {}, {}", texel[0], texel[1]);
}

std::string coordinates_text(const gl::Plane& plane, const std::array<int, 3>& texel) {
    const auto [s, t, p] = plane.coordinates(texel);
    if (is_cube(plane)) return fmt::format("direction {:.5g}, {:.5g}, {:.5g}", s, t, p);
    if (plane.target == GL_TEXTURE_1D) return fmt::format("s = {:.6g}", s);
    if (plane.target == GL_TEXTURE_3D) return fmt::format("s, t, p = {:.5g}, {:.5g}, {:.5g}", s, t, p);
    return fmt::format("s, t = {:.6g}, {:.6g}", s, t);
}

}  // namespace

// The panels of the last frame may still show the picture, so that it is deleted one frame later.
bool TextureView::close() {
    if (!viewer_) return false;
    if (!std::exchange(open_, false)) *this = TextureView(es_);
    return viewer_ != nullptr;
}

bool TextureView::follow(const Document& shown, std::uint64_t revision, std::uint64_t picture, const ui::Memory& memory,
                         float density) {
    const ui::TextureMemory& wanted = memory.textures;
    if (!wanted.open) return close();
    bool fresh = !std::exchange(open_, true);
    if (!viewer_) viewer_ = std::make_unique<gl::TexelViewer>(es_);
    if (const std::pair now{revision, shown.runtime->form()}; listed_ != now) {
        list(shown);
        listed_ = now;
        fresh = true;
    }
    const std::size_t row = ui::chosen_row(rows_, wanted);
    if (row == rows_.size() || !rows_[row].loaded) return fresh;
    const Source& source = sources_[row];
    std::optional<Runtime::Held> held =
        source.noise ? shown.runtime->noise(source.noise) : shown.runtime->texture(source.texture);
    if (!held) return fresh;
    facts_.levels = held->levels;
    facts_.floats = are_floats(held->pixels);
    gl::Plane& plane = held->plane;
    plane.level = std::clamp(wanted.level, 0, facts_.levels - 1);
    facts_.slices = plane.target == GL_TEXTURE_3D ? plane.along(2) : 1;
    plane.slice = std::clamp(wanted.slice, 0, facts_.slices - 1);
    fresh |= std::exchange(facts_.width, plane.width()) != plane.width();
    fresh |= std::exchange(facts_.height, plane.height()) != plane.height();
    light_ = shown.runtime->display_pixels() == gl::Pixels::srgb8;
    const Shown now{row, plane.level, plane.slice, listed_, held->changes ? picture : 0};
    fresh |= draw(plane, now, memory, density);
    fresh |= look(plane, now, wanted);
    fresh |= count(plane, now, memory.pixels.flags);
    return fresh;
}

void TextureView::add(Source source, std::string name, std::string why, const std::optional<Runtime::Held>& held) {
    ui::TextureRow row;
    row.name = name;
    for (int same = 2; ranges::count(rows_, row.name, &ui::TextureRow::name) > 0; ++same)
        row.name = fmt::format("{} ({})", name, same);
    row.why = std::move(why);
    row.loaded = held.has_value();
    if (held) {
        row.size = size_text(held->plane);
        row.format = format_name(held->pixels);
        if (held->levels > 1) row.format += fmt::format(", {} levels", held->levels);
    }
    rows_.push_back(std::move(row));
    sources_.push_back(source);
}

void TextureView::list(const Document& shown) {
    rows_.clear();
    sources_.clear();
    const Runtime& runtime = *shown.runtime;
    const std::vector<Texture>& textures = shown.scene().textures;
    const Explanation explanation = runtime.explain();
    for (const Explanation::Paid& paid : explanation.paid)
        if (paid.noise)
            add({none, paid.noise}, fmt::format("Noise{}", paid.noise), paid.why, runtime.noise(paid.noise));
        else if (paid.texture != none)
            add({paid.texture, 0}, title_of(textures[paid.texture]), paid.why, runtime.texture(paid.texture));
    for (Index i = 0; i < textures.size(); ++i) {
        if (runtime.texture(i)) continue;
        const auto unused = ranges::find(explanation.unused, i, &Explanation::Unused::texture);
        add({i, 0}, title_of(textures[i]),
            unused != explanation.unused.end() ? unused->why : "no program for these values reads it", std::nullopt);
    }
    facts_.rows = rows_;
}

bool TextureView::draw(const gl::Plane& plane, const Shown& shown, const ui::Memory& memory, float density) {
    const ui::TextureMemory& wanted = memory.textures;
    const int width = static_cast<int>(std::lround(wanted.width * density));
    const int height = static_cast<int>(std::lround(wanted.height * density));
    if (width <= 0 || height <= 0) return false;
    const ui::TexturePart part = ui::texture_part(wanted, plane.width(), plane.height());
    gl::TexelLook look{.left = part.left, .top = part.top, .zoom = part.zoom * density, .channel = wanted.channel};
    if (facts_.floats && wanted.low != wanted.high) {
        look.low = static_cast<float>(wanted.low);
        look.high = static_cast<float>(wanted.high);
    }
    look.light = light_ && wanted.channel < 3;
    look.flags = memory.pixels.flags;
    look.marks = marks();
    Drawn now{shown, look, width, height};
    if (now == drawn_) return false;
    drawn_ = now;
    facts_.picture = viewer_->draw(plane, look, width, height) ? viewer_->picture() : 0;
    ++facts_.drawn;
    return true;
}

bool TextureView::look(const gl::Plane& plane, const Shown& shown, const ui::TextureMemory& memory) {
    const int x = memory.texel_x, y = memory.texel_y;
    const auto texel = plane.texel(x, y);
    if (!memory.inspecting || !texel) {
        looked_.reset();
        return std::exchange(facts_.texel.inspection, nullptr) != nullptr;
    }
    if (looked_ == shown && found_.x == x && found_.y == y) return false;
    looked_ = shown;
    found_.x = x;
    found_.y = y;
    found_.radius = radius;
    found_.light = light_;
    constexpr int side = 2 * radius + 1;
    ++facts_.read;
    if (!viewer_->read(plane, x - radius, y - radius, side, side, found_.rgba)) return false;
    found_.inside.assign(std::size_t{side} * side, 0);
    for (int down = -radius; down <= radius; ++down)
        for (int right = -radius; right <= radius; ++right)
            found_.inside[found_.at(right, down)] = plane.texel(x + right, y + down).has_value();
    facts_.texel.inspection = &found_;
    facts_.texel.at = texel_text(plane, *texel);
    facts_.texel.statement = coordinates_text(plane, *texel);
    facts_.texel.place = fmt::format("level {}, {}", plane.level, rows_[shown.row].format);
    return true;
}

bool TextureView::count(const gl::Plane& plane, const Shown& shown, bool wanted) {
    if (!wanted) {
        counted_.reset();
        return !std::exchange(facts_.texel.flags, {}).empty();
    }
    if (counted_ == shown) return false;
    counted_ = shown;
    FlagCounts counts;
    std::vector<float> rgba;
    const int rows = std::clamp(strip / plane.width(), 1, plane.height());
    for (int top = 0; facts_.floats && top < plane.height(); top += rows) {
        ++facts_.read;
        if (!viewer_->read(plane, 0, top, plane.width(), std::min(rows, plane.height() - top), rgba)) break;
        counts += count_flags(rgba);
    }
    facts_.texel.flags = {{"", counts}};
    return true;
}

}  // namespace snell
