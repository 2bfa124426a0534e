// Compares the picture of the chosen rungs with the reference, which has the last rung of every ladder, or that of a
// found rung with the scene as it is. While nothing else happens, both are refined sample by sample; each step draws
// one picture.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/app/window/measure/rung_costs.h"
#include "src/document/document.h"

namespace snell {

// Everything that pictures depend on, except for the rungs.
struct Stand {
    int width = 0, height = 0;
    double time = 0;
    View view;
    std::vector<double> values;
    bool operator==(const Stand&) const = default;
};

class Refinement {
public:
    // The GL context of `caps` must be current during the object's whole life.
    Refinement(std::string path, const gl::Caps& caps);

    // Tells what the window shows; call it before step(). Anything that changes the picture restarts the refinement.
    // The reference is a separate document, which shares with the shown one everything that both need. `stale` says
    // that the files have changed since. With `scene` that is the reference instead.
    void follow(Document& shown, bool stale, const Stand& stand, Document* scene = nullptr);
    // Call it before a document of follow() is destroyed; follow() comes before step() then.
    void leave() { shown_ = scene_ = nullptr; }
    // True if there is a reference, as far as the files are concerned.
    bool comparable() const { return note_.empty(); }
    // True if another step would improve the result.
    bool busy() const;
    // Returns true if there is something new to show.
    bool step();
    // Starts measuring all rungs of the ladder, with the other ladders unchanged, or stops it.
    void measure(std::size_t ladder);

    // `ladder` is the one whose rungs are plotted.
    ui::AccuracyFacts facts(std::size_t ladder) const;
    // The reference in its current refinement; null if there is none yet.
    const accuracy::Picture* reference() const;
    // For each pixel the root mean square of the differences of display values in red, green and blue; empty if there
    // is no reference yet.
    std::vector<float> differences() const;
    // Increases whenever a result of the functions above changes.
    std::uint64_t revision() const { return revision_; }

private:
    // Errors are computed at these numbers of samples.
    static constexpr std::array<int, 3> levels{1, 4, 16};
    // The index into `levels`; levels.size() if the number is not one of them.
    static std::size_t level(int samples);

    struct Means {
        accuracy::SampleMean chosen, reference;
        Means(int width, int height, bool es) : chosen(width, height, es), reference(width, height, es) {}
    };

    void open_reference();
    Document& reference_document() { return scene_ ? *scene_ : *reference_; }
    bool reference_step();
    bool chosen_step();
    bool cost_step();
    View without_axes() const;

    std::string path_;
    gl::Caps caps_;
    Document *shown_ = nullptr, *scene_ = nullptr;
    bool stale_ = false;
    std::unique_ptr<Document> reference_;
    std::string note_;  // why there is no reference
    Stand stand_;
    Controls controls_;  // of the shown document
    std::unique_ptr<Means> means_;
    std::array<accuracy::Picture, levels.size()> references_;
    accuracy::Picture chosen_;
    accuracy::Error error_;
    int samples_ = 0;            // of `chosen_` and `error_`
    int reference_samples_ = 0;  // of the best of `references_`
    accuracy::FrameClock clock_;
    std::vector<double> times_;  // of the last samples of the chosen rungs
    bool cold_ = true;           // the next sample compiles or loads, so it is not timed
    std::uint64_t revision_ = 0;
    RungCosts costs_;
};

}  // namespace snell
