// Times the window's pictures while the frame cost panel is open and, on request, the passes and draws of one picture.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "src/accuracy/timing.h"
#include "src/app/window/measure/accuracy_view.h"
#include "src/document/document.h"
#include "src/gl/context.h"
#include "src/gl/target.h"
#include "src/ui/panels/state.h"

namespace snell {

class FrameCosts {
public:
    explicit FrameCosts(const gl::Caps& caps);
    ~FrameCosts();
    FrameCosts(FrameCosts&&) noexcept;
    FrameCosts& operator=(FrameCosts&&) noexcept;

    // Starts or stops timing. Stopping discards all results; no work is done until it starts again. The first time is
    // that of the picture that is shown, which took `milliseconds` and is of the document with this revision. Returns
    // true if timing started.
    bool open(bool wanted, std::uint64_t revision, double milliseconds);
    // The first picture of a scene waits for the driver's compiler, so that one more is drawn even if nothing changes.
    bool wants_picture() const { return open_ && frames_.size() == 1; }
    // Call it before drawing a picture, or a strip of it, of the document with this revision. Returns the function for
    // Frame::after, if passes can be timed: those of a picture that is drawn at once.
    const std::function<void(const Step&)>* begin(std::uint64_t revision, bool at_once);
    // Call it after the picture was drawn and the GPU has finished. `milliseconds` is its time, which counts if it is
    // sharp.
    void end(double milliseconds, bool sharp);

    // Starts or stops measuring passes and draws, in additional frames.
    void measure();
    bool busy() const { return apart_ != nullptr; }
    // Draws one of the additional frames. Returns true if there is something new to show.
    bool step(Document& document, const Stand& stand, int samples);
    // Adds the results of measure(): times of passes, and of programs as the sum of their draws.
    void fill(Explanation& explanation) const;

    // `stand` is that of the picture in the window. Null while the panel is closed. Valid until the next call.
    const ui::FrameCostFacts* facts(const Document* document, const Stand& stand);

private:
    static constexpr std::size_t most_frames = 240;  // number of frames in the plot
    static constexpr int most_rounds = 10;           // of additional frames

    using Key = std::pair<Index, Index>;  // pass and draw; `none` as the draw: the whole pass
    using Times = std::map<Key, std::vector<double>>;
    struct Apart;

    bool by_gpu();
    void read_marks(double picture, bool sharp);
    std::vector<ui::CostRow> rows_of(const Times& times, const Document& document) const;

    gl::Caps caps_;
    accuracy::FrameClock clock_;
    bool open_ = false, running_ = false, marking_ = false;
    std::vector<float> frames_, sorted_;  // in milliseconds; frames_ is in order of time
    gl::Marks marks_;
    std::vector<Index> marked_;  // the passes in the order of the marks; `none` for the time before them
    std::function<void(const Step&)> listener_;
    Times live_;   // of the last pictures, by the GPU's clock
    int odd_ = 0;  // number of pictures for which the GPU's clock measured more time than passed
    bool distrusted_ = false;
    std::uint64_t revision_ = 0;
    std::unique_ptr<Apart> apart_;
    Times known_;                       // results of measure()
    std::pair<Stand, Rungs> known_of_;  // what they are of
    double plain_ = 0;                  // likewise, of whole frames
    std::vector<ui::CostRow> live_rows_, apart_rows_;
    ui::FrameCostFacts facts_;
};

}  // namespace snell
