#include "src/accuracy/measure.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "parser/text/ranges.h"

namespace snell::accuracy {

namespace {

constexpr std::size_t most_combinations = 64, most_ladders = 3;

// The ladders of these names, each once; all ladders if there are no names.
std::vector<std::size_t> find_ladders(const Scene& scene, const std::vector<std::string>& names,
                                      Diagnostics& diagnostics) {
    std::vector<std::size_t> found;
    std::vector<std::string_view> known;
    for (const Ladder& ladder : scene.ladders) known.push_back(ladder.name);
    if (names.empty())
        for (std::size_t i = 0; i < known.size(); ++i) found.push_back(i);
    for (const std::string& name : names) {
        const auto at = ranges::find(known, name);
        if (at == known.end()) {
            const std::string_view near = nearest(name, known);
            diagnostics.error("unknown-ladder", fmt::format("there is no ladder '{}'", name),
                              !near.empty()   ? fmt::format("did you mean '{}'?", near)
                              : known.empty() ? "the scene has no ladders"
                                              : fmt::format("available ladders: {}", fmt::join(known, ", ")));
            continue;
        }
        const auto index = static_cast<std::size_t>(at - known.begin());
        if (ranges::find(found, index) == found.end()) found.push_back(index);
    }
    return found;
}

Sweep ladder_sweep(const Scene& scene, const Rungs& now, std::size_t index, From from) {
    const Ladder& ladder = scene.ladders[index];
    Sweep sweep{.kind = SweepKind::ladder, .name = ladder.name};
    sweep.moved = {index};
    sweep.numeric = ladder.numeric();
    sweep.reference = ladder.rungs.size() - 1;
    sweep.current = now[index];
    sweep.elsewhere = from == From::reference ? "where the scene stands" : "with the other ladders at their last rungs";
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
        Variant variant{from == From::reference ? last_rungs(scene) : now, {}};
        Rungs elsewhere = from == From::reference ? now : last_rungs(scene);
        variant.rungs[index] = elsewhere[index] = i;
        if (elsewhere == variant.rungs) elsewhere.clear();
        sweep.rungs.push_back({ladder.rungs[i], std::move(variant), {i}, std::move(elsewhere)});
    }
    return sweep;
}

// ---- knobs -----------------------------------------------------------------------------------------------

struct Setting {
    std::string name;
    Knobs knobs;
    bool current = false;
};

bool is_rendered_cube(const Texture& texture) {
    return texture.target == TextureTarget::cube && texture.files.empty() && texture.computed == Computed::no;
}

// The last setting is the reference.
std::vector<Setting> sample_settings() {
    std::vector<Setting> settings{{"1", {}, true}, {"msaa4", {.multisample = 4}}};
    for (int n : {2, 3, 4, 8}) settings.push_back({fmt::format("{0}x{0}", n), {.grid = n}});
    return settings;
}

std::vector<Setting> tessellation_settings() {
    return {{"x1/3", {.plan = {.tessellation = 1.0 / 3}}},
            {"x1", {}, true},
            {"x2", {.plan = {.tessellation = 2}}},
            {"x4", {.plan = {.tessellation = 4}}},
            {"x8", {.plan = {.tessellation = 8}}}};
}

// As the scene filters all of its files; nullopt if it does so in several ways.
std::optional<Filter> own_filter(const Scene& scene, bool software) {
    std::optional<Filter> own;
    for (const Texture& texture : scene.textures) {
        if (texture.files.empty()) continue;
        const bool as_mipmap = software && texture.target == TextureTarget::cube;
        const Filter filter = as_mipmap && texture.filter.mode == Filter::Mode::anisotropic
                                  ? Filter{Filter::Mode::mipmap, 1}
                                  : texture.filter;
        if (own && *own != filter) return std::nullopt;
        own = filter;
    }
    return own;
}

// Filters approximate the picture that many samples of the finest texels give.
std::vector<Setting> filter_settings(const Scene& scene, bool software) {
    using Mode = Filter::Mode;
    const std::optional<Filter> own = own_filter(scene, software);
    std::vector<std::pair<std::string, Filter>> filters{
        {"nearest", {Mode::nearest, 1}}, {"linear", {Mode::linear, 1}}, {"mipmap", {Mode::mipmap, 1}}};
    if (!software || !has_cube_maps(scene)) filters.emplace_back("anisotropic8", Filter{Mode::anisotropic, 8});
    std::vector<Setting> settings;
    bool listed = false;
    for (auto& [name, filter] : filters) {
        const bool current = filter == own;
        listed = listed || current;
        settings.push_back({std::move(name), {.plan = {.filter = filter}}, current});
    }
    if (!listed) settings.push_back({"scene", {}, true});
    settings.push_back({"linear_8x8", {.grid = 8, .plan = {.filter = Filter{Mode::linear, 1}}}});
    return settings;
}

std::vector<Setting> cube_size_settings(const Scene& scene) {
    int rendered = 0;
    for (const Texture& texture : scene.textures)
        if (is_rendered_cube(texture)) rendered = std::max(rendered, texture.size[0]);
    const int largest = rendered > 0 ? std::clamp(2 * rendered, 512, 2048) : 512;
    std::vector<int> sizes;
    for (int size = 32; size <= largest; size *= 2) sizes.push_back(size);
    if (rendered > 0 && ranges::find(sizes, rendered) == sizes.end())
        sizes.insert(std::upper_bound(sizes.begin(), sizes.end(), rendered), rendered);
    std::vector<Setting> settings;
    for (const int size : sizes) {
        const bool current = size == rendered;
        settings.push_back({std::to_string(size), {.plan = {.cube_size = current ? 0 : size}}, current});
    }
    if (rendered == 0) settings.push_back({"files", {}, true});
    return settings;
}

// Cube maps that are drawn to have bytes, unless this says otherwise; those of files have what the files have.
std::vector<Setting> precision_settings(const Scene& scene) {
    const bool drawn = ranges::any_of(scene.textures, is_rendered_cube);
    const bool read = ranges::any_of(
        scene.textures, [](const Texture& t) { return t.target == TextureTarget::cube && !t.files.empty(); });
    std::vector<Setting> settings{{"8bit", {.plan = {.cube_bits = 8}}, !read}};
    if (drawn && read) settings.push_back({"scene", {}, true});
    settings.push_back({"half", {.plan = {.cube_bits = 16}}, !drawn});
    return settings;
}

std::vector<Setting> settings_of(std::string_view knob, const Scene& scene, bool software) {
    if (knob == "samples") return sample_settings();
    if (knob == "tessellation" && has_round_shapes(scene)) return tessellation_settings();
    if (knob == "filter" && has_textures(scene)) return filter_settings(scene, software);
    if (knob == "cube-size" && has_cube_maps(scene)) return cube_size_settings(scene);
    if (knob == "cube-precision" && has_cube_maps(scene)) return precision_settings(scene);
    return {};
}

}  // namespace

