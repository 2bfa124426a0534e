#include "src/app/window/measure/found_view.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <optional>
#include <set>
#include <tuple>
#include <utility>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/accuracy/found/change.h"
#include "src/accuracy/found/search.h"
#include "src/accuracy/report/report.h"
#include "src/app/open/command_text.h"
#include "src/app/open/write_copy.h"
#include "src/plan/setup.h"

namespace snell {

namespace {

using accuracy::Aim, accuracy::Change, accuracy::FoundResult, accuracy::FoundRung, accuracy::Outcome;
using Group = ui::FoundRow::Group;

constexpr double saves_nothing = .995;  // of the scene's time: it is shown as 1.00

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
        // Until it is timed, what is within the noise of a few frames is no saving.
        const bool noise = row.ratio > 0 && !result.times(rung) && !rung.quicker;
        if (row.group == Group::cheaper && (noise || row.ratio > saves_nothing)) row.group = Group::dearer;
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

namespace {

constexpr double patience = 120;  // seconds that a search draws; the user may stop it
// Short steps are taken together, because the window is drawn after them.
constexpr std::chrono::milliseconds at_once{50};
// For the means of expressions, which have no steps.
constexpr std::chrono::seconds longest_wait{2};

// The folder that a rung is written to if the user names no other one: beside the scene.
std::filesystem::path folder_for(const std::string& scene, const std::string& rung) {
    const std::filesystem::path path(scene);
    return path.parent_path() / (path.stem().string() + "-rung-" + rung);
}

}  // namespace

// The texts that are sought in stay after the search, for what is shown and written.
struct FoundView::Sought {
    Sought(const std::string& path, const Access& access) : files(scene_folder(path), access) {}

