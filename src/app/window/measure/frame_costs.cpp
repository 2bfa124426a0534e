#include "src/app/window/measure/frame_costs.h"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/accuracy/timing.h"
#include "src/gl/present.h"
#include "src/gl/target.h"
#include "src/plan/locate.h"

namespace snell {

namespace {

constexpr std::size_t most_pass_times = 60;  // of a pass

// The oldest go where there is no room; no allocation once there are as many as that.
template <typename T>
void push(std::vector<T>& values, T value, std::size_t most) {
    if (values.capacity() < most) values.reserve(most);
    if (values.size() == most) values.erase(values.begin());
    values.push_back(value);
}

std::string pass_name(const Pass& pass) {
    if (pass.kind == Pass::Kind::window) return "window";
    std::string name = pass.kind == Pass::Kind::cube ? "RenderToCube" : "RenderToTexture";
    for (const int unit : pass.units) name += fmt::format(" {}", unit);
    return name;
}

}  // namespace

// Frames with a time of every draw, in rounds with frames without waits or queries between the draws.
struct FrameCosts::Apart {
    FrameCosts* costs = nullptr;  // these, and what is drawn, are of the current step
    Document* document = nullptr;
    const Stand* stand = nullptr;
    gl::Target target;
    accuracy::ClockKind clock;
    std::optional<accuracy::Rounds> rounds = {};
    Times times = {};
    double done = 0;

    void draw(const std::function<void(const Step&)>* after = nullptr) const {
        Frame frame{
            .time = stand->time, .view = stand->view, .controls = document->controls, .enlarged = stand->enlarged};
        frame.after = after;
        document->runtime->draw(frame, {target.framebuffer.get(), target.width, target.height});
    }
    std::map<Key, double> draw_apart();
    void begin();
};

FrameCosts::FrameCosts(const gl::Caps& caps) : caps_(caps), clock_(caps.software) {}
FrameCosts::~FrameCosts() = default;
FrameCosts::FrameCosts(FrameCosts&&) noexcept = default;
FrameCosts& FrameCosts::operator=(FrameCosts&&) noexcept = default;

bool FrameCosts::by_gpu() { return !caps_.software && !distrusted_ && marks_.available(); }

bool FrameCosts::open(bool wanted, std::uint64_t revision, double milliseconds) {
    if (wanted == open_) return false;
    *this = FrameCosts(caps_);
    open_ = wanted;
    revision_ = revision;
    if (open_ && milliseconds > 0) push(frames_, static_cast<float>(milliseconds), most_frames);
    return open_;
}

const std::function<void(const Step&)>* FrameCosts::begin(std::uint64_t revision, bool at_once) {
    if (!open_) return nullptr;
    if (revision != revision_) {  // another scene
        frames_.clear();
        live_.clear();
        known_.clear();
        apart_.reset();
        revision_ = revision;
        facts_.coarse = 0;
    }
    running_ = true;
    marking_ = at_once && by_gpu();
    if (!marking_) return nullptr;
    marked_.clear();
    marks_.mark();
    listener_ = [this](const Step& step) {
        if (step.draw != none) return;
        marks_.mark();
        marked_.push_back(step.pass);
    };
    return &listener_;
}

void FrameCosts::read_marks(double picture, bool sharp) {
    marks_.mark();  // the axes, and many samples made one
    const auto times = marks_.take();
    double all = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        all += times[i];
        if (sharp && i < marked_.size()) push(live_[{marked_[i], none}], times[i], most_pass_times);
    }
    // A clock that is wrong is so again and again; one late reading is none.
    odd_ = all > 1.2 * picture + .2 ? odd_ + 1 : 0;
    if (odd_ < 5) return;
    distrusted_ = true;
    live_.clear();
}

void FrameCosts::end(double milliseconds, bool sharp) {
    if (!std::exchange(running_, false)) return;
    if (sharp)
        push(frames_, static_cast<float>(milliseconds), most_frames);
    else
        ++facts_.coarse;
    if (std::exchange(marking_, false)) read_marks(milliseconds, sharp);
}

void FrameCosts::measure() {
    if (!open_) return;
    apart_ = apart_ ? nullptr : std::make_unique<Apart>();
    if (apart_) known_.clear();
}

// Draws one frame. Without queries the time of a draw ends when the GPU is done with it, so it is waited for. A cube's
// faces draw the same again.
std::map<FrameCosts::Key, double> FrameCosts::Apart::draw_apart() {
    std::map<Key, double> sums;
    const auto add = [&](const Step& step, double time) {
        sums[{step.pass, none}] += time;
        if (step.draw != none) sums[{step.pass, step.draw}] += time;
    };
    const bool queries = clock == accuracy::ClockKind::gpu;
    std::vector<Step> marked;
    double before = 0;
    const std::function<void(const Step&)> listen = [&](const Step& step) {
        if (queries) {
            costs->marks_.mark();
            marked.push_back(step);
            return;
        }
        gl::finish();
        add(step, accuracy::wall_milliseconds() - before);
        before = accuracy::wall_milliseconds();
    };
    gl::finish();
    if (queries) costs->marks_.mark();
    before = accuracy::wall_milliseconds();
    draw(&listen);
    if (queries) {
        const auto found = costs->marks_.take();
        for (std::size_t i = 0; i < found.size() && i < marked.size(); ++i) add(marked[i], found[i]);
    }
    return sums;
}

