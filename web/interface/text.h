// What crosses to the page, as JSON. web/page/engine.ts has the types.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "src/document/document.h"

namespace snell::web {

using Json = nlohmann::ordered_json;

Json problems_json(const Diagnostics& diagnostics, const Sources& sources);
// Controls, ladders, size, files and counters.
Json shown_json(const Document& document);

}  // namespace snell::web
