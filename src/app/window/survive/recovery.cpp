#include "src/app/window/survive/recovery.h"

#include <fmt/format.h>

#include <cstdio>
#include <utility>

#include "src/app/open/loss.h"
#include "src/document/view_text.h"

namespace snell {

Recovery after_loss(std::shared_ptr<const Kept> kept, std::vector<std::string> files) {
    const char* shown = kept ? "what is shown is as it was last drawn" : "nothing is drawn";
    return {std::move(kept),
            std::move(files),
            {},
            {.code = "context-lost",
             .message = fmt::format("{}; {}", app::loss_message, shown),
             .help = fmt::format("{}; F5 or another edit tries again", app::loss_help),
             .has_span = false}};
}

// Parts are separated by 0, the only byte that names of files cannot hold.
std::string carried_text(const Carried& carried) {
    const auto [width, height] = carried.size;
    std::string text = fmt::format("{} {} {} {}", width, height, carried.time, carried.view.axes ? 1 : 0);
    for (const std::string& part : {view_text(carried.view), carried.recovery.values, carried.scene})
        text.append(1, '\0').append(part);
    for (const std::string& file : carried.recovery.files) text.append(1, '\0').append(file);
    return text;
}

Carried read_carried(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < text.size(); at += parts.back().size() + 1) parts.emplace_back(text.c_str() + at);
    Carried carried;
    carried.view.axes = true;
    if (parts.size() < 4) return carried;
    int axes = 1;
    auto& [width, height] = carried.size;
    std::sscanf(parts[0].c_str(), "%d %d %lf %d", &width, &height, &carried.time, &axes);
    carried.view.axes = axes != 0;
    parse_view(parts[1], carried.view);
    carried.recovery.values = parts[2];
    carried.scene = parts[3];
    carried.recovery.files.assign(parts.begin() + 4, parts.end());
    return carried;
}

}  // namespace snell
