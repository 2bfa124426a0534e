// Where changes are tried: views, times and values of sliders, from a seed. No GL.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "src/accuracy/bench.h"
#include "src/plan/values/controls.h"

namespace snell::accuracy {

struct PlaceOptions {
    std::size_t searched = 4, held_out = 4;  // how many; the scene's own is the first of those that are searched
    std::uint64_t seed = 1;
};

// Returns places: the scene's own first, then those that are searched, then those that are held out. Each but the first
// turns the view by up to 30° and scales it by .7 to 1.4, and, if `animated`, has another time. Every slider, check box
// and colour of `controls` has other values there, within its range:
//   - Sliders of whole numbers have all values in turn, if there are at most as many as places; otherwise as below.
//   - Check boxes have the other value in every second place, of those that are searched and of those held out.
//   - Others have both ends of the range at one place each and a value in each of equal parts of it at the rest, except
//     for half of the places, where they keep the scene's own value. Each component of a vector has an order of its
//     own.
// What `own` assigns keeps its value. The same arguments give the same places on every machine.
std::vector<Place> make_places(const Controls& controls, const Scene& scene, bool animated, const Place& own,
                               const PlaceOptions& options);

// The uniforms that any of the places assigns and `own` does not, as "Program.uniform".
std::vector<std::string> varying(std::span<const Place> places, const Place& own);

// The place as options of `snell render`, such as "--view rotate_x=12,scale=1.1" and "--set Glass.uEta=1.31".
std::vector<std::string> place_options(const Place& place, const Place& own);
// The same in one line; "the scene's own" for the first.
std::string place_text(const Place& place, const Place& own);

}  // namespace snell::accuracy
