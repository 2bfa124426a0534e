#include <algorithm>
#include <map>
#include <string>
#include <string_view>
#include <tuple>

#include "src/accuracy/found/change.h"

namespace snell::accuracy {

namespace {

// What the edits do to the texts, however they are written: `x += 1.;` → `;` is `x += 1.` → nothing.
std::string effect(const Change& change, const Sources& sources) {
    std::string all = change.probes.empty() ? "" : "a number that is not known\n";
    for (const Edit& edit : change.edits) {
        std::string_view before = sources.text(edit.span.file).substr(edit.span.begin, edit.span.end - edit.span.begin),
                         after = edit.text;
        // A semicolon alone does nothing.
        if (before.ends_with(';') && (after.empty() || after == ";")) before.remove_suffix(1), after = {};
        all.append(sources.name(edit.span.file)).append("\n" + std::to_string(edit.span.begin) + "\n");
        all.append(std::to_string(before.size()) + "\n").append(after).append("\n");
    }
    return all;
}

// Of changes with the same effect, the first that makes the picture cheaper stays, or else the first.
void drop_repeated(std::vector<Change>& changes, const Sources& sources) {
    std::map<std::string, const Change*> kept;
    std::vector<std::string> effects;
    for (const Change& change : changes) {
        const Change*& known = kept[effects.emplace_back(effect(change, sources))];
        const auto cheaper = [](const Change& c) { return facts(c.kind).aim == Aim::cheaper; };
        if (!known || (cheaper(change) && !cheaper(*known))) known = &change;
    }
    std::vector<Change> left;
    for (std::size_t i = 0; i < changes.size(); ++i)
        if (kept[effects[i]] == &changes[i]) left.push_back(changes[i]);
    changes = std::move(left);
}

}  // namespace

std::vector<Change> find_changes(const Plan& plan, Files& files, Sources& sources) {
    std::vector<Change> changes;
    add_scene_changes(plan, files, sources, changes);
    add_better_changes(plan, files, sources, changes);
    add_shader_changes(plan, files, sources, changes);
    add_omissions(plan, files, sources, changes);
    drop_repeated(changes, sources);
    // By names: the numbers of texts depend on what was compiled before.
    const auto key = [&](const Change& change) {
        const Span& at = change.where;
        return std::tuple(at.file == 0 ? std::string_view() : sources.name(at.file), at.begin, at.end, change.kind);
    };
    std::stable_sort(changes.begin(), changes.end(), [&](const Change& a, const Change& b) { return key(a) < key(b); });
    return changes;
}

}  // namespace snell::accuracy
