#include "src/server/actions.h"

#include <fmt/format.h>

namespace snell::server {

namespace {

std::string shortened(std::string text) {
    constexpr std::size_t most = 60;
    if (text.size() > most) text = text.substr(0, most - 3) + "...";
    return text;
}

std::string title_of(const Json& fix) {
    const std::string before = shortened(string_at(fix, "old")), after = shortened(string_at(fix, "newText"));
    if (before.empty()) return fmt::format("Insert '{}'", after);
    if (after.empty()) return fmt::format("Remove '{}'", before);
    return fmt::format("Change '{}' to '{}'", before, after);
}

bool wants_quick_fixes(const Json& params) {
    const Json context = params.value("context", Json::object());
    if (!context.contains("only")) return true;
    for (const Json& kind : context["only"])
        if (kind == "quickfix" || kind == "") return true;
    return false;
}

bool before(Place a, Place b) { return a.line != b.line ? a.line < b.line : a.character < b.character; }

bool touch(const Json& a, const Json& b) {
    return !before(place_of(a.at("end")), place_of(b.at("start"))) &&
           !before(place_of(b.at("end")), place_of(a.at("start")));
}

}  // namespace

Json code_actions(const Json& diagnostics, const Json& params) {
    Json actions = Json::array();
    if (!wants_quick_fixes(params)) return actions;
    for (const Json& diagnostic : diagnostics) {
        if (!diagnostic.contains("data") || !touch(diagnostic.at("range"), params.at("range"))) continue;
        const Json& fixes = diagnostic.at("data").at("fixes");
        Json edits = Json::object();
        for (const Json& fix : fixes)
            edits[string_at(fix, "uri")].push_back({{"range", fix.at("range")}, {"newText", fix.at("newText")}});
        actions.push_back({{"title", title_of(fixes.at(0))},
                           {"kind", "quickfix"},
                           {"diagnostics", Json::array({diagnostic})},
                           {"isPreferred", true},
                           {"edit", {{"changes", std::move(edits)}}}});
    }
    return actions;
}

}  // namespace snell::server
