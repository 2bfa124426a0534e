#include "src/app/window/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "parser/text/ranges.h"
#include "src/app/desktop/folder.h"
#include "src/app/open/warnings.h"
#include "src/content/files.h"
#include "src/lint/lint.h"

namespace snell {

namespace {

// Names files from the scene's folder, in all the texts of a finding.
Finding nearby(Finding finding, const std::string& folder) {
    finding.file = near_names(finding.file, folder);
    for (std::string* text : {&finding.message, &finding.also, &finding.help}) *text = near_names(*text, folder);
    for (Finding& note : finding.notes) note = nearby(std::move(note), folder);
    return finding;
}

TextState text_state(const Document& document) {
    TextState was{{}, setup_of(document.scene(), document.controls)};
    for (FileId file = 0; file < document.sources.size(); ++file)
        was.texts.insert_or_assign(std::string(document.sources.name(file)), std::string(document.sources.text(file)));
    return was;
}

std::string folder_of(const std::string& file) {
    const std::string folder = std::filesystem::path(file).parent_path().string();
    return folder.empty() ? "." : folder;
}

}  // namespace

Session::Session(std::string path, gl::Caps caps, Access access, FirstRungs first, Watcher progress,
                 const Recovery* recovery, Remembered memory)
    : path_(std::move(path)),
      caps_(std::move(caps)),
      access_(std::move(access)),
      given_(access_),
      first_(std::move(first)),
      progress_(std::move(progress)),
      memory_(std::move(memory)) {
    if (recovery)
        recover(*recovery);
    else
        reload();
}

std::unique_ptr<Document> Session::read(const std::string& path, const FirstRungs& choose) {
    Diagnostics refused;
    RuntimeOptions options;
    options.previous = shown_ ? &*shown_->runtime : nullptr;
    options.progress = progress_;
    const auto planned = [this](const Plan& plan, Document& document) {
        read_plan_ = plan;
        if (may_go_round(plan, document, caps_)) document.diagnostics.append(too_many_rounds(plan, document));
        document.diagnostics.append(misread_rungs(plan, document));
    };
    const auto chosen = [&](const Scene& scene, Rungs& rungs) { choose(scene, rungs, refused); };
    given_.remove_saved(access_);
    std::unique_ptr<Document> read = open_document(path, caps_, chosen, planned, options, access_);
    broken_ = read->diagnostics.has_errors();
    read->diagnostics.append(refused);
    return read;
}

void Session::choose(const Scene& scene, Rungs& rungs, Diagnostics& refused) {
    if (shown_) {
        recall(remembered(), scene, rungs);  // for ladders that were gone for a while
        carry_over(shown_->controls.rungs, shown_->scene(), rungs, scene);
        if (hold_values_) recall(held(), scene, rungs, Follow::memory);
    } else if (!by_hand_.empty()) {
        apply_setup(read_setup(by_hand_), scene, rungs);
    } else {
        choose_first(scene, rungs, refused);
    }
}

// The command line comes last, because it was given for this time.
void Session::choose_first(const Scene& scene, Rungs& rungs, Diagnostics& refused) {
    first_rungs_ = rungs;
    if (first_) first_(scene, first_rungs_, refused);
    if (!recovering_) recall(memory_, scene, rungs);
    Diagnostics heard;
    if (first_) first_(scene, rungs, heard);
}

void Session::reload() {
    if (path_.empty()) return;
    ++revision_;
    take(
        read(path_, [this](const Scene& scene, Rungs& rungs, Diagnostics& refused) { choose(scene, rungs, refused); }));
}

void Session::hold_values(const std::vector<SavedFile>& files) {
    // The scene may have been opened by another name of the same path since the file was saved.
    const auto in_use = [&](const SavedFile& file) {
        return ranges::any_of(files_, [&](const std::string& used) {
            std::error_code error;
            return used == file.path || std::filesystem::equivalent(used, file.path, error);
        });
    };
    for (const SavedFile& file : files)
        if (in_use(file)) held_[file.path] = content::whole_file(file.path);
    hold_values_ = !held_.empty();
    held_since_ = remembered(true).chosen;
}

Remembered Session::held() const {
    Remembered all = remembered(true);
    const bool own = ranges::all_of(held_, [](const auto& one) {
        const auto& [file, text] = one;
        std::error_code error;
        return std::filesystem::is_regular_file(file, error) && content::whole_file(file) == text;
    });
    std::erase_if(all.chosen, [&](const auto& setting) {
        const auto then = held_since_.find(setting.first);
        return !own && then != held_since_.end() && then->second == setting.second;
    });
    return all;
}

bool Session::awaits_own() const {
    if (!shown_ || held_.empty()) return false;
    for (std::size_t file = 0; file < shown_->sources.size(); ++file) {
        const std::string name(shown_->sources.name(file));
        std::error_code error;
        if (!std::filesystem::is_regular_file(name, error)) continue;  // a text of snell's own
        const auto held = held_.find(name);
        if (content::whole_file(name) != (held != held_.end() ? held->second : shown_->sources.text(file)))
            return false;
    }
    return true;
}

std::string Session::open(std::string path, Remembered memory) {
    std::swap(memory_, memory);
    const FirstRungs first = std::exchange(first_, nullptr);
    std::unique_ptr<Document> fresh = read(
        path, [this](const Scene& scene, Rungs& rungs, Diagnostics& refused) { choose_first(scene, rungs, refused); });
    if (!fresh->runtime) {
        memory_ = std::move(memory);
        first_ = first;
        const auto& problems = fresh->diagnostics.items();
        return problems.empty() ? "cannot read " + path : problems.front().message;
    }
    ++revision_;
    path_ = std::move(path);
    // Resources that both scenes have were taken over by read(); values must not be.
    shown_.reset();
    kept_ = nullptr;
    earlier_ = {};
    by_hand_.clear();
    recovering_ = hold_values_ = false;
    held_.clear();
    take(std::move(fresh));
    return {};
}

void Session::tell(const Diagnostic& diagnostic, const Sources& sources) {
    const Finding finding = describe(diagnostic, sources);
    printed_.push_back(render(finding));
    const std::string folder = std::filesystem::path(path_).parent_path().string();
    ui::Problem& problem = problems_.emplace_back(ui::Problem{nearby(finding, folder), {}});
    if (!finding.at) return;
    std::error_code error;
    const std::string name(sources.name(diagnostic.span.file));
    // A built-in text has a name but no file.
    if (std::filesystem::is_regular_file(name, error)) problem.place = {name, finding.at->line, finding.at->column};
}

void Session::drawn_well() {
    drawn_well_ = true;
    const Diagnostics costs = shown_->runtime->take_costs();
    for (const Diagnostic& cost : costs.items()) tell(cost, shown_->sources);
}

bool Session::lint() {
    if (!drawn_well_ || stale_ || std::exchange(linted_, true)) return false;
    plan_.rungs = shown_->controls.rungs;
    Sources sources = shown_->sources;  // a copy, because those of the document are compared with the next reading's
    const std::size_t before = problems_.size();
    const Diagnostics found = lint::check(plan_, sources, shader_includes(*shown_->files));
    for (const Diagnostic& diagnostic : found.items())
        if (ranges::count(printed_, render(diagnostic, sources)) == 0) tell(diagnostic, sources);
    return problems_.size() > before;
}

void Session::take(std::unique_ptr<Document> read) {
    problems_.clear();
    printed_.clear();
    for (const Diagnostic& diagnostic : read->diagnostics.items()) tell(diagnostic, read->sources);
    errors_ = file_errors_ = read->diagnostics.errors();
    file_problems_ = problems_.size();
    watch(*read);
    const bool shows = shown_ != nullptr;
    if (shows) read_rungs_ = shown_->controls.rungs;
    stale_ = shows && (!read->runtime || !no_new_errors(shown_->diagnostics, read->diagnostics));
    if (stale_ || !read->runtime) return;
    carry_values(*read);
    TextState before = shown_ ? text_state(*shown_) : TextState{}, now = text_state(*read);
    if (!shown_)
        earlier_.opened = std::move(now);
    else if (before.texts != now.texts)
        earlier_.before_edit = std::move(before);
    keep_shown();
    shown_ = std::move(read);
    read_rungs_ = good_rungs_ = shown_->controls.rungs;
    failed_rungs_.clear();
    plan_ = std::move(read_plan_);
    drawn_well_ = linted_ = false;
    if (shown_->scene().verbose) std::fputs(verbose_report(*shown_).c_str(), stderr);
}

void Session::carry_values(Document& read) {
    const Remembered all = hold_values_ ? held() : Remembered{};
    memory_ = remembered();
    if (!std::exchange(recovering_, false)) recall(memory_, read.scene(), read.controls);
    // A broken program has no controls for its values, so they are restored again until nothing is broken.
    if (!by_hand_.empty()) apply_setup(read_setup(by_hand_), read.scene(), read.controls);
    if (!read.diagnostics.has_errors()) by_hand_.clear();
    if (shown_) carry_over(shown_->controls, shown_->scene(), read.controls, read.scene());
    recall(all, read.scene(), read.controls, Follow::memory);
    followed_ = std::exchange(hold_values_, false) ? Follow::memory : Follow::text;
    held_.clear();
}

Remembered Session::remembered(bool all) const {
    Remembered memory = memory_;
    if (shown_) remember(shown_->scene(), shown_->controls, memory, all);
    return memory;
}

void Session::keep_shown() {
    if (!shown_ || !drawn_well_) return;
    drawn_well_ = false;
    shown_->runtime.reset();
    plan_.rungs = shown_->controls.rungs;
    kept_ =
        std::make_shared<const Kept>(Kept{std::move(plan_), std::move(shown_->sources), std::move(shown_->controls)});
}

std::shared_ptr<const Kept> Session::salvage() {
    keep_shown();
    shown_.reset();
    return kept_;
}

void Session::recover(const Recovery& recovery) {
    ++revision_;
    tell(recovery.problem, {});
    errors_ = file_errors_ = file_problems_ = 1;
    files_ = recovery.files;
    watch_.set_paths(recovery.files);
    by_hand_ = recovery.values;
    recovering_ = !recovery.kept;
    if (recovering_) return;
    const Kept& kept = *recovery.kept;
    RuntimeOptions options;
    options.progress = progress_;
    shown_ = compile_document(path_, kept.plan, kept.sources, kept.controls, caps_, access_, options);
    plan_ = kept.plan;
    good_rungs_ = shown_->controls.rungs;
    stale_ = true;
}

bool Session::follow_rungs() {
    if (!shown_ || shown_->controls.rungs == shown_->runtime->rungs()) return false;
    memory_ = remembered();
    if (!snell::follow_rungs(*shown_)) return false;
    recall(memory_, shown_->scene(), shown_->controls);  // values that only these rungs have
    ++revision_;
    const Diagnostics& found = shown_->runtime->ladder_problems();
    problems_.resize(file_problems_);
    printed_.resize(file_problems_);
    for (const Diagnostic& diagnostic : found.items()) tell(diagnostic, shown_->sources);
    errors_ = file_errors_ + found.errors();
    linted_ = false;
    failed_rungs_.clear();
    const Rungs& rungs = shown_->controls.rungs;
    if (!found.has_errors()) good_rungs_ = rungs;
    for (std::size_t i = 0; i < rungs.size(); ++i) {
        const Ladder& ladder = shown_->scene().ladders[i];
        if (rungs[i] != good_rungs_[i])
            failed_rungs_ +=
                fmt::format("{}{}={}", failed_rungs_.empty() ? "" : " ", ladder.name, ladder.rungs[rungs[i]]);
    }
    return true;
}

bool Session::outdated() const {
    // What has ended the last window is read again only when the user asks for it.
    return shown_ && !read_rungs_.empty() && (stale_ || shown_->diagnostics.has_errors()) &&
           shown_->controls.rungs != read_rungs_;
}

void Session::watch(const Document& read) {
    std::vector<std::string> paths = read.files->read_paths();
    // The shown document may use files that a broken edit no longer names; saving one of them must be noticed too.
    if (shown_) {
        const std::vector<std::string> more = shown_->files->read_paths();
        paths.insert(paths.end(), more.begin(), more.end());
    }
    paths.insert(paths.begin(), path_);
    files_.clear();
    for (const std::string& path : paths)
        if (std::find(files_.begin(), files_.end(), path) == files_.end()) files_.push_back(path);
    // A missing file that appears changes its folder.
    if (broken_) {
        std::vector<std::string> folders;
        std::transform(paths.begin(), paths.end(), std::back_inserter(folders), folder_of);
        paths.insert(paths.end(), folders.begin(), folders.end());
    }
    watch_.set_paths(std::move(paths));
}

std::string Session::problems_text() const {
    std::string text;
    for (const std::string& problem : printed_) text += problem;
    return text;
}

}  // namespace snell
