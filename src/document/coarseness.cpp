#include "src/document/coarseness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace snell {

namespace {

// An upper bound of what the next finer grain multiplies the time by.
constexpr double finer_costs = 4;

double sharp(int grain, double ms) {
    const int divide = grains[static_cast<std::size_t>(grain)].divide;
    return ms * divide * divide;
}

}  // namespace

int Coarseness::next(bool moved, bool held, double now) {
    if (moved && (held || now - moved_ < again)) until_ = now + rest;
    if (moved) moved_ = now;
    const Cost& cost = costs_[static_cast<std::size_t>(grain_)];
    const auto limit = [](int grain) { return grain < quarter ? slow : blind; };
    if (now >= until_)
        grain_ = 0;
    else if (in_vain(2))
        grain_ = 0;
    else if (moved && cost.frames > 1 && cost.ms > limit(grain_))
        grain_ = grain_ > 0 ? std::min(grain_ + 1, coarsest) : in_vain(1) ? coarsest : dragged_;
    else if (moved && cost.frames > 1 && grain_ > 0 && cost.ms * finer_costs < limit(grain_ - 1))
        --grain_;
    if (grain_ > 0) dragged_ = grain_;
    return grain_;
}

bool Coarseness::in_vain(int frames) const {
    const double sharp = costs_[0].ms;
    return sharp > patience && std::any_of(costs_.begin() + quarter, costs_.end(), [&](const Cost& cost) {
               return cost.frames >= frames && cost.ms > vain * sharp;
           });
}

void Coarseness::drew(double ms) {
    Cost& cost = costs_[static_cast<std::size_t>(grain_)];
    ++cost.frames;
    cost.ms = ms;
    if (grain_ >= quarter) foreseen_ = sharp(grain_, ms);
}

// A picture whose time does not grow with its pixels tells nothing of finer ones, nor does the very first one, in which
// the driver compiles.
bool Coarseness::foresee(const std::function<double(int)>& timed, double now, double most) {
    constexpr double growing = 1.6;
    const auto ends = [](double ms, int finer) { return ms * std::pow(finer_costs, finer) > patience; };
    const auto draw = [&](int grain) {
        const double ms = timed(grain);
        now += ms / 1e3;
        return ms;
    };
    int grain = coarsest;
    double ms = draw(grain);
    if (ends(ms, coarsest - quarter) && costs_[0].frames == 0) ms = std::min(ms, draw(grain));
    if (!ends(ms, coarsest - quarter)) ms = draw(grain = quarter);
    while (grain > quarter && ms < patience) {
        const double before = std::exchange(ms, draw(--grain));
        if (ms > growing * before && ends(ms, 1)) break;
    }
    costs_[static_cast<std::size_t>(grain)].ms = ms;
    ++costs_[static_cast<std::size_t>(grain)].frames;
    foreseen_ = sharp(grain, ms);
    if (!lasts(most)) return false;
    grain_ = dragged_ = grain;
    until_ = now + rest;
    return true;
}

double Coarseness::due() const { return grain_ > 0 ? until_ : std::numeric_limits<double>::infinity(); }

// Where nothing is drawn, as in a background, strips take no time, and above it each may take many times longer than
// the mean: so they are hardly higher than the mean allows.
Strips::Strips(int width, int height, double milliseconds) : width_(width), height_(height) {
    constexpr double largest = 1. / 16;  // of the picture
    const double all = static_cast<double>(width) * height;
    pixels_ = milliseconds > 0 ? all * std::min(aim / milliseconds, largest) : all;
    most_ = milliseconds > 0 ? std::min(2 * pixels_, all * largest) : all;
}

PixelRect Strips::next() const {
    constexpr int narrowest = 8;
    if (left_ == 0 && pixels_ >= static_cast<double>(width_) * height_) return {0, bottom_, width_, height_ - bottom_};
    const int rows = static_cast<int>(pixels_ / width_) / block * block;
    if (left_ == 0 && rows > 0) return {0, bottom_, width_, std::min(rows, height_ - bottom_)};
    const int columns = std::max(static_cast<int>(pixels_ / block / block) * block, narrowest);
    return {left_, bottom_, std::min(columns, width_ - left_), std::min(block, height_ - bottom_)};
}

