// Errors and costs of rungs within the window, for its panel: those of the chosen rungs against the reference, and on
// request those of all rungs of a ladder.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "src/accuracy/bench.h"
#include "src/accuracy/metrics.h"
#include "src/document/document.h"
#include "src/gl/present.h"
#include "src/ui/panels/accuracy.h"

namespace snell {

// Of choices of rungs, while nothing else changes: of those that the user visited and, on request, of all rungs of a
// ladder.
class RungCosts {
public:
    RungCosts();
    ~RungCosts();

    // Discards all results; call it when something other than the rungs changes.
    void forget();
    // Records that these rungs were drawn, with one time for each drawing.
    void visit(const Rungs& rungs, double error, std::span<const double> times);

    // Starts measuring all rungs of the ladder, with the other ladders as chosen: first errors, then times in
    // interleaved rounds.
    void begin(std::size_t ladder, const Scene& scene, const Rungs& chosen);
    void stop();
    bool measuring() const { return job_ != nullptr; }
    // True if all rungs of a ladder were compared, or are about to be.
    bool compared() const { return measuring() || compared_; }
    double done() const;  // 0..1
    // Draws one sample of one rung with a runtime that nothing else uses. `reference` must have as many samples as
    // `samples`; the rungs in `frame` are ignored. Returns true if there are new results.
    bool step(Runtime& runtime, const Frame& frame, const accuracy::Picture& reference, int samples,
              const accuracy::FrameClock& clock, bool es);

    // The results as points of a plot of that ladder.
    std::vector<ui::AccuracyPoint> points(const Scene& scene, std::size_t ladder, const Rungs& chosen) const;
    // A note on the last measurement.
    const std::string& remark() const { return remark_; }

private:
    struct Known {
        double error = 0;
        std::vector<double> times;  // if it was compared, from the same rounds as the others'
        ui::AccuracyPoint::Standing standing = ui::AccuracyPoint::Standing::visited;
        std::string by;
    };
    struct Job;
    bool error_step(const accuracy::Picture& reference, int samples, const accuracy::FrameClock& clock);
    void leave_out(std::size_t rung);
    void begin_rounds(const accuracy::FrameClock& clock);
    void conclude(accuracy::ClockKind clock);

    std::map<Rungs, Known> known_;
    std::unique_ptr<Job> job_;
    bool compared_ = false;
    std::string remark_;
};

// Everything that pictures depend on, except for the rungs.
struct Stand {
    int width = 0, height = 0;
    double time = 0;
    View view;
    std::vector<double> values;
    int enlarged = 1;  // that of Frame
    bool operator==(const Stand&) const = default;
};

// The same with so many times fewer pixels along a side.
Stand smaller(Stand stand, int divide);
// Without what measured numbers hardly depend on: while it is the same, they are not of an older picture.
Stand circumstances(Stand stand);
// What is said of results of such a picture; empty of one that is not smaller.
std::string reduced_text(const Stand& stand);

// Compares the picture of the chosen rungs with the reference, which has the last rung of every ladder, or that of a
// found rung with the scene as it is. While nothing else happens, both are refined sample by sample; each step draws
// one picture.
class Refinement {
public:
    // The GL context of `caps` must be current during the object's whole life.
    Refinement(std::string path, const gl::Caps& caps);

    // Tells what the window shows; call it before step(). Anything that changes the picture restarts the refinement.
    // The reference is a separate document, which shares with the shown one everything that both need. `stale` says
    // that the files have changed since; `failed` names rungs that the picture should have and has not, because of
    // errors. With `scene` that is the reference instead.
    void follow(Document& shown, bool stale, const std::string& failed, const Stand& stand, Document* scene = nullptr);
    // Call it before a document of follow() is destroyed; follow() comes before step() then.
    void leave() { shown_ = scene_ = nullptr; }
    // True if there is a reference, as far as the files are concerned.
    bool comparable() const { return note().empty(); }
    // True if another step would improve the result.
    bool busy() const;
    // Returns true if there is something new to show.
    bool step();
    // Starts measuring all rungs of the ladder, with the other ladders unchanged, or stops it.
    void measure(std::size_t ladder);

