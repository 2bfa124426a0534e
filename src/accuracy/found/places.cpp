#include "src/accuracy/found/places.h"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "parser/text/ranges.h"
#include "src/document/view_text.h"

namespace snell::accuracy {

namespace {

constexpr double most_turned = 30, least_scale = .7, most_scale = 1.4, seconds = 10;

// The standard fixes the numbers of the generator, but not those of its distributions.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}

    double unit() { return static_cast<double>(random_() >> 11U) * 0x1p-53; }
    // Rounded to a thousandth of the range, so that texts are short and read back to the same bits.
    double within(double low, double high) {
        const double step = (high - low) / 1000;
        return step > 0 ? low + std::floor(unit() * 1001) * step : low;
    }
    bool coin() { return (random_() >> 63U) != 0; }

private:
    std::mt19937_64 random_;
};

std::string uniform_of(const snell::Control& control, const Scene& scene) {
    return scene.programs[control.program].name + "." + control.name;
}

// What is assigned, as the user wrote it: "uEta", "Glass.uEta" or "uColor.g".
std::string_view assigned(std::string_view set) { return set.substr(0, set.find('=')); }

bool same_uniform(std::string_view set, const snell::Control& control, const Scene& scene) {
    const std::string_view name = assigned(set);
    const std::string whole = uniform_of(control, scene);
    return ranges::any_of(std::array<std::string_view, 2>{whole, control.name}, [&](std::string_view known) {
        return name == known || (name.starts_with(known) && (name[known.size()] == '.' || name[known.size()] == '['));
    });
}

bool may_vary(const snell::Control& control, const Scene& scene, const Place& own) {
    const bool number = control.widget == Widget::slider && control.max > control.min;
    const bool other = control.widget == Widget::check_box || control.widget == Widget::color;
    return control.active && control.listed && control.array_size == 1 && (number || other) &&
           ranges::none_of(own.sets, [&](const std::string& set) { return same_uniform(set, control, scene); });
}

// Six digits, as people write them: a place that is printed is the place that was tried.
std::string number_text(double value) { return fmt::format("{:.6g}", value); }

std::string assignment(const snell::Control& control, const Scene& scene, Dice& dice) {
    std::string text = uniform_of(control, scene) + "=";
    const bool whole = control.type == ValueType::int_ || control.type == ValueType::uint_;
    for (int i = 0; i < control.components; ++i) {
        if (i > 0) text += ",";
        if (control.type == ValueType::bool_)
            text += dice.coin() ? "true" : "false";
        else if (whole)
            text += number_text(std::floor(dice.within(control.min, control.max) + .5));
        else if (control.widget == Widget::color)
            text += i == 3 ? number_text(control.value[3]) : number_text(dice.within(0, 1));
        else
            text += number_text(dice.within(control.min, control.max));
    }
    return text;
}

Place another(const Controls& controls, const Scene& scene, bool animated, const Place& own, Dice& dice) {
    Place place = own;
    place.view.scene.rotate_x += std::round(dice.within(-most_turned, most_turned));
    place.view.scene.rotate_y += std::round(dice.within(-most_turned, most_turned));
    place.view.scene.scale *= std::round(100 * dice.within(least_scale, most_scale)) / 100;
    const double time = std::round(100 * dice.within(0, seconds)) / 100;
    if (animated) place.time += time;
    for (const snell::Control& control : controls.items) {
        if (!may_vary(control, scene, own)) continue;
        std::string set = assignment(control, scene, dice);
        if (dice.coin()) place.sets.push_back(std::move(set));
    }
    return place;
}

}  // namespace

std::vector<Place> make_places(const Controls& controls, const Scene& scene, bool animated, const Place& own,
                               const PlaceOptions& options) {
    Dice dice(options.seed);
    std::vector<Place> places{own};
    const std::size_t all = std::max<std::size_t>(options.searched, 1) + options.held_out;
    while (places.size() < all) places.push_back(another(controls, scene, animated, own, dice));
    return places;
}

std::vector<std::string> varying(std::span<const Place> places, const Place& own) {
    std::vector<std::string> names;
    for (const Place& place : places)
        for (std::size_t i = own.sets.size(); i < place.sets.size(); ++i)
            if (const std::string name(assigned(place.sets[i])); ranges::find(names, name) == names.end())
                names.push_back(name);
    return names;
}

std::vector<std::string> place_options(const Place& place, const Place& own) {
    std::vector<std::string> options;
    if (const std::string view = view_text(place.view); !view.empty()) options.push_back("--view " + view);
    if (place.time != own.time || place.time != 0) options.push_back(fmt::format("--time {}", place.time));
    for (const std::string& set : place.sets) options.push_back("--set " + set);
    return options;
}

std::string place_text(const Place& place, const Place& own) {
    if (place == own) return "the scene's own";
    return fmt::format("{}", fmt::join(place_options(place, own), " "));
}

}  // namespace snell::accuracy
