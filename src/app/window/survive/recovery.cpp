#include "src/app/window/survive/recovery.h"

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <string_view>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "parser/text/words.h"
#include "src/app/desktop/folder.h"
#include "src/app/desktop/settings.h"
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
std::string printable_name(const std::string& path) { return utf8::printable(short_name(path)); }

void restore(int number, Document& document, ui::Memory& memory) {
    const Restored restored = restore_snapshot(number, document);
    if (!restored.error.empty()) {
        const bool none = restored.error.starts_with("there is no snapshot");
        memory.failed({restored.error + (none ? fmt::format(". Ctrl+{} stores one", number) : ""),
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

// What is not saved, because it moves by itself.
std::string left_out(const std::vector<std::string>& moving) {
    if (moving.empty()) return "";
    return fmt::format("; not {}, which {}", utf8::printable(fmt::format("{}", fmt::join(moving, ", "))),
                       moving.size() == 1 ? "moves" : "move");
}

// What the user has changed of the view, which no scene has.
std::string not_written(const View& view) {
    View without = view;
    without.objects.clear();
    const std::string all = view_text(view), turned = view_text(without);
    if (all.empty()) return "";
    return fmt::format("; {} not written to the scene", turned.empty()  ? "moved objects are"
                                                        : turned == all ? "the view is"
                                                                        : "the view and moved objects are");
}

// What is typed, as the name of a scene.
std::string scene_name(const ui::SaveAs& dialog) {
    std::string name = without_tilde(dialog.file.data());
    const std::string last = name.substr(name.rfind('/') + 1);
    if (last.find_first_not_of('.') != std::string::npos && !last.ends_with(".glib")) name += ".glib";
    return name;
}

// Says where the scene goes if that is not where it is typed, whenever another name is typed.
void tell_place(const Document& document, ui::SaveAs& dialog) {
    std::string name = scene_name(dialog);
    if (dialog.placed == name) return;
    dialog.placed = std::move(name);
    dialog.place.clear();
    const SavedAs as = saved_as(document, dialog.placed);
    if (!as.lacks && !as.missing) return;
    const std::filesystem::path to = as.file.path;
    const std::string place =
        app::place_in_copy(document.path, document.files->access(), to.parent_path().string(), to.filename().string());
    if (!place.empty() && place != to)
        dialog.place = fmt::format("as {}, with its files", utf8::printable(with_tilde(whole_path(place))));
}

// The file by its name, where it is in the folder that was asked for, and that folder, if it is not the scene's own.
std::string name_and_folder(const std::filesystem::path& file, const std::filesystem::path& folder,
                            const Document& document) {
    if (whole_path(folder / "x") == whole_path(std::filesystem::path(document.path).parent_path() / "x"))
        return printable_name(file);
    return utf8::printable(
        fmt::format("{} in {}", file.lexically_relative(folder).string(), with_tilde(whole_path(folder))));
}

void save_as(const Document& document, ui::Memory& memory, Keeper::Served& served) {
    ui::SaveAs& dialog = memory.save_as;
    SavedAs saved = saved_as(document, scene_name(dialog), memory.animated);
    const std::filesystem::path to = saved.file.path, folder = to.parent_path();
    if (saved.missing && !ui::confirmed(dialog, true, folder.string(), true)) return;
    std::size_t copied = 0;
    if (saved.lacks || saved.missing) {  // from there the scene would not find its files: they go with it
        const app::WrittenCopy copy = app::write_copy(document.path, document.files->access(), saved.texts,
                                                      folder.string(), to.filename().string());
        saved.error = copy.error;
        saved.file.path = copy.scene;
        copied = copy.files.size();
    }
    // Its snapshots have that name, too, in place of those that were there.
    const std::string snapshots = content::whole_file(snapshots_file(document.path)),
                      others = snapshots_file(saved.file.path), there = content::whole_file(others);
    const bool carries = !snapshots.empty() && snapshots != there, replaces = carries && !there.empty();
    const std::string existing = !replaces      ? saved.file.path
                                 : saved.exists ? saved.file.path + " with its snapshots"
                                                : others;
    const bool asks = copied == 0 && saved.error.empty() && (saved.exists || replaces);
    if (!ui::confirmed(dialog, asks, existing)) return;
    if (saved.error.empty() && carries && !(copied > 0 && replaces))
        saved.error = content::replace_file(others, snapshots);
    if (saved.error.empty() && copied == 0) saved.error = content::replace_file(saved.file.path, saved.file.after);
    dialog.error = std::move(saved.error);
    if (!dialog.error.empty()) return;
    dialog.open = false;
    memory.failures.done(Remedy::save);
    const std::string with = copied > 1 ? fmt::format(" with its {}", counted(copied - 1, "file")) : "";
    served.as = "saved as " + name_and_folder(saved.file.path, folder, document) + with + left_out(saved.moving);
    served.saved_as = saved.file.path;
}

}  // namespace

void Keeper::tell(ui::Facts& facts, const Document* document, std::span<const Animated> moving) {
    if (looked_ != facts.revision) look_again();
    looked_ = facts.revision;
    facts.changed = document && document->runtime && changed_values(*document, moving) > 0;
    facts.snapshots = snapshots_;
}

Keeper::Served Keeper::serve(const ui::Requests& requests, Document& document, const Picture& picture,
                             ui::Memory& memory) {
    Served served;
    if (requests.save) save(document, picture.view, memory, served);
    if (requests.save_as) ui::open_save_as(memory.save_as, short_name(document.path));
    if (memory.save_as.open) tell_place(document, memory.save_as);
    if (requests.save_as_now) save_as(document, memory, served);
    if (requests.restore_snapshot > 0) restore(requests.restore_snapshot, document, memory);
    if (requests.store_snapshot > 0)
        store(requests.store_snapshot, requests.values.value_or(snapshot_of(document)), memory, served);
    if (requests.delete_snapshot > 0) remove(requests.delete_snapshot, memory, served);
    if (requests.copy_command) {
        served.copied = render_command(document, picture);
        memory.notice = "copied: " + served.copied;
    }
    return served;
}

void Keeper::save(const Document& document, const View& view, ui::Memory& memory, Served& served) {
    Saved saved = saved_values(document, memory.animated);
    const bool changed = !saved.error.empty();  // by another program, or it is gone
    if (saved.error.empty()) saved.error = write_saved(saved.files);
    if (!saved.error.empty()) {
        std::error_code unknown;
        const bool there = std::filesystem::exists(document.path, unknown);
        memory.failed({"not saved: " + saved.error, !there    ? Remedy::save_as
                                                    : changed ? Remedy::reload
                                                              : Remedy::save});
        return;
    }
    memory.failures.done(Remedy::save);
    std::string unwritten;
    for (const Unwritten& value : saved.unwritten)
        unwritten += fmt::format("{}{}: {}", unwritten.empty() ? "not saved: " : "\n", value.name, value.reason);
    if (!unwritten.empty()) memory.failed({std::move(unwritten), Remedy::add});
    std::string& notice = memory.notice;
    notice = saved.files.empty() ? "nothing to save" : counted(saved.values, "value") + " saved to";
    served.what = "save to";
    for (const SavedFile& file : saved.files) {
        notice += " " + printable_name(file.path);
        served.what += " " + printable_name(file.path);
    }
    notice += left_out(saved.moving);
    if (!saved.widened.empty()) notice += utf8::printable(fmt::format("; range of {}", fmt::join(saved.widened, ", ")));
    if (saved.files.empty()) notice += not_written(view);
    served.files = std::move(saved.files);
}

void Keeper::store(int number, Setup values, ui::Memory& memory, Served& served) {
    const std::string file = snapshots_file(scene_);
    const std::string before = content::whole_file(file), error = store_snapshot(number, scene_, values);
    look_again();
    if (!error.empty()) {
        memory.failed({fmt::format("snapshot {} is not stored: {}", number, error),
                       Remedy::store,
                       {},
                       number,
                       std::move(values)});
        return;
    }
    for (const Remedy mended : {Remedy::store, Remedy::recall, Remedy::absent}) memory.failures.done(mended, number);
    served.what = fmt::format("snapshot {}", number);
    served.files = {{file, before, content::whole_file(file)}};
    memory.notice = fmt::format("snapshot {} is in {}", number, printable_name(file));
}

void Keeper::remove(int number, ui::Memory& memory, Served& served) {
    const std::string file = snapshots_file(scene_), before = content::whole_file(file);
    const std::string error = delete_snapshot(number, scene_);
    look_again();
    if (!error.empty()) return memory.failed({fmt::format("snapshot {} is not deleted: {}", number, error)});
    served.what = fmt::format("snapshot {}", number);
    served.files = {{file, before, content::whole_file(file)}};
    memory.notice = fmt::format("snapshot {} is deleted; Ctrl+Z restores it", number);
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
    std::string text = fmt::format("{} {} {} {}", width, height, carried.time, carried.tries);
    for (const std::string& part :
         {setup_text(setup_of(carried.view)), carried.recovery.values, carried.scene, carried.reading})
        text.append(1, '\0').append(part);
    for (const std::string& file : carried.recovery.files) text.append(1, '\0').append(file);
    return text;
}

Carried read_carried(const std::string& text) {
    std::vector<std::string> parts;
    for (std::size_t at = 0; at < text.size(); at += parts.back().size() + 1) parts.emplace_back(text.c_str() + at);
    Carried carried;
    carried.view.axes = parts.size() < 5;
    if (parts.size() < 5) return carried;
    auto& [width, height] = carried.size;
    std::sscanf(parts[0].c_str(), "%d %d %lf %d", &width, &height, &carried.time, &carried.tries);
    apply_setup(read_setup(parts[1]), carried.view);
    carried.recovery.values = parts[2];
    carried.scene = parts[3];
    carried.reading = parts[4];
    carried.recovery.files.assign(parts.begin() + 5, parts.end());
    return carried;
}

namespace {

constexpr std::string_view after_flag = "--after=", of_hang = "hang:", of_memory = "memory:";

// The handler of operator new has no parameter, so it finds the object here.
std::atomic<const Restart*> of_this_process = nullptr;

std::vector<std::string> own_arguments() {
    const std::string text = content::whole_file("/proc/self/cmdline");
    std::vector<std::string> arguments;
    for (std::size_t at = 0; at < text.size(); at = text.find('\0', at) + 1) arguments.emplace_back(text.c_str() + at);
    std::erase_if(arguments, [](const std::string& argument) { return argument.starts_with(after_flag); });
    return arguments;
}

std::string name_of(const std::string& scene) {
    return utf8::printable(std::filesystem::path(scene).filename().string());
}

int new_memory() { return memfd_create("snell", MFD_CLOEXEC); }

// True if the file was saved after that moment, by the clock of files. A time in the future does not count as an edit.
bool saved_since(const std::string& path, const timespec& moment) {
    const auto later = [](const timespec& a, const timespec& b) {
        return a.tv_sec != b.tv_sec ? a.tv_sec > b.tv_sec : a.tv_nsec > b.tv_nsec;
    };
    struct stat now {};
    timespec present{};
    clock_gettime(CLOCK_REALTIME, &present);
    return stat(path.c_str(), &now) == 0 && later(now.st_mtim, moment) && !later(now.st_mtim, present);
}

// Returns the memory file whose number the previous window passed, or a new one.
int memory_of(std::string_view after) {
    const std::size_t colon = after.find(':');
    int file = -1;
    if (colon != after.npos) std::sscanf(std::string(after.substr(colon + 1)).c_str(), "%9d", &file);
    return file > STDERR_FILENO && fcntl(file, F_SETFD, FD_CLOEXEC) == 0 ? file : new_memory();
}

}  // namespace

Restart::Restart(std::string after)
    : after_(std::move(after)), arguments_(own_arguments()), memory_(memory_of(after_)) {
    std::error_code error;
    program_ = std::filesystem::read_symlink("/proc/self/exe", error).string();
    for (const std::string_view cause : {of_hang, of_memory})
        arguments_.push_back(fmt::format("{}{}{}", after_flag, cause, memory_));
    for (std::size_t i = 0; i < arguments_.size(); ++i) {
        if (i + 1 != arguments_.size()) after_hang_.push_back(arguments_[i].data());
        if (i + 2 != arguments_.size()) after_memory_.push_back(arguments_[i].data());
    }
    after_hang_.push_back(nullptr);
    after_memory_.push_back(nullptr);
    kept_ = read_carried(after_.empty() ? "" : content::whole_file(fmt::format("/proc/self/fd/{}", memory_)));
    of_this_process = this;
    before_ = std::set_new_handler(out_of_memory);
}

Restart::~Restart() {
    std::set_new_handler(before_);
    of_this_process = nullptr;
    if (memory_ >= 0) close(memory_);
}

std::optional<Carried> Restart::carried() const {
    if (after_.empty()) return std::nullopt;
    Carried carried = kept_;
    struct stat memory {};
    fstat(memory_, &memory);
    for (const std::string& file : carried.recovery.files)
        carried.recovery.edited = carried.recovery.edited || saved_since(file, memory.st_mtim);
    const bool of_another = !carried.reading.empty() && carried.reading != carried.scene;
    const std::string again = fmt::format(
        "F5 or another edit {}{}", of_another ? fmt::format("shows {} again", name_of(carried.scene)) : "tries again",
        carried.recovery.values.empty() ? "" : ", with the values that were set manually, as last drawn");
    const std::string in_try = carried.tries > 0 ? fmt::format(" in try {}", carried.tries + 1) : "";
    Diagnostic& problem = carried.recovery.problem;
    problem.has_span = false;
    if (after_.starts_with(of_memory)) {
        problem.code = "out-of-memory";
        problem.message = fmt::format("memory ran out{}{}, and the window was started again; nothing is drawn", in_try,
                                      carried.reading.empty() ? "" : " while reading " + name_of(carried.reading));
        problem.help = (of_another && carried.scene.empty() ? "" : again + "; ") + "--limit asks for less";
    } else {
        problem.code = "frame-too-long";
        problem.message =
            fmt::format("a frame{} took too long{} and was stopped; the window was started again, and nothing is drawn",
                        carried.scene.empty() ? "" : " of " + name_of(carried.scene), in_try);
        problem.help = fmt::format("a loop in a shader may not end; {}; --timeout SECONDS waits longer", again);
    }
    return carried;
}

// The new text replaces the old one at once, so that a restart never finds half of it. The modification time of the
// memory file is that of the last try.
void Restart::store() const {
    const std::string text = carried_text(kept_);
    const int fresh = new_memory();
    if (fresh < 0 || memory_ < 0) return;
    if (write(fresh, text.data(), text.size()) == static_cast<ssize_t>(text.size())) dup3(fresh, memory_, O_CLOEXEC);
    close(fresh);
}

void Restart::trying(const std::string& scene) {
    worth_it_ = true;
    const bool same = scene == (kept_.reading.empty() ? kept_.scene : kept_.reading);
    kept_.tries = drawn_ || !same ? 0 : kept_.tries + 1;
    kept_.reading = scene;
    store();
}

void Restart::keep(Carried carried, bool drawn) {
    carried.tries = drawn ? 0 : kept_.tries;
    kept_ = std::move(carried);
    store();
    if (drawn) worth_it_ = drawn_ = true;
}

app::Deadline Restart::hang_watch(double seconds) const {
    return app::Deadline(seconds, [this, seconds](const std::string& what) {
        fmt::print(stderr,
                   "snell: error: {} takes longer than {} seconds: the window is started again [frame-too-long]\n"
                   "   help: a loop in a shader may not end; --timeout SECONDS allows more\n",
                   what, seconds);
        start(Cause::hang);
    });
}

void Restart::start(Cause cause) const {
    fcntl(memory_, F_SETFD, 0);
    execv(program_.c_str(), (cause == Cause::hang ? after_hang_ : after_memory_).data());
    fcntl(memory_, F_SETFD, FD_CLOEXEC);
}

void Restart::out_of_memory() {
    const Restart* restart = of_this_process;
    if (restart && restart->worth_it_) {
        constexpr std::string_view text = "snell: error: out of memory: the window is started again [out-of-memory]\n";
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
        restart->start(Cause::memory);
    }
    if (restart && restart->before_) restart->before_();
    throw std::bad_alloc();
}

}  // namespace snell
