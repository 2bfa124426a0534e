#include <algorithm>
#include <string_view>
#include <tuple>

#include "src/accuracy/found/change.h"

namespace snell::accuracy {

std::vector<Change> find_changes(const Plan& plan, Files& files, Sources& sources) {
    std::vector<Change> changes;
    add_scene_changes(plan, files, sources, changes);
    add_better_changes(plan, files, sources, changes);
    add_shader_changes(plan, files, sources, changes);
    add_omissions(plan, files, sources, changes);
    // By names: the numbers of texts depend on what was compiled before.
    const auto key = [&](const Change& change) {
        const Span& at = change.where;
        return std::tuple(at.file == 0 ? std::string_view() : sources.name(at.file), at.begin, at.end, change.kind);
    };
    std::stable_sort(changes.begin(), changes.end(), [&](const Change& a, const Change& b) { return key(a) < key(b); });
    return changes;
}

}  // namespace snell::accuracy
