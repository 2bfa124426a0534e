#include <algorithm>
#include <tuple>

#include "src/accuracy/found/change.h"

namespace snell::accuracy {

std::vector<Change> find_changes(const Plan& plan, Files& files, Sources& sources) {
    std::vector<Change> changes;
    add_scene_changes(plan, files, sources, changes);
    add_better_changes(plan, files, sources, changes);
    add_shader_changes(plan, files, sources, changes);
    add_omissions(plan, files, sources, changes);
    std::stable_sort(changes.begin(), changes.end(), [](const Change& a, const Change& b) {
        return std::tuple(a.where.file, a.where.begin, a.where.end, a.kind) <
               std::tuple(b.where.file, b.where.begin, b.where.end, b.kind);
    });
    return changes;
}

}  // namespace snell::accuracy