    Files files;
    Sources sources;
    Plan plan;
    std::vector<accuracy::Change> changes;
    std::optional<accuracy::Search> search;
    Stand at;
    Rungs rungs;
    std::string doing = "opening the scene";
    double done = 0;
    const std::function<void()>* alive = nullptr;  // during a step
};

FoundView::FoundView(std::string path, const gl::Caps& caps) : path_(std::move(path)), caps_(caps) {}
FoundView::~FoundView() = default;
FoundView::FoundView(FoundView&&) noexcept = default;
FoundView& FoundView::operator=(FoundView&&) noexcept = default;

bool FoundView::follow(const Document& scene, bool stale, const Stand& stand, bool still,
                       const ui::AccuracyMemory& memory) {
    if (!memory.open) return false;
    const char* note = stale ? "There are errors: no rungs can be sought." : "";
    const bool older = sought_ && (scene.controls.rungs != sought_->rungs || circumstances(stand) != sought_->at);
    const bool waiting = sought_ && sought_->search && !still;
    const bool changed = facts_.note != note || facts_.older != older || facts_.waiting != waiting;
    facts_.note = note;
    facts_.older = older;
    facts_.waiting = waiting;
    if (older) end("The search was stopped, because something was changed.");
    return changed;
}

void FoundView::leave() {
    end("The search was stopped, because the files have changed.");
    facts_.stale = facts_.asked;
    facts_.shown.clear();
    rung_.reset();
}

bool FoundView::busy() const { return sought_ && sought_->search && !facts_.waiting; }

bool FoundView::step(const std::function<void()>& alive) {
    if (!busy()) return false;
    sought_->alive = &alive;
    const auto start = std::chrono::steady_clock::now();
    bool more = true;
    while (more && std::chrono::steady_clock::now() - start < at_once) more = sought_->search->step();
    sought_->alive = nullptr;
    if (!more) {
        end("");
        return true;
    }
    facts_.doing = sought_->doing;
    facts_.progress = sought_->done;
    facts_.rows = found_rows(sought_->search->result(), sought_->sources, true);
    return true;
}

void FoundView::begin(Document& scene, const Stand& stand) {
    sought_ = std::make_unique<Sought>(path_, scene.files->access());
    Sought& sought = *sought_;
    facts_ = {.asked = true, .reduced = reduced_text(stand), .progress = 0, .doing = sought.doing};
    rung_.reset();  // the numbers may be others now
    sought.at = circumstances(stand);
    sought.rungs = scene.controls.rungs;
    Diagnostics unheard;  // the window shows those of the scene
    auto plan = read_plan(path_, sought.files, sought.sources, unheard);
    if (!plan) return end("The scene cannot be read.");
    sought.plan = std::move(*plan);
    carry_over(scene.controls.rungs, scene.scene(), sought.plan.rungs, sought.plan.scene);
    sought.changes = accuracy::find_changes(sought.plan, sought.files, sought.sources);
    const auto start = std::chrono::steady_clock::now();
    accuracy::fill_averages({path_, sought.plan, sought.files, sought.sources}, sought.changes, caps_,
                            [start] { return std::chrono::steady_clock::now() - start > longest_wait; });
    accuracy::SearchOptions options;
    options.seconds = patience;
    options.stop = [&sought] {
        if (sought.alive) (*sought.alive)();
        return false;
    };
    options.report = [&sought](const accuracy::Progress& progress) {
        sought.doing = progress.doing;
        sought.done = progress.done;
    };
    sought.search.emplace(accuracy::Original{path_, sought.plan, sought.files, sought.sources}, sought.changes, caps_,
                          accuracy::BenchSettings{.width = stand.width,
                                                  .height = stand.height,
                                                  .time = stand.time,
                                                  .sets = set_arguments(scene.scene(), scene.controls),
                                                  .view = sought.at.view},
                          std::move(options));
}

void FoundView::end(const char* why) {
    if (!facts_.progress) return;
    facts_.progress.reset();
    facts_.waiting = false;
    facts_.remark = why;
    if (!sought_->search) return;
    const accuracy::FoundResult& result = sought_->search->result();
    facts_.rows = found_rows(result, sought_->sources, false);
    if (facts_.remark.empty() && result.late) facts_.remark = "The time was up before everything was tried.";
    if (facts_.remark.empty()) facts_.remark = accuracy::noise_sentence(result.timed.control);
    sought_->search.reset();
}

std::map<std::string, std::string> FoundView::texts(const std::string& name, std::string& error) const {
    if (!sought_) return {};
    const auto chosen = accuracy::choose_changes(name, sought_->changes, sought_->sources, error);
    if (!chosen) return {};
    std::vector<const accuracy::Change*> changes;
    for (const accuracy::Change& change : chosen->changes) changes.push_back(&change);
    return accuracy::changed_texts(changes, sought_->sources);
}

void FoundView::show(const std::string& name, Document& scene, std::string& notice) {
    rung_.reset();
    facts_.shown.clear();
    if (name.empty() || facts_.stale) return;
    std::string error;
    const std::map<std::string, std::string> instead = texts(name, error);
    const auto choose = [&](const Scene& changed, Rungs& rungs) {
        carry_over(scene.controls.rungs, scene.scene(), rungs, changed);
    };
    if (error.empty()) rung_ = open_beside(scene, caps_, choose, instead, error);
    if (rung_) {
        facts_.shown = name;
        ++showings_;
        return;
    }
    notice = fmt::format("found rung {} cannot be drawn: {}", name, error);
}

Document& FoundView::shown(Document& scene) {
    if (!rung_) return scene;
    rung_->controls = scene.controls;
    return *rung_;
}

void FoundView::write(const Document& scene, ui::Memory& memory) {
    ui::SaveAs& dialog = memory.write_rung;
    const auto folder = std::filesystem::path(path_).parent_path() / dialog.file.data();
    if (dialog.file[0] == '\0') {
        dialog.error = "the folder needs a name";
        return;
    }
    dialog.error.clear();
    const auto changed = texts(facts_.shown, dialog.error);
    if (!dialog.error.empty()) return;
    const app::WrittenCopy copy = app::write_copy(path_, scene.files->access(), changed, folder.string());
    dialog.error = utf8::printable(copy.error);
    if (!dialog.error.empty()) return;
    dialog.open = false;
    memory.notice = fmt::format("wrote {}", utf8::printable(copy.scene));
}

void FoundView::serve(const ui::Requests& requests, Document& scene, const Stand& stand, ui::Memory& memory) {
    if (!memory.accuracy.open) {
        rung_.reset();
        facts_.shown.clear();
        end("The search was stopped.");
    }
    if (requests.find_rungs) {
        if (facts_.progress)
            end("The search was stopped.");
        else
            begin(scene, stand);
    }
    if (requests.show_rung) show(*requests.show_rung, scene, memory.notice);
    if (facts_.shown.empty()) {
        memory.write_rung.open = false;
        return;
    }
    if (requests.write_rung) ui::open_save_as(memory.write_rung, folder_for(path_, facts_.shown).filename().string());
    if (requests.write_rung_now) write(scene, memory);
}

std::string FoundView::command() const {
    if (facts_.shown.empty()) return "";
    return apply_command(path_,
                         arguments_of(changed_setup(sought_->plan.scene, {{}, sought_->plan.rungs}), ladder_option),
                         facts_.shown, folder_for(path_, facts_.shown).string());
}

}  // namespace snell