void FrameCosts::Apart::begin() {
    clock = costs->by_gpu() ? accuracy::ClockKind::gpu : accuracy::ClockKind::wall;
    const auto time = [this](double) {
        accuracy::Times took = costs->clock_.of([this] { draw(); });
        if (took.gpu <= 0) took.gpu = took.wall;
        return took;
    };
    const auto time_apart = [this](double) {
        for (const auto& [key, milliseconds] : draw_apart()) times[key].push_back(milliseconds);
        return accuracy::Times();
    };
    const auto warm_up = [time](accuracy::ClockKind) { return std::optional(time(0).wall); };
    const auto warm_up_apart = [this](accuracy::ClockKind) { return draw_apart(), std::optional(0.); };
    const auto report = [this](std::string_view, double share) { done = share; };
    rounds.emplace(std::vector<accuracy::Entrant>{{warm_up, time}, {warm_up_apart, time_apart}},
                   accuracy::RoundOptions{.clock = clock,
                                          .control = false,
                                          .everyone = true,
                                          .rounds = most_rounds,
                                          .at_least = 0,
                                          .report = report});
}

bool FrameCosts::step(Document& document, const Stand& stand, int samples) {
    if (!apart_) return false;
    Apart& apart = *apart_;
    if (apart.target.width != stand.width || apart.target.height != stand.height) {
        apart.target = gl::make_target(stand.width, stand.height, samples);
        apart.rounds.reset();  // times of two sizes are no rounds
        apart.times.clear();
    }
    if (!apart.target.framebuffer) {
        apart_.reset();
        return true;
    }
    apart.costs = this;
    apart.document = &document;
    apart.stand = &stand;
    if (!apart.rounds) apart.begin();
    if (apart.rounds->step()) return true;
    known_ = std::move(apart.times);
    facts_.reduced = reduced_text(stand);
    known_of_ = {circumstances(stand), document.controls.rungs};
    plain_ = accuracy::median(accuracy::by_clock(apart.rounds->times(0), apart.clock));
    apart_.reset();
    return true;
}

void FrameCosts::fill(Explanation& explanation) const {
    const auto cost = [this](double milliseconds) {
        FrameCost result;
        result.wall = milliseconds;
        if (!caps_.software && !distrusted_) result.gpu = milliseconds;
        return result;
    };
    for (Explanation::Paid& paid : explanation.paid) {
        paid.frame.reset();
        if (known_.empty()) continue;
        if (paid.kind == Explanation::Kind::pass) {
            const auto found = known_.find({paid.pass, none});
            if (found != known_.end()) paid.frame = cost(accuracy::median(found->second));
        } else if (paid.kind == Explanation::Kind::program && !paid.draws.empty()) {
            double sum = 0;
            for (const auto& [key, times] : known_)
                if (ranges::count(paid.draws, key.second)) sum += accuracy::median(times);
            paid.frame = cost(sum);
        }
    }
}

std::vector<ui::CostRow> FrameCosts::rows_of(const Times& times, const Document& document) const {
    const Scene& scene = document.scene();
    std::vector<ui::CostRow> rows;
    for (Index pass = 0; pass < scene.passes.size(); ++pass) {
        const auto all = times.find({pass, none});
        if (all == times.end() || (scene.passes[pass].kind == Pass::Kind::window && scene.passes[pass].items.empty()))
            continue;
        rows.push_back({pass_name(scene.passes[pass]), "", accuracy::median(all->second), false});
        if (pass > 0) rows.back().place = statement_place(scene.passes[pass].span, document.sources);
        for (auto it = times.lower_bound({pass, 0}); it != times.end() && it->first.first == pass; ++it) {
            const Index index = it->first.second;
            if (index == none || index >= scene.draws.size()) continue;
            const Draw& draw = scene.draws[index];
            rows.push_back({statement_text(draw.span, document.sources), statement_place(draw.span, document.sources),
                            accuracy::median(it->second), true});
        }
    }
    return rows;
}

const ui::FrameCostFacts* FrameCosts::facts(const Document* document, const Stand& stand) {
    if (!open_) return nullptr;
    sorted_.assign(frames_.begin(), frames_.end());
    facts_.frames = frames_;
    facts_.high = accuracy::quantile(sorted_, .95);
    facts_.median = accuracy::quantile(sorted_, .5);
    if (live_.empty()) live_rows_.clear();
    if (document && !live_.empty()) live_rows_ = rows_of(live_, *document);
    if (known_.empty())
        apart_rows_.clear();
    else if (document && apart_rows_.empty())
        apart_rows_ = rows_of(known_, *document);
    facts_.passes = live_rows_;
    facts_.apart = apart_rows_;
    facts_.apart_plain = plain_;
    facts_.apart_clock = by_gpu() ? "GPU time, with a timer query at every draw"
                                  : "with a wait after every draw, which makes draws take longer";
    facts_.older =
        !known_.empty() && document && known_of_ != std::pair(circumstances(stand), document->controls.rungs);
    facts_.measuring.reset();
    if (apart_) facts_.measuring = apart_->done;
    return &facts_;
}

}  // namespace snell
