#include "src/server/actions.h"

#include <algorithm>
#include <chrono>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "src/plan/values/write_back.h"
#include "src/server/documents.h"

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

namespace {

constexpr std::chrono::milliseconds most_trial_time{1500};  // for all fixes of a scene

// What is read with the fixes applied; nullopt if one is in no file of the user's.
std::optional<Access> fixed(const Diagnostic& diagnostic, const Sources& sources, const Access& access) {
    std::map<FileId, std::vector<Edit>> by_file;
    for (const Fix& fix : diagnostic.fixes) by_file[fix.span.file].push_back(fix);
    auto texts = std::make_shared<std::map<std::string, std::string>>();
    if (access.instead) *texts = *access.instead;
    for (auto& [file, fixes] : by_file) {
        const std::string name(sources.name(file));
        if (name.empty() || name.starts_with('<')) return std::nullopt;
        ranges::stable_sort(fixes, {}, [](const Edit& fix) { return fix.span.begin; });
        texts->insert_or_assign(real_path(name), with_edits(sources.text(file), file, fixes));
    }
    Access with = access;
    with.instead = std::move(texts);
    return with;
}

using Said = std::multiset<std::pair<std::string_view, std::string_view>>;

// The messages that are at least so severe, by code and text. Views of `all`.
Said said(const Diagnostics& all, Severity severity) {
    Said messages;
    for (const Diagnostic& d : all.items())
        if (d.severity >= severity)
            for (std::size_t i = 0; i <= d.also.size(); ++i) messages.emplace(d.code, d.message);
    return messages;
}

// There are fewer messages, among them the one that is fixed, and none is new. An error hides the warnings of its
// program: they do not count as new when it goes.
bool is_good(const Diagnostic& fixed, const Diagnostics& before, const Diagnostics& after) {
    const Said old = said(before, fixed.severity), now = said(after, fixed.severity);
    const std::pair<std::string_view, std::string_view> one(fixed.code, fixed.message);
    return now.count(one) < old.count(one) && std::includes(old.begin(), old.end(), now.begin(), now.end());
}

}  // namespace

void keep_good_fixes(Checked& checked, const Access& access, const std::function<Checked(const Access&)>& check) {
    const auto end = std::chrono::steady_clock::now() + most_trial_time;
    Diagnostics kept;
    for (Diagnostic diagnostic : checked.diagnostics.items()) {
        if (!diagnostic.fixes.empty()) {
            const auto with =
                std::chrono::steady_clock::now() < end ? fixed(diagnostic, checked.sources, access) : std::nullopt;
            if (!with || !is_good(diagnostic, checked.diagnostics, check(*with).diagnostics)) diagnostic.fixes.clear();
        }
        kept.add(std::move(diagnostic));
    }
    checked.diagnostics = std::move(kept);
}

}  // namespace snell::server
