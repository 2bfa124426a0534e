#include "tools/environments/paint.h"

#include <algorithm>
#include <cmath>

#include "tools/environments/letters.h"
#include "tools/environments/noise.h"
#include "tools/environments/sky.h"

namespace snell::environments {
namespace {

// As seen from the middle of the room by someone who faces the wall.
struct WallPlace {
    double right, up;
};

// 0..5: +X -X +Y -Y +Z -Z. The shell's normals point inward: the +X wall's is -X.
int wall_number(const Spot& spot) { return 2 * spot.axis + (spot.normal[spot.axis] > 0 ? 1 : 0); }

// 0 outside, 1 inside, with an edge `soft` wide.
double within(double x, double low, double high, double soft = 0.02) {
    return smooth(low - soft, low + soft, x) * (1.0 - smooth(high - soft, high + soft, x));
}

// A raised rectangle's edge: light from above left.
double bevel(double x, double y, double half_x, double half_y, double width) {
    const double dx = half_x - std::abs(x), dy = half_y - std::abs(y), nearest = std::min(dx, dy);
    if (nearest < 0.0 || nearest > width) return 1.0;
    const bool side = dx < dy;
    return side ? (x < 0 ? 0.86 : 1.06) : (y > 0 ? 0.80 : 1.12);
}

Colour sign_colour(const Colour& behind, std::string_view text, double right, double up) {
    const double width = 1.35, height = 0.85, corner = 0.22;
    const double dx = std::max(std::abs(right) - (width / 2 - corner), 0.0),
                 dy = std::max(std::abs(up) - (height / 2 - corner), 0.0);
    const double edge = corner - std::hypot(dx, dy);
    if (edge < 0.0) return behind;
    const Colour enamel(0.86, 0.83, 0.74), blue(0.02, 0.07, 0.22);
    const double unit = 0.066;
    const bool letter = ink(text, right / unit + 5.5, up / unit + 3.5);
    return letter || (edge > 0.045 && edge < 0.085) ? blue : enamel;
}

Colour wallpaper(int number, const WallPlace& at) {
    static const Colour tones[6] = {{0.25, 0.36, 0.20}, {0.52, 0.17, 0.12}, {0, 0, 0},
                                    {0, 0, 0},          {0.66, 0.44, 0.16}, {0.13, 0.36, 0.44}};
    const double column = at.right / 0.625, row = at.up / 0.8;
    const double x = column - std::floor(column) - 0.5;
    const double shifted = row + 0.5 * (static_cast<int>(std::floor(column)) & 1),
                 y = shifted - std::floor(shifted) - 0.5;
    const double petal = std::abs(x) + 0.62 * std::abs(y) - 0.04 * std::cos(18.0 * y);
    const double motif = 0.35 * within(petal, 0.13, 0.19, 0.015) + 0.28 * (1.0 - smooth(0.04, 0.07, petal));
    return tones[number] * (1.0 + motif) + 0.02 * motif;
}

Colour panels(const WallPlace& at) {
    const Colour white(0.78, 0.76, 0.70);
    const double pitch = 1.25, x = at.right / pitch, across = (x - std::floor(x) - 0.5) * pitch, up = at.up + 3.65;
    return white * bevel(across, up, 0.50, 0.90, 0.06) * bevel(across, up, 0.36, 0.76, 0.05);
}

const char* axis_name(int number) {
    static const char* const names[6] = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
    return names[number];
}

}  // namespace

Material wall(const Spot& spot) {
    const int number = wall_number(spot);
    const glm::dvec3& p = spot.point;
    const double right = number == 0 ? p.z : number == 1 ? -p.z : number == 4 ? -p.x : p.x;
    const WallPlace at{right, p.y};
    const Colour white(0.80, 0.78, 0.72);
    Colour c = at.up > -2.3 ? wallpaper(number, at) : panels(at);
    if (at.up > -2.42 && at.up < -2.2) c = white * (at.up > -2.25 ? 1.1 : at.up < -2.37 ? 0.7 : 0.95);
    if (at.up < -4.72) c = white * (at.up > -4.76 ? 1.1 : 0.85);
    if (at.up > 4.72) c = white * (at.up < 4.76 ? 0.75 : at.up < 4.86 ? 1.0 : 0.9);
    return {sign_colour(c, axis_name(number), at.right, at.up - 4.1), Colour(0), 0};
}

Material floor_boards(const Spot& spot) {
    const double x = spot.point.x, z = spot.point.z, width = 0.5, length = 3.2;
    const int row = static_cast<int>(std::floor(z / width));
    const double along = x / length + random(row, 0, 0, 3), column = std::floor(along);
    const int board = static_cast<int>(column);
    const double grain = fbm({2.0 * x, 17.0 * z, 9.0 * random(row, board, 0, 5)}, 4, 21);
    const double tone = 0.72 + 0.42 * random(row, board, 0, 4) + 0.55 * (grain - 0.5);
    const double gap_z = std::abs(z / width - row - 0.5), gap_x = std::abs(along - column - 0.5);
    const double gap = gap_z > 0.475 || gap_x > 0.4955 ? 0.45 : 1.0;
    Colour c = Colour(0.40, 0.235, 0.115) * tone * gap;
    return {sign_colour(c, "-Y", x, -(z - 3.36)), Colour(0), 0.02};
}

Material ceiling(const Spot& spot) {
    const double x = spot.point.x, z = spot.point.z;
    const double pitch = 5.0 / 3.0, cell = x / pitch + 0.5, across = (cell - std::floor(cell) - 0.5) * pitch;
    const double row = z / pitch + 0.5, along = (row - std::floor(row) - 0.5) * pitch;
    const Colour c = Colour(0.82, 0.80, 0.75) * bevel(across, along, 0.70, 0.70, 0.07);
    return {sign_colour(c, "+Y", x, z + 1.68), Colour(0), 0};
}

// Bands around a field with a star in the middle.
Material carpet(const Spot& spot) {
    const double half_x = 3.1, half_z = 2.4, x = spot.point.x, z = spot.point.z - 0.4;
    const double edge = std::min(half_x - std::abs(x), half_z - std::abs(z));
    const Colour red(0.36, 0.045, 0.04), navy(0.035, 0.06, 0.16), cream(0.66, 0.56, 0.38), gold(0.55, 0.33, 0.08);
    const auto diamonds = [&](double pitch) {
        const double u = (x + z) / pitch, v = (x - z) / pitch;
        return (static_cast<int>(std::floor(u)) + static_cast<int>(std::floor(v))) & 1;
    };
    Colour c = red;
    const double radius = std::hypot(x, z), angle = std::atan2(z, x),
                 star = radius * (1.0 + 0.16 * std::cos(8.0 * angle));
    if (edge < 0.10)
        c = cream;
    else if (edge < 0.22)
        c = navy;
    else if (edge < 0.62)
        c = diamonds(0.4) ? gold : navy;
    else if (edge < 0.72)
        c = cream;
    else if (star < 0.28)
        c = gold;
    else if (star < 0.62)
        c = navy;
    else if (star < 0.74)
        c = cream;
    else if (star < 1.15)
        c = diamonds(0.3) ? red * 0.6 : gold;
    else if (star < 1.25)
        c = navy;
    else if (std::hypot(std::abs(x) - 2.0, std::abs(z) - 1.3) < 0.26)
        c = gold;
    else if (diamonds(0.55))
        c = red * 1.25;
    const double pile =
        0.82 + 0.36 * random(static_cast<int>(std::floor(x * 40)), static_cast<int>(std::floor(z * 40)), 0, 8);
    return {c * pile, Colour(0), 0};
}

Material view_of_the_lake(const Spot& spot) {
    // Turned a little, so that the lake shows; brighter than the room, as days are.
    const glm::dvec3 d = glm::normalize(spot.point - glm::dvec3(0, -0.6, 1.0));
    const double c = std::cos(0.75), s = std::sin(0.75);
    return {Colour(0.1), 0.95 * sky_radiance({c * d.x - s * d.z, d.y, s * d.x + c * d.z}), 0};
}

Material books(const Spot& spot) {
    const double z = spot.point.z, y = spot.point.y, width = 0.19;
    const int shelf = static_cast<int>(std::floor((y + 5.0) / 1.2)), slot = static_cast<int>(std::floor(z / width));
    const double base = -5.0 + 1.2 * shelf,
                 height = 0.62 + 0.34 * random(slot / 3, shelf, 0, 41) + 0.08 * random(slot, shelf, 0, 42);
    const double across = z / width - slot, up = (y - base) / height;
    if (up > 1.0 || random(slot, shelf, 0, 43) < 0.09) return {Colour(0.05, 0.03, 0.02), Colour(0), 0};
    static const Colour covers[] = {{0.35, 0.06, 0.05}, {0.06, 0.12, 0.28}, {0.08, 0.22, 0.12}, {0.55, 0.42, 0.2},
                                    {0.20, 0.10, 0.05}, {0.55, 0.50, 0.42}, {0.10, 0.25, 0.30}, {0.45, 0.22, 0.05}};
    Colour c = covers[static_cast<std::size_t>(random(slot, shelf, 0, 44) * 8)];
    c *= 0.55 + 0.75 * std::sin(3.14159 * std::clamp(across, 0.0, 1.0));  // round backs
    if (within(up, 0.72, 0.78, 0.01) + within(up, 0.18, 0.22, 0.01) > 0.5) c = Colour(0.6, 0.45, 0.16);
    return {c, Colour(0), 0};
}

Material curtain(const Spot& spot) {
    const double fold = std::sin(9.0 * spot.point.x + 1.2 * std::sin(0.8 * spot.point.y));
    return {Colour(0.62, 0.50, 0.34) * (0.72 + 0.30 * fold), Colour(0), 0};
}

Material stone(const Spot& spot) {
    const double vein = std::abs(2.0 * fbm(1.6 * spot.point, 5, 71) - 1.0);
    return {Colour(0.62, 0.59, 0.55) * (0.72 + 0.5 * smooth(0.0, 0.22, vein)), Colour(0), 0.01};
}

Material fire(const Spot& spot) {
    const double y = spot.point.y + 5.0, z = spot.point.z;
    const double flame = fbm({0, 1.1 * y, 2.6 * z}, 4, 81) * 1.9 - 0.42 * y - 0.55 * z * z;
    const Colour glow =
        Colour(3.2, 0.85, 0.12) * smooth(0.15, 0.75, flame) + Colour(2.5, 2.0, 0.7) * smooth(0.6, 1.05, flame);
    return {Colour(0.03, 0.025, 0.02), glow, 0};
}

Material door(const Spot& spot) {
    const double x = spot.point.x - 2.85, y = spot.point.y;
    const double lower = bevel(std::abs(x) - 0.5, y + 3.55, 0.34, 0.95, 0.07),
                 upper = bevel(std::abs(x) - 0.5, y + 1.05, 0.34, 1.25, 0.07);
    const double grain = fbm({10.0 * x, 1.0 * y, 0.0}, 4, 91);
    return {Colour(0.20, 0.36, 0.38) * lower * upper * (0.85 + 0.3 * grain), Colour(0), 0.01};
}

Material clock_face(const Spot& spot) {
    const double right = -(spot.point.x - 0.75), up = spot.point.y - 1.9, r = std::hypot(right, up),
                 angle = std::atan2(right, up);
    const Colour dark(0.03), light(0.85, 0.83, 0.76);
    const double hour = angle * 12.0 / (2.0 * 3.14159265358979), off = std::abs(hour - std::round(hour));
    const auto hand = [&](double clock_angle, double length, double width) {
        const double along = right * std::sin(clock_angle) + up * std::cos(clock_angle);
        const double aside = right * std::cos(clock_angle) - up * std::sin(clock_angle);
        return along > -0.05 && along < length && std::abs(aside) < width;
    };
    const bool mark = r > 0.36 && r < 0.46 && off * r < 0.035;
    const bool shown = mark || hand(-1.05, 0.26, 0.03) || hand(1.0, 0.38, 0.022) || r > 0.52;
    return {shown ? dark : light, Colour(0), 0};
}

Paint wood(const Colour& tone) {
    return [tone](const Spot& spot) {
        const double grain = fbm(spot.point * glm::dvec3(2.0, 11.0, 2.0), 4, 51);
        return Material{tone * (0.7 + 0.6 * grain), Colour(0), 0.015};
    };
}

Paint cloth(const Colour& tone) {
    return [tone](const Spot& spot) {
        const glm::dvec3 thread = glm::floor(spot.point * 26.0);
        const double weave =
            random(static_cast<int>(thread.x), static_cast<int>(thread.y), static_cast<int>(thread.z), 55);
        return Material{tone * (0.86 + 0.28 * weave), Colour(0), 0};
    };
}

Paint leaves() {
    return [](const Spot& spot) {
        const double leaf = fbm(6.0 * spot.point, 3, 57);
        return Material{glm::mix(Colour(0.02, 0.07, 0.02), Colour(0.16, 0.34, 0.08), smooth(0.3, 0.7, leaf)), Colour(0),
                        0};
    };
}

}  // namespace snell::environments
