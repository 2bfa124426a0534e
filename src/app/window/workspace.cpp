#include "src/app/window/workspace.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

#include "parser/text/words.h"
#include "src/app/desktop/folder.h"
#include "src/app/open/command_text.h"
#include "src/app/open/quality.h"
#include "src/app/page/page.h"

namespace snell {

namespace {

FirstRungs first_rungs(const WindowOptions& options) {
    return [options](const Scene& scene, Rungs& rungs, Diagnostics& diagnostics) {
        app::choose_rungs(options.scene, {options.quality, options.ladders, {}}, options.access, scene, rungs,
                          diagnostics);
    };
}

// What `snell web` gets, so that it makes the page of what the window shows, under the same limits.
std::vector<std::string> page_arguments(const Document& document, const View& view) {
    std::vector<std::string> words = value_options(document, view);
    const Access& access = document.files->access();
    if (access.confine) words.insert(words.end(), {"--confine", *access.confine});
    for (const std::string& folder : access.allow) words.insert(words.end(), {"--allow", folder});
    for (const LimitFacts& limit : limit_table())
        if (access.limits.*limit.value != Limits{}.*limit.value)
            words.insert(words.end(), {"--limit", fmt::format("{}={}", limit.name, access.limits.*limit.value)});
    words.insert(words.end(), {"--", document.path});
    return words;
}

// Returns the page's path if it may be written, or after the user confirmed that it may.
std::string confirmed_page(const Document& document, ui::SaveAs& dialog) {
    std::filesystem::path page = std::filesystem::path(document.path).parent_path() / dialog.file.data();
    dialog.error = page.has_filename() ? "" : "the page needs a name";
    if (!dialog.error.empty()) return {};
    if (!page.has_extension()) page += ".html";
    std::error_code error;
    return ui::confirmed(dialog, std::filesystem::exists(page, error), page.string()) ? page.string() : "";
}

// To the programs of another text: what moves, what is logarithmic, and what is in use.
void carry_sliders(const std::vector<Index>& programs, std::size_t count, ui::Memory& memory) {
    memory.numbers.carry(programs, count);
    carry_motions(programs, memory.animated);
    if (std::optional<Animated>& stopped = memory.slider.stopped) {
        std::vector<Animated> one{*std::exchange(stopped, {})};
        carry_motions(programs, one);
        if (!one.empty()) stopped = std::move(one[0]);
    }
    for (auto& [program, name] : std::exchange(memory.logarithmic, {}))
        if (program < programs.size() && programs[program] != none) memory.logarithmic.emplace(programs[program], name);
}

}  // namespace

std::string title_of(const std::string& scene, bool unsaved) {
    if (scene.empty()) return "snell";
    return std::string(unsaved ? "\u2022 " : "") + "snell \u2014 " + utf8::printable(scene);
}

Workspace::Workspace(const WindowOptions& options, const gl::Caps& caps, Watcher progress, const Recovery* recovery,
                     Past& past)
    : past_(past),
      session_(is_folder(options.scene) ? "" : options.scene, caps, options.access, first_rungs(options),
               std::move(progress), recovery, past_.read(options.scene)),
      keeper_(options.scene),
      opener_(settings_file()),
      saver_(caps, options.access.limits) {}

std::string Workspace::folder() {
    return utf8::printable(with_tilde(std::filesystem::path(whole_path(session_.path())).parent_path().string()));
}

void Workspace::report() {
    std::string text = session_.problems_text();
    if (text != reported_) fmt::print(stderr, "{}", text);
    reported_ = std::move(text);
}

void Workspace::reload(View& view, ui::Memory& memory) {
    const std::size_t before = session_.errors();
    const std::vector<ProgramId> programs = document() ? program_ids(document()->scene()) : std::vector<ProgramId>{};
    past_.fold(memory.folds, session_);
    session_.reload();
    if (document()) {
        const std::vector<ProgramId> now = program_ids(document()->scene());
        carry_sliders(carried_programs(programs, now), now.size(), memory);
    }
    if (session_.errors() > before) memory.notice.clear();  // it is older than the edit
    if (std::string said = past_.reread(session_, view, memory.animated); !said.empty())
        memory.notice = std::move(said);
    memory.folds = past_.folds();
    report();
}

void Workspace::begin(View& view, ui::Memory& memory) {
    memory.notice = past_.begin(session_, view);
    if (std::string said = std::exchange(saved_as_, {}); !said.empty()) memory.notice = std::move(said);
    take_sections(memory);
}

void Workspace::continue_with(const View& view, ui::Memory& memory) {
    past_.continue_with(session_, view);
    take_sections(memory);
}

void Workspace::take_sections(ui::Memory& memory) {
    memory.folds = past_.folds();
    memory.numbers.carry({}, document() ? document()->scene().programs.size() : 0);
}

bool Workspace::look(const View& view, ui::Memory& memory) {
    past_.fold(memory.folds, session_);
    past_.write(session_, view);
    std::string said = pages_.look();
    const bool saved = !said.empty();
    // The reason is longer than the status line, and comes when the user may be at something else.
    const bool failed = said.find(" is not saved: ") != said.npos;
    if (failed) {
        memory.failed({std::move(said), ui::Failure::Remedy::page});
    } else if (saved) {
        memory.failures.done(ui::Failure::Remedy::page);
        memory.notice = std::move(said);
    }
    return opener_.look(memory) || saved;
}

std::optional<std::string> Workspace::new_title() {
    if (titled_unsaved_ == unsaved_ && titled_path_ == session_.path()) return std::nullopt;
    titled_path_ = session_.path();
    titled_unsaved_ = unsaved_;
    return title_of(titled_path_, unsaved_);
}

bool Workspace::follow_rungs() {
    const bool followed = session_.follow_rungs();
    if (followed) report();
    return followed;
}

void Workspace::remember_scene() {
    if (document()) opener_.opened(session_.path());
}

void Workspace::finish(View& view, bool lost) {
    past_.finish(session_, view);
    if (lost || !session_.saved(true)) return;
    session_.reload();  // such as after a save or its undo: what differs from the file now is remembered
    past_.reread(session_, view);
}

std::string Workspace::open(const std::string& path, View& view) {
    finish(view);
    past_.write(session_, view);
    if (std::string problem = session_.open(path, past_.read(path)); !problem.empty()) {
        past_.read(session_.path());
        saved_as_.clear();
        return problem;
    }
    keeper_ = Keeper(path);
    remember_scene();
    report();
    return {};
}

void Workspace::tell(ui::Facts& facts, const ui::Memory& memory) {
    name_ = utf8::printable(std::filesystem::path(session_.path()).filename().string());
    facts.file = name_;
    facts.problems = session_.problems();
    facts.stale = session_.stale();
    facts.failed_rungs = session_.failed_rungs();
    facts.revision = session_.revision();
    if (const Document* shown = document()) {
        facts.scene = &shown->scene();
        facts.incomplete = shown->diagnostics.has_errors();
        facts.animated = shown->runtime->animated();
        facts.timed = shown->runtime->timed();
        facts.mouse = shown->runtime->uses_mouse();
        linked_.clear();
        // A program without uniforms looks like one that failed, but only a failure leaves an error.
        const bool whole = !shown->diagnostics.has_errors();
        for (const auto& uniforms : shown->runtime->active_uniforms()) linked_.push_back(whole || !uniforms.empty());
        facts.linked = linked_;
    }
    keeper_.tell(facts, document(), memory.animated);
    unsaved_ = facts.changed;
    opener_.tell(facts, session_.path(), session_.files(), memory.browser.open);
}

std::optional<std::string> Workspace::serve(const ui::Requests& requests, const Picture& shown, Window& window,
                                            View& view, ui::Memory& memory) {
    if (document()) {
        const std::string undone = past_.serve(requests, session_, view, memory.animated, [this] { follow_rungs(); });
        if (!undone.empty()) {
            // What has changed is read already, or is no file of the scene.
            std::error_code unknown;
            if (undone.starts_with("not "))
                memory.failed({undone, std::filesystem::exists(session_.path(), unknown)
                                           ? ui::Failure::Remedy::none
                                           : ui::Failure::Remedy::save_as});
            else
                memory.notice = undone;
            memory.failures.exchanged(undone);
            keeper_.look_again();
        }
        Keeper::Served served = keeper_.serve(requests, *document(), shown, memory);
        if (!served.copied.empty()) window.set_clipboard(served.copied);
        if (requests.save_as) memory.save_as.folder = folder();
        if (!served.files.empty()) past_.add(std::move(served.what), std::move(served.files), session_);
        if (!served.saved_as.empty()) {
            past_.hand_on(session_, served.saved_as, view);
            saved_as_ = std::move(served.as);
            return std::move(served.saved_as);
        }
        saver_.serve(requests, *document(), shown, window, memory);
        serve_page(requests, view, memory);
    }
    const std::optional<std::string> other = opener_.serve(requests, session_.path(), memory);
    const std::string folder = std::filesystem::path(session_.path()).parent_path().string();
    memory.failures.rewrite([&](const std::string& text) { return near_names(text, folder); });
    return other;
}

void Workspace::serve_page(const ui::Requests& requests, const View& view, ui::Memory& memory) {
    ui::SaveAs& dialog = memory.save_page;
    if (std::string missing; requests.save_page && app::web_file("page.html", missing).empty()) {
        const std::size_t help = missing.find("\n   help: ");
        return memory.failed({fmt::format("no page can be saved: {}\nHelp: {}", missing.substr(0, help),
                                          missing.substr(missing.find(": ", help) + 2)),
                              ui::Failure::Remedy::page});
    }
    if (requests.save_page)
        ui::open_save_as(dialog, std::filesystem::path(session_.path()).stem().string() + ".html", folder());
    if (!requests.save_page_now) return;
    const std::string page = confirmed_page(*document(), dialog);
    if (page.empty()) return;
    dialog.error =
        pages_.busy() ? "another page is being saved" : pages_.start(page, page_arguments(*document(), view));
    if (!dialog.error.empty()) return;
    dialog.open = false;
    memory.failures.done(ui::Failure::Remedy::page);
    memory.notice = fmt::format("saving {}\u2026", dialog.existing);
}

}  // namespace snell
