// What reports say of rungs that were found.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "src/accuracy/found/search.h"

namespace snell::accuracy {

// Of a combination: of each of its changes, separated by blanks.
std::string place_of(const FoundResult& found, const FoundRung& rung);
// Such as "i < 8 → i < 4".
std::string change_of(const FoundResult& found, const FoundRung& rung);
// Such as "fewer-rounds", or "combination".
std::string kind_of(const FoundResult& found, const FoundRung& rung);
// Its relation to the front, or why it has none, such as "only in the frame that was tried".
std::string standing_of(const FoundResult& found, const FoundRung& rung);
// What was tried, where and how, in sentences.
std::string found_words(const FoundResult& found);

// All rungs of that aim as rungs of a sweep, those that were not timed included.
SweepResult as_sweep(const FoundResult& found, Aim aim);

// The same of the rungs of a sweep, whose own scene is never one.
bool plainly_visible(const SweepResult& sweep, std::size_t rung);

// Tables for a terminal: what changes no pixel, what is cheaper, what would be better.
std::string found_text(const FoundResult& found);
// `plot`: the name of the plot's file; may be empty.
std::string found_markdown(const FoundResult& found, const std::string& plot);
std::string found_html(const FoundResult& found);
nlohmann::ordered_json found_json(const FoundResult& found);

}  // namespace snell::accuracy
