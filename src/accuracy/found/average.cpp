#include "src/accuracy/found/average.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "parser/text/ranges.h"
#include "src/accuracy/found/trial.h"

namespace snell::accuracy {

namespace {

constexpr std::size_t most_pixels = 16384;

BenchSettings small_picture(const Scene& scene) {
    BenchSettings settings;
    settings.width = std::max(scene.window_size[0], 1);
    settings.height = std::max(scene.window_size[1], 1);
    while (static_cast<std::size_t>(settings.width) * static_cast<std::size_t>(settings.height) > most_pixels &&
           std::min(settings.width, settings.height) > 16) {
        settings.width /= 2;
        settings.height /= 2;
    }
    return settings;
}

// The means of the two components that a probe draws; nothing if they are not known. `refused`: why it is not drawn.
std::optional<std::array<double, 2>> drawn_means(Trials& trials, std::size_t probe, std::size_t places,
                                                 std::string& refused) {
    Trial trial = trials.open(std::vector{probe});
    std::array<double, 2> sum{};
    std::size_t count = 0;
    for (std::size_t place = 0; place < places && trial.refused.empty(); ++place) {
        const auto picture = trials.picture(trial, place);
        for (std::size_t i = 0; picture && i < picture->rgba.size(); i += 4) {
            const float* pixel = &picture->rgba[i];
            if (pixel[2] != static_cast<float>(probe_mark) || !std::isfinite(pixel[0]) || !std::isfinite(pixel[1]))
                continue;
            ++count;
            for (std::size_t c = 0; c < 2; ++c) sum[c] += static_cast<double>(pixel[c]);
        }
    }
    refused = trial.refused;
    if (!refused.empty() || count == 0) return std::nullopt;
    for (double& value : sum) value /= static_cast<double>(count);
    return sum;
}

}  // namespace

void fill_averages(const Original& original, std::span<Change*> changes, const gl::Caps& caps, const Stop& stop) {
    std::vector<Change> probes;
    std::vector<Change*> once;
    for (Change* change : changes)
        if (ranges::find(once, change) == once.end()) once.push_back(change);
    for (const Change* change : once)
        for (const std::vector<Edit>& edits : change->probes)
            probes.push_back({change->kind, change->where, {}, {}, edits});
    if (probes.empty()) return;
    const PlaceOptions places;
    Trials trials(original, probes, caps, small_picture(original.plan.scene));
    trials.open_scene(places);
    if (!trials.scene_error().empty()) return;
    std::size_t next = 0;
    for (Change* change : once) {
        std::vector<double> means;
        for (std::size_t i = 0; i < change->probes.size(); ++i, ++next) {
            if (stop && stop()) return;
            std::string refused;
            if (const auto two = drawn_means(trials, next, std::min(places.searched, trials.places().size()), refused))
                means.insert(means.end(), two->begin(), two->end());
            if (!refused.empty()) change->refused = refused;
        }
        if (means.empty() || means.size() != 2 * change->probes.size()) continue;
        std::string& text = change->edits.front().text;
        const std::string type = text.substr(0, text.find('('));
        means.resize(type == "float" ? 1 : static_cast<std::size_t>(type.back() - '0'));
        std::vector<std::string> numbers;
        for (const double mean : means) numbers.push_back(real_literal(std::abs(mean) < 1e-30 ? 0 : mean, 3));
        text = fmt::format("{}({})", type, fmt::join(numbers, ", "));
        change->after = excerpt(text);
        change->probes.clear();
    }
}

void fill_averages(const Original& original, std::vector<Change>& changes, const gl::Caps& caps, const Stop& stop) {
    std::vector<Change*> all;
    for (Change& change : changes) all.push_back(&change);
    fill_averages(original, all, caps, stop);
}

}  // namespace snell::accuracy
