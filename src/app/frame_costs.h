// What the window's pictures cost while its panel is open, and on request what each pass and draw of one does.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "src/app/document.h"
#include "src/app/refine.h"
#include "src/gl/marks.h"
#include "src/ui/frame_cost.h"

namespace snell {

class FrameCosts {
public:
    explicit FrameCosts(const gl::Caps& caps);
    ~FrameCosts();
    FrameCosts(FrameCosts&&) noexcept;
    FrameCosts& operator=(FrameCosts&&) noexcept;

    // Whether pictures are to be timed. Closed, all is forgotten and nothing is done.
    void open(bool wanted);
    // About to draw a picture of the document that has this revision; gives what Frame::after is to be.
    const std::function<void(const Step&)>* begin(std::uint64_t revision);
    // It is drawn, and the GPU is done with it.
    void end();

    // Measures passes and draws in frames of their own; or stops.
    void measure();
    bool busy() const { return apart_ != nullptr; }
    // One of these frames. True: there is something new to show.
    bool step(Document& document, const Stand& stand, int samples);
    // What was measured so: passes, and programs as the sum of their draws.
    void fill(Explanation& explanation) const;

    // Null while closed. Stands until the next call.
    const ui::FrameCostFacts* facts(const Document* document);

private:
    static constexpr std::size_t most_frames = 240;  // that are plotted
    static constexpr int rounds = 11;                // of frames of their own; the first warms up

    using Key = std::pair<Index, Index>;  // pass, draw; none: all of the pass
    using Times = std::map<Key, std::vector<double>>;
    struct Apart;

    bool by_gpu();
    std::string_view clock();
    void read_marks(double wall);
    std::vector<ui::CostRow> rows_of(const Times& times, const Document& document) const;

    gl::Caps caps_;
    bool open_ = false, running_ = false;
    double cpu_ = 0, wall_ = 0;           // when the picture was begun
    std::vector<float> frames_, sorted_;  // milliseconds; as they came
    gl::Marks marks_;
    std::vector<Index> marked_;  // passes, in the order of marks; none: what came before them
    std::function<void(const Step&)> listener_;
    Times live_;   // of the last pictures, by the GPU's clock
    int odd_ = 0;  // pictures for which the GPU's clock told of more time than there was
    bool distrusted_ = false;
    std::uint64_t revision_ = 0;
    std::unique_ptr<Apart> apart_;
    Times known_;                          // as measured apart
    std::map<Key, std::size_t> together_;  // how many draws one call did
    std::vector<ui::CostRow> live_rows_, apart_rows_;
    ui::FrameCostFacts facts_;
};

}  // namespace snell
