#include "src/app/window/measure/found_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <tuple>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/report/found.h"

namespace snell {

namespace {

using accuracy::Aim, accuracy::Change, accuracy::FoundResult, accuracy::FoundRung, accuracy::Outcome;
using Group = ui::FoundRow::Group;

Group group_of(const FoundRung& rung) {
    if (rung.outcome != Outcome::tried) return Group::untried;
    return rung.aim == Aim::cheaper ? Group::cheaper : rung.aim == Aim::better ? Group::better : Group::unused;
}

void add(std::string& list, std::string_view separator, std::string_view word) {
    if (!list.empty()) list += separator;
    list += utf8::printable(word);
}

// What changes, and where.
void describe(ui::FoundRow& row, const FoundRung& rung, const std::vector<Change>& changes, const Sources& sources) {
    std::set<accuracy::ChangeKind> told;
    for (const std::size_t index : rung.changes) {
        const Change& change = changes[index];
        const accuracy::KindFacts& kind = facts(change.kind);
        if (told.insert(change.kind).second) {
            add(row.kind, ", ", kind.name);
            add(row.meaning, "; ", kind.doc);
        }
        add(row.before, "; ", change.before);
        add(row.after, "; ", change.after.empty() && rung.changes.size() > 1 ? "(nothing)" : change.after);
    }
    const Span where = changes[rung.changes.front()].where;
    const Position at = sources.position(where.file, where.begin);
    row.place = {std::string(sources.name(where.file)), at.line, at.column};
    row.where =
        fmt::format("{}:{}", utf8::printable(std::filesystem::path(row.place.file).filename().string()), at.line);
}

void measured(ui::FoundRow& row, const FoundRung& rung, const FoundResult& result) {
    if (const accuracy::Difference* worst = rung.worst()) {
        row.error = worst->own.light.rmse;
        row.of_display = worst->own.display.rmse;
        row.flip = rung.flip();
        row.error_here = rung.at.front().own.light.rmse;
        row.flip_here = rung.at.front().flip;
    }
    row.ratio = rung.quick_ratio;
    if (const accuracy::RungResult* times = result.times(rung)) {
        row.ratio = times->ratio.middle;
        row.low = times->ratio.known() ? times->ratio.low : 0;
        row.high = times->ratio.known() ? times->ratio.high : 0;
    }
    row.loading = rung.load_ms.value_or(0);
    row.bytes = static_cast<std::uint64_t>(std::max<std::int64_t>(rung.gpu_bytes, 0));
}

}  // namespace

std::vector<ui::FoundRow> found_rows(const FoundResult& result, const Sources& sources, bool searching) {
    const std::vector<const FoundRung*> front = result.front(), without_effect = result.without_effect();
    const auto among = [](const std::vector<const FoundRung*>& all, const FoundRung& rung) {
        return ranges::find(all, &rung) != all.end();
    };
    std::vector<ui::FoundRow> rows;
    for (const FoundRung& rung : result.rungs) {
        ui::FoundRow row{.group = group_of(rung), .name = rung.name};
        if (row.group == Group::untried && searching) continue;
        if (row.group == Group::unused && !among(without_effect, rung)) continue;
        row.front = among(front, rung);
        describe(row, rung, result.changes, sources);
        if (row.group == Group::untried)
            row.remark = rung.reason.empty() ? "the search was stopped" : utf8::printable(rung.reason);
        else
            measured(row, rung, result);
        // Of places that are held out, the window says what the report says.
        const bool unseen = !searching && !rung.held_out && result.places.size() > result.searched;
        if (rung.outcome == Outcome::tried && rung.aim != Aim::unused && (rung.only_where_tried || unseen))
            row.remark = utf8::printable(standing_of(result, rung));
        rows.push_back(std::move(row));
    }
    const std::vector<ui::FoundRow> all = rows;
    for (ui::FoundRow& row : rows)
        if (ranges::any_of(all, [&](const ui::FoundRow& other) {
                return other.name != row.name && other.kind == row.kind && other.where == row.where;
            }))
            row.where += fmt::format(":{}", row.place.column);
    ranges::stable_sort(
        rows, {}, [](const ui::FoundRow& row) { return std::tuple(row.group, !row.front, row.front ? row.ratio : 0); });
    return rows;
}

}  // namespace snell