    // `ladder` is the one whose rungs are plotted.
    ui::AccuracyFacts facts(std::size_t ladder) const;
    // Milliseconds that the slower one of the compared pictures would take in the window's size, by its last sample.
    double lasts() const { return lasts_; }
    // The results are of this picture of the window, and took so long that they must not be lost to pictures of another
    // size than theirs, see enlarged().
    bool keeps_size(const Stand& window) const {
        return costs_.compared() && smaller(window, stand_.enlarged) == stand_;
    }
    // How many times larger than the pictures that are compared the window shows them.
    int enlarged() const { return stand_.enlarged; }
    // The reference in its current refinement; null if there is none yet.
    const accuracy::Picture* reference() const;
    // For each pixel the root mean square of the differences of light in red, green and blue; empty if there is no
    // reference yet.
    std::vector<float> differences() const;
    // The same of one pixel of the window's picture, from the upper left.
    std::optional<double> difference(int x, int y) const;
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

    std::string note() const;  // why nothing is compared
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
    std::string note_;    // why there is no reference
    std::string failed_;  // see follow()
    Stand stand_;
    Controls controls_;  // of the shown document
    std::unique_ptr<Means> means_;
    std::array<accuracy::Picture, levels.size()> references_;
    accuracy::Picture chosen_;
    accuracy::Error error_;
    int samples_ = 0;            // of `chosen_` and `error_`
    int reference_samples_ = 0;  // of the best of `references_`
    double lasts_ = 0;
    accuracy::FrameClock clock_;
    std::vector<double> times_;  // of the last samples of the chosen rungs
    bool cold_ = true;           // the next sample compiles or loads, so it is not timed
    std::uint64_t revision_ = 0;
    RungCosts costs_;
};

// It does nothing while the panel is closed.
class AccuracyView {
public:
    // The GL context of `caps` must be current during the object's whole life.
    AccuracyView(std::string path, const gl::Caps& caps) : path_(std::move(path)), caps_(caps) {}

    // Two documents that are shown in place of the scene and compared: a found rung and the scene, or two states.
    struct Pair {
        Document *left = nullptr, *right = nullptr;
        std::uint64_t showing = 0;  // another number for each pair
    };
    // Call it after each frame, whether the picture was drawn or is unchanged; see Refinement::follow. `failed` are
    // rungs of the scene. Without a pair, the scene is compared with its reference.
    void follow(Document& scene, bool stale, const std::string& failed, const Stand& stand,
                const ui::AccuracyMemory& memory, const Pair& pair);
    // Call it before a document of the pair, or of the scene, is destroyed.
    void leave_pair() { beside_.reset(); }
    void leave();
    bool busy() const { return now() && now()->busy(); }
    double lasts() const { return now() ? now()->lasts() : 0; }
    // How many times smaller than the window's picture those are that its measured rungs need; 0: any size will do.
    int kept_size(const Stand& window) const {
        return refinement_ && refinement_->keeps_size(window) ? refinement_->enlarged() : 0;
    }
    // Returns true if the panel or the picture changed.
    bool step() { return now() && now()->step(); }
    // Starts measuring all rungs of the plotted ladder, or stops it.
    void measure(const ui::AccuracyMemory& memory);
    // Null while the panel is closed, and where there is nothing to compare with. Valid until the next call.
    const ui::AccuracyFacts* facts(const ui::AccuracyMemory& memory);
    // The difference that the heat map shows at a pixel, from the upper left; nothing if it is not shown.
    std::optional<double> difference(int x, int y, const ui::AccuracyMemory& memory) const;
    // Draws the heat map over the window's picture, whose bottom left is at pixel (0, y).
    void show(int y, const ui::AccuracyMemory& memory);
    // Changes whenever show() would draw something else.
    std::uint64_t revision(const ui::AccuracyMemory& memory) const;

private:
    // What is compared with the picture in the window.
    Refinement* now() const { return beside_ ? beside_.get() : refinement_.get(); }

    std::string path_;
    gl::Caps caps_;
    std::unique_ptr<Refinement> refinement_, beside_;  // of the scene, if it has ladders; of a pair
    std::uint64_t showing_ = 0;                        // of the pair that beside_ compares
    ui::AccuracyFacts facts_;
    gl::Still still_;
    std::uint64_t uploaded_ = 0;  // revision() of what still_ shows
    std::uint64_t compared_ = 0;  // revision() that unknown_ is of
    bool unknown_ = false;        // see AccuracyFacts::unknown
};

}  // namespace snell