bool Strips::draw(const std::function<double(const PixelRect&)>& timed) {
    constexpr double quicker = 2, slower = .25;
    for (double spent = 0; spent < aim / 2 && bottom_ < height_;) {
        const PixelRect strip = next();
        const double milliseconds = timed(strip);
        spent += milliseconds;
        left_ += strip.width;
        if (left_ >= width_) {
            left_ = 0;
            bottom_ += strip.height;
        }
        const double pixels = static_cast<double>(strip.width) * strip.height;
        find_fixed(pixels, milliseconds);
        // Smaller strips would only be more of what does not grow with them, which so is a third of each at most.
        const double fit = pixels * (std::max(aim, 3 * fixed_) - fixed_) / std::max(milliseconds - fixed_, 1e-3);
        const double all = static_cast<double>(width_) * height_;
        pixels_ = fixed_ > aim ? std::min(std::clamp(fit, pixels, 4 * pixels), all)
                               : std::min(std::clamp(fit, pixels_ * slower, pixels_ * quicker), most_);
    }
    return bottom_ >= height_;
}

// By the last two strips, if one is larger by far: all vertices, and on a busy machine the wait for a processor.
void Strips::find_fixed(double pixels, double milliseconds) {
    const auto [before, took] = std::exchange(last_, {pixels, milliseconds});
    if (std::abs(before - pixels) < .1 * std::max(before, pixels) || before == 0) return;
    const double fixed = (milliseconds * before - took * pixels) / (before - pixels);
    fixed_ = std::clamp(fixed, 0., std::min(milliseconds, took));
}

double Strips::share() const { return (bottom_ + static_cast<double>(block) * left_ / width_) / height_; }

namespace {

constexpr double tells = 300, ends = 2000;  // milliseconds of a trial: it is believed; it is the last

// What vertices and textures of a fixed size take does not grow with the picture: 0, or more than enough.
double foresee_rounds(double rounds, double enough, Foresight& known,
                      const std::function<double(const Trial&)>& timed) {
    for (double some = known.rounds; some < rounds; known.rounds = some *= 2) {
        double milliseconds = timed({1, 1, some});
        if (milliseconds > tells && milliseconds < ends) milliseconds = std::min(milliseconds, timed({1, 1, some}));
        const double whole = milliseconds * rounds / some;
        if (milliseconds > tells && whole > enough) return whole;
    }
    return 0;
}

double foresee_pixels(int width, int height, double rounds, double enough, double& point,
                      const std::function<double(const Trial&)>& timed) {
    constexpr int largest = 64, least = 4;                       // divisors of width and height
    constexpr double compiled = .7, growing = 1.6, unsure = .3;  // times the milliseconds of a single pixel
    constexpr int tell_apart = 64;  // pixels that take longer than one, if the work is theirs
    const auto side = [](int pixels, int divisor) { return std::max(pixels / divisor, 1); };
    const auto others = [&](int divisor) {  // pictures of this size
        return static_cast<double>(width) * height / side(width, divisor) / side(height, divisor) - 1;
    };
    const auto at = [&](int divisor) { return timed({side(width, divisor), side(height, divisor), rounds}); };
    double whole = 0;
    const auto quick = [&](int divisor) { return whole + unsure * point * others(divisor) <= enough; };
    if (std::isfinite(point)) {
        const double milliseconds = at(largest);
        whole = milliseconds + std::max(milliseconds - point, 0.) * others(largest);
        if (quick(largest)) return whole;
    }
    // What does not grow with the size, as the work for vertices does, is all that a single pixel takes.
    whole = point = timed({1, 1, rounds});
    if (point > enough) return point;
    for (int divisor = largest; divisor >= least; divisor /= 2) {
        if (side(width, divisor) * side(height, divisor) < tell_apart && divisor > least) continue;
        double milliseconds = at(divisor);
        const auto grows = [&] { return milliseconds > growing * point; };
        // That of a single pixel had waited for the compiler or something else.
        if (milliseconds < compiled * point || (milliseconds > ends && !grows()))
            point = std::min(point, timed({1, 1, rounds}));
        const auto of_all = [&] {
            const bool told = grows() || milliseconds < ends || divisor == least;
            return milliseconds + (told ? std::max(milliseconds - point, 0.) * others(divisor) : 0);
        };
        whole = of_all();
        if (quick(divisor) || milliseconds > ends) break;
        if ((grows() && milliseconds > tells) || divisor == least) {  // something else may have kept the machine busy
            milliseconds = std::min(milliseconds, at(divisor));
            whole = of_all();
            if (grows() && milliseconds > tells) break;
        }
    }
    return whole;
}

}  // namespace

double foresee(int width, int height, double rounds, double enough, Foresight& known,
               const std::function<double(const Trial&)>& timed) {
    const double lasts = foresee_rounds(rounds, enough, known, timed);
    return lasts > 0 ? lasts : foresee_pixels(width, height, rounds, enough, known.point, timed);
}

}  // namespace snell
