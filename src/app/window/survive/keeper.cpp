#include "src/app/window/survive/keeper.h"

#include <cstdio>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "src/app/open/ending.h"
#include "src/app/open/write_copy.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "src/plan/setup.h"
#include "src/plan/values/numbers.h"

namespace snell {

namespace {

using Remedy = ui::Failure::Remedy;

std::string short_name(const std::string& path) { return std::filesystem::path(path).filename().string(); }

void restore(int number, Document& document, ui::Memory& memory) {
    const Restored restored = restore_snapshot(number, document);
    if (!restored.error.empty()) {
        const bool none = restored.error.starts_with("there is no snapshot");
        memory.failures.add({restored.error + (none ? fmt::format(". Ctrl+{} stores one", number) : ""),
                             none ? Remedy::absent : Remedy::recall,
                             {},
                             number});
        return;
    }
    const std::string lost =
        restored.lost == 0 ? "" : fmt::format("; {} left out: not in this scene", counted(restored.lost, "value"));
    memory.failures.done(Remedy::recall, number);
    memory.notice = fmt::format("snapshot {}{}", number, lost);
}

void save_as(const Document& document, ui::Memory& memory, Keeper::Served& served) {
    ui::SaveAs& dialog = memory.save_as;
    std::string name = dialog.file.data();
    const std::string last = name.substr(name.rfind('/') + 1);
    if (last.find_first_not_of('.') != std::string::npos && !last.ends_with(".glib")) name += ".glib";
    SavedAs saved = saved_as(document, name);
    if (!ui::confirmed(dialog, saved.error.empty() && saved.exists, saved.file.path)) return;
    if (saved.error.empty()) saved.error = content::replace_file(saved.file.path, saved.file.after);
    dialog.error = std::move(saved.error);
    if (!dialog.error.empty()) return;
    dialog.open = false;
    memory.failures.done(Remedy::save);
    served.saved_as = saved.file.path;
}

}  // namespace

void Keeper::tell(ui::Facts& facts, const Document* document) {
    if (looked_ != facts.revision) look_again();
    looked_ = facts.revision;
    facts.changed = document && document->runtime && changed_values(*document) > 0;
    facts.snapshots = snapshots_;
}

Keeper::Served Keeper::serve(const ui::Requests& requests, Document& document, const Picture& picture,
                             ui::Memory& memory) {
    Served served;
    if (requests.save) save(document, memory, served);
    if (requests.save_as) ui::open_save_as(memory.save_as, short_name(document.path));
    if (requests.save_as_now) save_as(document, memory, served);
    if (requests.restore_snapshot > 0) restore(requests.restore_snapshot, document, memory);
    if (requests.store_snapshot > 0)
        store(requests.store_snapshot, requests.values.value_or(snapshot_of(document)), memory, served);
    if (requests.copy_command) {
        served.copied = render_command(document, picture);
        memory.notice = "copied: " + served.copied;
    }
    return served;
}

void Keeper::save(const Document& document, ui::Memory& memory, Served& served) {
    Saved saved = saved_values(document);
    const bool changed = !saved.error.empty();  // by another program, or it is gone
    if (saved.error.empty()) saved.error = write_saved(saved.files);
    if (!saved.error.empty()) {
        std::error_code unknown;
        const bool there = std::filesystem::exists(document.path, unknown);
        memory.failures.add({"not saved: " + saved.error, !there    ? Remedy::save_as
                                                          : changed ? Remedy::reload
                                                                    : Remedy::save});
        return;
    }
    memory.failures.done(Remedy::save);
    std::string& notice = memory.notice;
    notice = saved.files.empty() ? "nothing to save" : counted(saved.values, "value") + " saved to";
    served.what = "save to";
    for (const SavedFile& file : saved.files) {
        notice += " " + short_name(file.path);
        served.what += " " + short_name(file.path);
    }
    std::string unwritten;
    for (const Unwritten& value : saved.unwritten)
        unwritten += fmt::format("{}{}: {}", unwritten.empty() ? "not saved: " : "\n", value.name, value.reason);
    if (!unwritten.empty()) memory.failures.add({std::move(unwritten), Remedy::save});
    served.files = std::move(saved.files);
}

void Keeper::store(int number, Setup values, ui::Memory& memory, Served& served) {
    const std::string file = snapshots_file(scene_);
    const std::string before = content::whole_file(file), error = store_snapshot(number, scene_, values);
    look_again();
    if (!error.empty()) {
        memory.failures.add({fmt::format("snapshot {} is not stored: {}", number, error),
                             Remedy::store,
                             {},
                             number,
                             std::move(values)});
        return;
    }
    for (const Remedy mended : {Remedy::store, Remedy::recall, Remedy::absent}) memory.failures.done(mended, number);
    served.what = fmt::format("snapshot {}", number);
    served.files = {{file, before, content::whole_file(file)}};
    memory.notice = fmt::format("snapshot {} is in {}", number, short_name(file));
}

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
    std::string text = fmt::format("{} {} {}", width, height, carried.time);
    for (const std::string& part : {setup_text(setup_of(carried.view)), carried.recovery.values, carried.scene})
        text.append(1, '\0').append(part);
    for (const std::string& file : carried.recovery.files) text.append(1, '\0').append(file);
    return text;
}

Carried read_carried(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < text.size(); at += parts.back().size() + 1) parts.emplace_back(text.c_str() + at);
    Carried carried;
    carried.view.axes = parts.size() < 4;
    if (parts.size() < 4) return carried;
    auto& [width, height] = carried.size;
    std::sscanf(parts[0].c_str(), "%d %d %lf", &width, &height, &carried.time);
    apply_setup(read_setup(parts[1]), carried.view);
    carried.recovery.values = parts[2];
    carried.scene = parts[3];
    carried.recovery.files.assign(parts.begin() + 4, parts.end());
    return carried;
}

}  // namespace snell
