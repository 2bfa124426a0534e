#include "src/app/window/measure/frame_costs.h"

#include <fmt/format.h>

#include <algorithm>

#include "parser/text/ranges.h"
#include "src/accuracy/costs.h"
#include "src/app/open/complain.h"
#include "src/gl/present.h"
#include "src/gl/target.h"

namespace snell {

namespace {

constexpr std::size_t most_pass_times = 60;  // of a pass

// The value that so much of all of them do not exceed; `values` are put in another order.
float quantile(std::vector<float>& values, double part) {
    if (values.empty()) return 0;
    const auto at = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + .5);
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
}

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

struct FrameCosts::Apart {
    gl::Target target;
    int round = 0;
    Times times;
    std::map<Key, double> sums;  // of one frame: a cube's faces draw the same again
    std::vector<double> plain;   // of frames without waits or queries between the draws
    double before = 0;
    std::vector<Step> marked;
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

const std::function<void(const Step&)>* FrameCosts::begin(std::uint64_t revision) {
    if (!open_) return nullptr;
    if (revision != revision_) {  // another scene
        frames_.clear();
        live_.clear();
        known_.clear();
        apart_.reset();
        revision_ = revision;
    }
    running_ = true;
    if (!by_gpu()) return nullptr;
    marked_.clear();
    marks_.mark();
    listener_ = [this](const Step& step) {
        if (step.draw != none) return;
        marks_.mark();
        marked_.push_back(step.pass);
    };
    return &listener_;
}

void FrameCosts::read_marks(double picture) {
    marks_.mark();  // the axes, and many samples made one
    const auto times = marks_.take();
    double all = 0;
    for (std::size_t i = 0; i < times.size(); ++i) {
        all += times[i];
        if (i < marked_.size()) push(live_[{marked_[i], none}], times[i], most_pass_times);
    }
    // A clock that is wrong is so again and again; one late reading is none.
    odd_ = all > 1.2 * picture + .2 ? odd_ + 1 : 0;
    if (odd_ < 5) return;
    distrusted_ = true;
    live_.clear();
}

void FrameCosts::end(double milliseconds) {
    if (!running_) return;
    running_ = false;
    push(frames_, static_cast<float>(milliseconds), most_frames);
    if (by_gpu()) read_marks(milliseconds);
}

void FrameCosts::measure() {
    if (!open_) return;
    apart_ = apart_ ? nullptr : std::make_unique<Apart>();
    if (!apart_) return;
    known_.clear();
}

bool FrameCosts::step(Document& document, const Stand& stand, int samples) {
    if (!apart_) return false;
    Apart& apart = *apart_;
    if (apart.target.width != stand.width || apart.target.height != stand.height)
        apart.target = gl::make_target(stand.width, stand.height, samples);
    if (!apart.target.framebuffer) {
        apart_.reset();
        return true;
    }
    const bool queries = by_gpu();
    // Without queries the time of a draw ends when the GPU is done with it, so it is waited for.
    const std::function<void(const Step&)> listen = [&](const Step& step) {
        if (queries) {
            marks_.mark();
            apart.marked.push_back(step);
            return;
        }
        gl::finish();
        const double at = accuracy::wall_milliseconds();
        apart.sums[{step.pass, none}] += at - apart.before;
        if (step.draw != none) apart.sums[{step.pass, step.draw}] += at - apart.before;
        apart.before = accuracy::wall_milliseconds();
    };
    apart.sums.clear();
    apart.marked.clear();
    gl::finish();
    if (queries) marks_.mark();
    apart.before = accuracy::wall_milliseconds();
    Frame frame{.time = stand.time, .view = stand.view, .controls = document.controls};
    const Surface surface{apart.target.framebuffer.get(), stand.width, stand.height};
    frame.after = &listen;
    document.runtime->draw(frame, surface);
    if (queries) {
        const auto times = marks_.take();
        for (std::size_t i = 0; i < times.size() && i < apart.marked.size(); ++i) {
            const Step& step = apart.marked[i];
            apart.sums[{step.pass, none}] += times[i];
            if (step.draw != none) apart.sums[{step.pass, step.draw}] += times[i];
        }
    }
    frame.after = nullptr;
    const accuracy::Times plain = clock_.of([&] { document.runtime->draw(frame, surface); });
    if (apart.round++ > 0) {
        for (const auto& [key, time] : apart.sums) apart.times[key].push_back(time);
        apart.plain.push_back(queries && plain.gpu > 0 ? plain.gpu : plain.wall);
    }
    if (apart.round < rounds) return true;
    known_ = std::move(apart.times);
    plain_ = accuracy::median(apart.plain);
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

const ui::FrameCostFacts* FrameCosts::facts(const Document* document) {
    if (!open_) return nullptr;
    sorted_.assign(frames_.begin(), frames_.end());
    facts_.frames = frames_;
    facts_.high = quantile(sorted_, .95);
    facts_.median = quantile(sorted_, .5);
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
    facts_.measuring.reset();
    if (apart_) facts_.measuring = static_cast<double>(apart_->round) / rounds;
    return &facts_;
}

}  // namespace snell