Rungs last_rungs(const Scene& scene) {
    Rungs rungs;
    for (const Ladder& ladder : scene.ladders) rungs.push_back(ladder.rungs.size() - 1);
    return rungs;
}

std::size_t count_combinations(const Scene& scene, const std::vector<std::size_t>& ladders) {
    std::size_t product = 1;
    for (const std::size_t ladder : ladders)
        product = std::min<std::size_t>(product * scene.ladders[ladder].rungs.size(), 1 << 20);
    return product;
}

std::vector<Rungs> all_combinations(const Scene& scene, const std::vector<std::size_t>& ladders) {
    std::vector<Rungs> all;
    Rungs rungs = last_rungs(scene);
    for (const std::size_t ladder : ladders) rungs[ladder] = 0;
    while (true) {
        all.push_back(rungs);
        std::size_t i = ladders.size();
        while (i > 0 && ++rungs[ladders[i - 1]] == scene.ladders[ladders[i - 1]].rungs.size()) rungs[ladders[--i]] = 0;
        if (i == 0) return all;
    }
}

Sweep combination_sweep(const Scene& scene, const std::vector<std::size_t>& ladders, std::vector<Rungs> all,
                        const Rungs& base) {
    const auto place = [&](const Rungs& rungs) {
        const auto found = ranges::find(all, rungs);
        const auto at = static_cast<std::size_t>(found - all.begin());
        if (found == all.end()) all.push_back(rungs);
        return at;
    };
    Sweep sweep{.kind = SweepKind::lattice};
    sweep.reference = place(last_rungs(scene));
    sweep.current = place(base);
    sweep.moved = ladders;
    for (const Rungs& rungs : all)
        sweep.rungs.push_back({.name = {}, .variant = {rungs, {}}, .steps = {}, .elsewhere = {}});
    for (const std::size_t ladder : ladders) {
        const std::string_view between = sweep.name.empty() ? "" : " ";
        sweep.name.append(between).append(scene.ladders[ladder].name);
        for (SweepRung& rung : sweep.rungs) {
            rung.steps.push_back(rung.variant.rungs[ladder]);
            rung.name.append(between).append(scene.ladders[ladder].rungs[rung.steps.back()]);
        }
    }
    return sweep;
}

