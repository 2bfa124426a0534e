// How coarse the picture is drawn while something is dragged, so that the drag stays smooth, and what a whole one would
// take: in the window and in pages. In the window, also before a sharp one for which nobody would wait.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "src/runtime/runtime.h"

namespace snell {

// Samples per pixel, and the divisor of the picture's width and height.
struct Grain {
    int samples, divide;
    std::string_view text;  // for the status line

    int part_of(int pixels) const { return (pixels + divide - 1) / divide; }
};
inline constexpr std::array<Grain, 6> grains{{{4, 1, ""},
                                              {1, 1, "1 sample"},
                                              {1, 2, "1 sample, half size"},
                                              {1, 4, "1 sample, quarter size"},
                                              {1, 8, "1 sample, eighth of the size"},
                                              {1, 16, "1 sample, sixteenth of the size"}}};
inline constexpr int quarter = 3, coarsest = static_cast<int>(grains.size()) - 1;

class Coarseness {
public:
    static constexpr double slow = 33;       // milliseconds of a frame, above which the next one is coarser
    static constexpr double blind = 200;     // the same where too little would be seen in a coarser one
    static constexpr double rest = .15;      // seconds without a change, after which the picture is sharp
    static constexpr double patience = 500;  // milliseconds that a sharp picture may take without a coarse one before
    static constexpr double vain = .7;       // of the time of a sharp one: what takes longer is not drawn instead
    static constexpr double again = .3;  // seconds between changes that are one gesture without a button: wheel, keys

    // Returns the index into `grains` of the next frame. `moved`: the user's input changes the picture; `held`: a mouse
    // button is down; `now` is in seconds.
    int next(bool moved, bool held, double now);
    // Tells the time of the frame that was drawn, in milliseconds. The first one of a scene or of a grain may compile,
    // so it is not judged.
    void drew(double ms);
    // Where nobody knows how long the next picture takes: draws coarse ones, each finer than the one before, as long as
    // the next one takes no longer than `patience`. `timed` draws one of that index into `grains`, and returns its
    // milliseconds. Returns true if the last one is the next picture, because a sharp one may take longer than
    // `patience`, but less than `most`.
    bool foresee(const std::function<double(int)>& timed, double now,
                 double most = std::numeric_limits<double>::infinity());
    // Milliseconds of a sharp picture at the most, as the last coarse one tells; 0: none tells.
    double foreseen() const { return foreseen_; }
    bool lasts(double most = std::numeric_limits<double>::infinity()) const {
        return foreseen() > patience && foreseen() < most;
    }
    // Nothing is dragged any more, as far as the mouse tells: the next picture is sharp.
    void released() { until_ = -1e9; }
    // When a sharp picture is due if nothing moves; infinite if the picture is sharp.
    double due() const;

private:
    int grain_ = 0, dragged_ = 1;  // of the next frame; of the last drag
    struct Cost {
        int frames = 0;
        double ms = 0;  // of the last frame
    };
    // The last one of so many small pictures took about as long as a sharp one, as where all the work is that for
    // vertices. Only where that is long: elsewhere anything else may have taken as long.
    bool in_vain(int frames) const;
    std::array<Cost, grains.size()> costs_{};
    double foreseen_ = 0;
    double moved_ = -1e9, until_ = -1e9;  // when the picture changed last; when it becomes sharp
};

// A picture that is drawn strip by strip, from the bottom, so that something else is done between two of them. Where
// two rows take too long already, strips are parts of these.
class Strips {
public:
    static constexpr double aim = 120;  // milliseconds of a strip

    // Of a picture that takes about so many milliseconds at the most; 0: it is one strip.
    Strips(int width, int height, double milliseconds);
    // Draws as many as take no longer than one may. `timed` draws one, and returns its milliseconds. Returns true if
    // the picture is whole.
    bool draw(const std::function<double(const PixelRect&)>& timed);
    // How much is drawn.
    double share() const;

private:
    // It begins and ends at edges of blocks; but the last one has what is left.
    PixelRect next() const;

    void find_fixed(double pixels, double milliseconds);

    static constexpr int block = 4;  // pixels along a side: Mesa's llvmpipe shades all of one that is seen in part

    int width_, height_;
    double most_, pixels_;            // of a strip; of the next one
    double fixed_ = 0;                // milliseconds that a strip takes, however small it is
    std::pair<double, double> last_;  // pixels and milliseconds of the last strip
    int left_ = 0, bottom_ = 0;
};

// A picture that is drawn to be timed: its size, and how many times longer than short its loops are at most.
struct Trial {
    int width, height;
    double rounds;
};

// What earlier trials of a scene found.
struct Foresight {
    double point = std::numeric_limits<double>::infinity();  // milliseconds of a single pixel
    double rounds = 1;                                       // times longer than short, of loops that do not last
};

// About how many milliseconds a picture of width x height pixels takes, whose loops are `rounds` times longer than
// short. First come pictures of a single pixel, each of which has loops of twice as many rounds as the one before; then
// small ones, each of which has four times as many pixels, until a whole one is seen to take no more than `enough`, or
// a trial takes long itself. `timed` returns its milliseconds, which are more where something else kept the machine
// busy, or a compiler. Where earlier ones tell, a single one is enough if the picture is quick still.
double foresee(int width, int height, double rounds, double enough, Foresight& known,
               const std::function<double(const Trial&)>& timed);

}  // namespace snell
