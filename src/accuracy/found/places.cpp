#include "src/accuracy/found/search.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "parser/text/ranges.h"
#include "src/plan/setup.h"

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
    template <class T>
    void shuffle(std::vector<T>& items) {
        for (std::size_t i = items.size(); i > 1; --i) {
            const std::size_t other = random_() % i;
            const T item = items[i - 1];
            items[i - 1] = items[other];
            items[other] = item;
        }
    }

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

bool is_whole(const snell::Control& control) {
    return control.type == ValueType::int_ || control.type == ValueType::uint_;
}

// Six digits, as people write them: a place that is printed is the place that was tried.
std::string number_text(double value) { return fmt::format("{:.6g}", value); }

// The two ends first, then one value of each of the parts of equal width that the range is divided into, to a
// thousandth of the range; in a seeded order.
std::vector<std::string> stratified(double low, double high, std::size_t count, bool whole, Dice& dice) {
    std::vector<std::string> values;
    for (std::size_t i = 0; i < count; ++i) {
        double part = static_cast<double>(i);  // 0 and 1: the ends
        if (i > 1) part = (part - 2 + dice.unit()) / static_cast<double>(count - 2);
        const double value = low + std::floor(1000 * part + .5) * ((high - low) / 1000);
        values.push_back(number_text(whole ? std::floor(value + .5) : value));
    }
    dice.shuffle(values);
    return values;
}

// Round after round of all values, each in a seeded order. The first lacks the scene's own, which its own place has.
std::vector<std::string> in_turn(double low, double high, double own, std::size_t count, Dice& dice) {
    std::vector<std::string> values;
    for (bool first = true; values.size() < count; first = false) {
        std::vector<std::string> round;
        for (double value = low; value <= high; ++value)
            if (!first || value != own) round.push_back(number_text(value));
        dice.shuffle(round);
        values.insert(values.end(), round.begin(), round.end());
    }
    values.resize(count);
    return values;
}

// One of every two places has the other value, and the last one if it has no partner.
std::vector<std::string> alternating(bool own, std::size_t searched, std::size_t held_out, Dice& dice) {
    std::vector<std::string> values;
    for (const std::size_t count : {searched, held_out})
        for (std::size_t i = 0; i < count; i += 2) {
            const bool first = i + 1 == count || dice.coin();
            values.emplace_back(own != first ? "true" : "false");
            if (i + 1 < count) values.emplace_back(own == first ? "true" : "false");
        }
    return values;
}

// A column of texts for each component, a row for each of the places but the scene's own.
std::vector<std::string> component(const snell::Control& control, std::size_t i, std::size_t moved,
                                   const PlaceOptions& options, Dice& dice) {
    const double own = control.value[i];
    if (control.type == ValueType::bool_)
        return alternating(own != 0, std::max<std::size_t>(options.searched, 1) - 1, options.held_out, dice);
    if (control.widget == Widget::color)
        return i == 3 ? std::vector<std::string>(moved, number_text(own)) : stratified(0, 1, moved, false, dice);
    if (!is_whole(control)) return stratified(control.min, control.max, moved, false, dice);
    const double low = std::ceil(control.min), high = std::floor(control.max);
    if (low > high) return std::vector<std::string>(moved, number_text(own));  // a range without whole numbers
    const bool all = high - low <= static_cast<double>(moved);
    return all ? in_turn(low, high, own, moved, dice) : stratified(low, high, moved, true, dice);
}

// In which places a uniform has the scene's own value: half of them, as far as the ends of its range leave some.
// Whole numbers and check boxes have theirs in turn.
std::vector<bool> staying(const snell::Control& control, std::size_t others, Dice& dice) {
    std::vector<bool> stay(others, false);
    if (is_whole(control) || control.type == ValueType::bool_) return stay;
    std::fill_n(stay.begin(), std::min(others / 2, others - std::min<std::size_t>(others, 2)), true);
    dice.shuffle(stay);
    return stay;
}

void vary(const snell::Control& control, const Scene& scene, const PlaceOptions& options, std::span<Place> others,
          Dice& dice) {
    const std::vector<bool> stay = staying(control, others.size(), dice);
    const auto moved = static_cast<std::size_t>(ranges::count(stay, false));
    std::vector<std::vector<std::string>> columns;
    for (int i = 0; i < control.components; ++i)
        columns.push_back(component(control, static_cast<std::size_t>(i), moved, options, dice));
    std::size_t row = 0;
    for (std::size_t place = 0; place < others.size(); ++place) {
        if (stay[place]) continue;
        std::string text = uniform_of(control, scene) + "=";
        for (const auto& column : columns) text += (&column == &columns.front() ? "" : ",") + column[row];
        others[place].sets.push_back(std::move(text));
        ++row;
    }
}

Place elsewhere(bool animated, const Place& own, Dice& dice) {
    Place place = own;
    place.view.scene.rotate_x += std::round(dice.within(-most_turned, most_turned));
    place.view.scene.rotate_y += std::round(dice.within(-most_turned, most_turned));
    place.view.scene.scale *= std::round(100 * dice.within(least_scale, most_scale)) / 100;
    const double time = std::round(100 * dice.within(0, seconds)) / 100;
    if (animated) place.time += time;
    return place;
}

}  // namespace

std::vector<Place> make_places(const Controls& controls, const Scene& scene, bool animated, const Place& own,
                               const PlaceOptions& options) {
    Dice dice(options.seed);
    std::vector<Place> places{own};
    const std::size_t all = std::max<std::size_t>(options.searched, 1) + options.held_out;
    while (places.size() < all) places.push_back(elsewhere(animated, own, dice));
    for (const snell::Control& control : controls.items)
        if (may_vary(control, scene, own)) vary(control, scene, options, std::span(places).subspan(1), dice);
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
