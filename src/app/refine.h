// While nothing moves: the picture of the chosen rungs and that of the last rung of every ladder, both refined sample
// by sample, and how far they are from each other. In steps that are one picture each.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "src/accuracy/metrics.h"
#include "src/app/document.h"
#include "src/app/rung_costs.h"

namespace snell {

// All that pictures depend on, but the rungs.
struct Stand {
    int width = 0, height = 0;
    double time = 0;
    View view;
    std::vector<double> values;
    bool operator==(const Stand&) const = default;
};

class Refinement {
public:
    // Needs the GL context of `caps` to be current, for all of its life.
    Refinement(std::string path, const gl::Caps& caps);

    // What the window shows; to be called before step(). Whatever makes another picture starts anew. The reference is
    // a document of its own, that shares with the shown one what both need. `stale`: the files are others.
    void follow(Document& shown, bool stale, const Stand& stand);
    // There is a reference, as far as the files go.
    bool comparable() const { return note_.empty(); }
    // Another step would tell more.
    bool busy() const;
    // True: there is something new to show.
    bool step();
    // Measures all rungs of the ladder, the others as they are; or stops.
    void measure(std::size_t ladder);

    // `ladder`: whose rungs are plotted.
    ui::AccuracyFacts facts(std::size_t ladder) const;
    // As far as it is refined; null: not yet.
    const accuracy::Picture* reference() const;
    // By pixel, root mean square of red, green and blue; empty: not yet.
    std::vector<float> differences() const;
    // Counts changes of what the above give.
    std::uint64_t revision() const { return revision_; }

private:
    // Errors are taken at these numbers of samples.
    static constexpr std::array<int, 3> levels{1, 4, 16};
    // levels.size(): none of them.
    static std::size_t level(int samples);

    struct Means {
        accuracy::SampleMean chosen, reference;
        Means(int width, int height, bool es) : chosen(width, height, es), reference(width, height, es) {}
    };

    void open_reference();
    bool reference_step();
    bool chosen_step();
    bool cost_step();
    View without_axes() const;

    std::string path_;
    gl::Caps caps_;
    Document* shown_ = nullptr;
    bool stale_ = false;
    std::unique_ptr<Document> reference_;
    std::string note_;  // why there is no reference
    Stand stand_;
    Controls controls_;  // of the shown document
    std::unique_ptr<Means> means_;
    std::array<accuracy::Picture, levels.size()> references_;
    accuracy::Picture chosen_;
    accuracy::Error error_;
    int samples_ = 0;            // of `chosen_`, and `error_` is of as many
    int reference_samples_ = 0;  // of the best of `references_`
    std::vector<double> times_;  // of the last samples of the chosen rungs
    bool cold_ = true;           // the next one compiles or loads
    std::uint64_t revision_ = 0;
    RungCosts costs_;
};

}  // namespace snell