std::vector<Sweep> ladder_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                                 Diagnostics& diagnostics) {
    std::vector<Sweep> sweeps;
    for (std::size_t index : find_ladders(scene, names, diagnostics))
        sweeps.push_back(ladder_sweep(scene, now, index, from));
    return sweeps;
}

std::vector<Sweep> lattice_sweep(const Scene& scene, const Rungs& now, const std::vector<std::string>& names,
                                 Diagnostics& diagnostics) {
    std::vector<std::size_t> ladders = find_ladders(scene, names, diagnostics);
    if (names.empty() && ladders.size() > most_ladders) ladders.resize(most_ladders);
    const std::size_t combinations = count_combinations(scene, ladders);
    if (ladders.empty() || ladders.size() > most_ladders || combinations > most_combinations) {
        diagnostics.error(
            "lattice-size",
            ladders.empty()
                ? "a lattice needs ladders, but the scene has none"
                : fmt::format("{} ladders have {} combinations, which is too many", ladders.size(), combinations),
            fmt::format("choose at most {} ladders with at most {} combinations", most_ladders, most_combinations));
        return {};
    }
    Rungs base = last_rungs(scene);
    for (const std::size_t ladder : ladders) base[ladder] = now[ladder];
    return {combination_sweep(scene, ladders, all_combinations(scene, ladders), base)};
}

std::vector<Sweep> knob_sweeps(const Scene& scene, const Rungs& now, const std::vector<std::string>& names, From from,
                               bool software, Diagnostics& diagnostics) {
    std::vector<Sweep> sweeps;
    for (const std::string& name : names) {
        if (ranges::find(knob_names, name) == knob_names.end()) {
            diagnostics.error("unknown-knob", fmt::format("there is no knob '{}'", name),
                              fmt::format("available knobs: {}", fmt::join(knob_names, ", ")));
            continue;
        }
        const std::vector<Setting> settings = settings_of(name, scene, software);
        if (settings.empty()) continue;
        Sweep sweep{.kind = SweepKind::knob, .name = name};
        sweep.reference = settings.size() - 1;
        for (const Setting& setting : settings) {
            if (setting.current) sweep.current = sweep.rungs.size();
            sweep.rungs.push_back({setting.name,
                                   {from == From::reference ? last_rungs(scene) : now, setting.knobs},
                                   {sweep.rungs.size()},
                                   {}});
        }
        sweeps.push_back(std::move(sweep));
    }
    return sweeps;
}

}  // namespace snell::accuracy
