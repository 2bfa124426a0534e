// What crosses to the page, as JSON. web/page/engine.ts has the types.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "src/document/document.h"
#include "src/plan/values/animate.h"
#include "src/plan/values/numbers.h"

namespace snell::web {

using Json = nlohmann::ordered_json;

// How sliders move.
struct Sliders {
    std::vector<Animated> moving;
    std::set<std::pair<Index, std::string>> logarithmic;  // programs and names

    bool can_be_logarithmic(const Control& control) const;
    Track track_of(const Control& control) const;
    // Null if it does not move by itself.
    Animated* motion_of(const Control& control, std::size_t component);
};

Json problems_json(const Diagnostics& diagnostics, const Sources& sources);
// All values as they are now, with their texts and places on their tracks.
Json controls_json(const Document& document, Sliders& sliders);
// Controls, ladders, size, files and counters.
Json shown_json(const Document& document, Sliders& sliders);

}  // namespace snell::web
