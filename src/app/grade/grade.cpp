#include "src/app/grade/grade.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <filesystem>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/grade/judge.h"
#include "src/app/open/ending.h"
#include "src/app/open/progress.h"
#include "src/content/files.h"
#include "src/content/image/module.h"
#include "src/content/workers.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

std::optional<Rubric> rubric_of(const std::string& path) {
    Sources sources;
    Diagnostics diagnostics;
    auto rubric = read_rubric(path, sources, diagnostics);
    diagnostics.sort();
    fmt::print(stderr, "{}", render(diagnostics, sources));
    return rubric;
}

// A name on a list that is misspelt would do nothing.
void warn_of_lists(const Rubric& rubric, const std::vector<Submission>& submissions) {
    for (const RubricItem& item : rubric.items)
        for (const RubricItem* part : item.parts())
            for (const std::string& name :
                 part->kind == RubricItem::Kind::except ? part->names : std::vector<std::string>())
                if (ranges::none_of(submissions,
                                    [&](const Submission& one) { return fits_pattern(one.name, name, true); }))
                    fmt::print(stderr, "snell: warning: 'except' names '{}', but there is no such submission\n",
                               utf8::printable(name));
}

// A line below [scenes] whose name is misspelt would do nothing.
void warn_of_scenes(const Rubric& rubric, const std::vector<Submission>& submissions) {
    std::vector<std::string_view> names;
    for (const Submission& submission : submissions) names.push_back(submission.name);
    for (const auto& [name, scene] : rubric.scenes) {
        if (ranges::find(names, std::string_view(name)) != names.end()) continue;
        const std::string_view near = nearest(name, names);
        fmt::print(stderr, "snell: warning: the rubric's [scenes] names '{}', but there is no such submission{}\n",
                   utf8::printable(name), near.empty() ? "" : fmt::format("\n   help: did you mean '{}'?", near));
    }
}

// Submissions and what they are judged with, and where the results go.
class Grading {
public:
    Grading(const GradeOptions& options, Grades& grades)
        : options_(options), grades_(grades), output_(fs::absolute(options.output).lexically_normal()) {}

    Exit run() {
        if (!ready()) return exit_input;
        const Interrupt noted;
        std::string asked = fmt::format("{} GB", gigabytes_);
        for (const LimitFacts& limit : limit_table()) asked += fmt::format(" {}", options_.limits.*limit.value);
        const std::string common = common_key(grades_.rubric, asked);
        if (!judge_reference(common)) return exit_graphics;
        std::vector<std::size_t> open;
        FolderHashes folders;
        for (std::size_t i = 0; i < grades_.all.size(); ++i) {
            GradedSubmission& graded = grades_.all[i];
            const std::string key = key_of(graded.submission, common, folders);
            graded.record = read_record(folder_of(graded.submission), grades_.rubric);
            graded.kept = !options_.again && !key.empty() && graded.record.key == key &&
                          has_pictures(folder_of(graded.submission), graded.record);
            graded.record.key = key;
            if (graded.kept) continue;
            if (graded.submission.problem.empty())
                open.push_back(i);
            else
                keep_problem(graded);
        }
        const bool graphics = judge_all(open);
        if (Interrupt::came()) end_interrupted(open.size());
        return graphics ? exit_fine : exit_graphics;
    }

private:
    std::string folder_of(const Submission& submission) const { return student_folder(output_.string(), submission); }

    [[noreturn]] void end_interrupted(std::size_t open) const {
        std::error_code error;
        fs::remove_all(output_ / ".unpacked", error);
        fmt::print(stderr,
                   "snell: interrupted: {} of {} submissions are judged and kept in '{}'; the same command judges the "
                   "rest{}\n",
                   grades_.all.size() - open + judged_, grades_.all.size(), utf8::printable(options_.output),
                   fs::exists(output_ / "index.html", error)
                       ? "; 'index.html', 'results.csv' and the other pages and tables in it are of an earlier run"
                       : "");
        Interrupt::end();
    }

    // In a line of the terminal; where there is none, in at most ten lines, and one if nothing was printed for long.
    void show_progress(std::size_t of) {
        using Clock = std::chrono::steady_clock;
        if (progress_.on_terminal())
            return progress_.show(fmt::format("judging: {} of {}", judged_, of),
                                  static_cast<double>(judged_) / static_cast<double>(of));
        const std::size_t part = of < 20 ? 0 : 10 * judged_ / of;
        if (options_.quiet || (part <= told_ && Clock::now() < next_)) return;
        told_ = part;
        next_ = Clock::now() + std::chrono::seconds(10);
        fmt::print(stderr, "snell: judged: {} of {} submissions\n", judged_, of);
    }

    // A limit of the shell's counts for all processes: what it leaves to a correct submission must be enough.
    bool ready() {
        constexpr double least = .7e9;
        const double limit = address_space();
        if (limit < least)
            return complain(
                fmt::format(
                    "the limit of address space ('ulimit -v') leaves {:.2g} GB, and an OpenGL driver alone may take {}",
                    limit / 1e9, least / 1e9),
                "nothing was judged");
        if (limit < (gigabytes_ > 0 ? gigabytes_ * 1e9 : std::numeric_limits<double>::infinity())) {
            gigabytes_ = limit / 1e9;
            fmt::print(stderr,
                       "snell: warning: the limit of address space ('ulimit -v') leaves {:.3g} GB to each submission, "
                       "less than --memory\n",
                       gigabytes_);
        }
        std::error_code error;
        fs::create_directories(output_, error);
        if (!error) grades_.lock = lock_folder(output_.string());
        if (!error && !grades_.lock)
            return complain(fmt::format("another run of 'snell grade' writes into '{}'", options_.output),
                            "wait until it has ended, or choose another folder");
        if (!error) fs::create_directories(output_ / "students", error);
        if (!error) fs::create_directories(output_ / "reference", error);
        return !error || complain(fmt::format("cannot make the folder '{}': {}", options_.output, error.message()));
    }

    // Whether the pictures that were made with a record are still there.
    bool has_pictures(const std::string& folder, const Record& record) const {
        std::vector<std::string> names = record.drawn;
        names.insert(names.end(), record.maps.begin(), record.maps.end());
        for (const RubricItem& item : grades_.rubric.items)
            for (const RubricItem* part : item.parts())
                if (part->judges(RubricItem::Kind::picture) && part->expect == Expect::reference &&
                    !record.maps[part->map].empty() && !record.submission.empty())
                    names.push_back(fmt::format("reference-{}.png", part->than));
        return ranges::all_of(names, [&](const std::string& name) {
            return name.empty() || content::is_whole(name, content::whole_file((fs::path(folder) / name).string()), {});
        });
    }

    // What a process has written so far does not count as judged, not even if this process is killed.
    static std::string unfinished(const std::string& key) { return "unfinished " + key; }

    // There is nothing to judge, but a row in the report.
    void keep_problem(GradedSubmission& graded) const {
        const std::string folder = folder_of(graded.submission), key = graded.record.key;
        std::error_code error;
        fs::create_directories(folder, error);
        remove_judged(folder);
        graded.record = unjudged(grades_.rubric, graded.submission.problem);
        graded.record.key = key;
        graded.record.submission = graded.submission.id;
        write_record(folder, graded.record);
    }

    ToJudge work_on(const std::string& key, const std::string& name, const std::string& path, const std::string& folder,
                    const std::string& reference) const {
        const auto& scenes = grades_.rubric.scenes;
        const auto named = scenes.find(name);
        return {&grades_.rubric,
                unfinished(key),
                name,
                named == scenes.end() ? "" : named->second,
                path,
                folder,
                (output_ / ".unpacked" / fs::path(folder).filename()).string(),
                reference,
                grades_.reference ? grades_.reference->milliseconds : 0,
                options_.limits};
    }

    // The whole time of a submission. The process itself keeps that of each step: it reads, draws each picture up to
    // three times (also for NaN, and over another background), measures a frame, and judges each item.
    double most_seconds() const {
        const Rubric& rubric = grades_.rubric;
        return rubric.timeout * static_cast<double>(3 * rubric.pictures.size() + 2 * rubric.items.size() + 3) + 10;
    }

    Apart apart(std::size_t jobs) const {
        return {jobs,
                {.seconds = most_seconds(),
                 .bytes = static_cast<std::uint64_t>(gigabytes_ * 1e9),
                 .most_output = 4096,
                 .captured = true},
                Interrupt::came};
    }

    bool judge_reference(const std::string& common) {
        if (grades_.rubric.reference.empty()) return true;
        const std::string folder = reference_folder(output_.string()), key = common + "-reference";
        grades_.reference = read_record(folder, grades_.rubric);
        if (grades_.reference->key == key && !options_.again && has_pictures(folder, *grades_.reference)) return true;
        remove_judged(folder);
        const ToJudge work = work_on(key, "", grades_.rubric.reference, folder, "");
        bool graphics = true;
        run_apart(
            1, apart(1), [&](std::size_t) { return judge(work); },
            [&](std::size_t, const EndedProcess& ended) {
                graphics = ended.status != exit_graphics;
                grades_.reference = result_of(ended, folder, key, "");
                if (!graphics) fmt::print(stderr, "{}", ended.output);
            });
        return graphics;
    }

    // What a process has left, and why it ended if it was not by itself.
    Record result_of(const EndedProcess& ended, const std::string& folder, const std::string& key,
                     const std::string& submission) const {
        Record record = read_record(folder, grades_.rubric);
        const std::string problem = why_ended(ended, grades_.rubric.timeout, gigabytes_);
        if (record.key != unfinished(key))
            record = unjudged(grades_.rubric, problem.empty() ? "there is no result" : problem);
        record.key = key;
        record.submission = submission;
        if (!problem.empty()) record.problem = problem;
        if (ended.too_long || ended.status == exit_timeout) count_as_unread(record, problem);
        if (ended.again && ended.signal == 0)
            record.notes.push_back("the program that draws it ended by a signal once; the second time it did not");
        write_record(folder, record);
        return record;
    }

    // What was judged before pictures were drawn. A shader that does not end earns no more than one with an error.
    void count_as_unread(Record& record, const std::string& problem) const {
        const auto& items = grades_.rubric.items;
        for (std::size_t i = 0; i < items.size(); ++i)
            for (const RubricItem::Kind kind :
                 {RubricItem::Kind::no_errors, RubricItem::Kind::no_lints, RubricItem::Kind::uniforms})
                if (items[i].judges(kind))
                    record.items[i] = {items[i].deducts ? -items[i].points : 0, false,
                                       "its shaders count as unread: " + problem};
    }

    bool judge_all(const std::vector<std::size_t>& open) {
        if (open.empty()) return true;
        bool graphics = true;
        run_apart(
            open.size(), apart(options_.jobs > 0 ? options_.jobs : content::cores()),
            [&](std::size_t k) {
                const GradedSubmission& graded = grades_.all[open[k]];
                const std::string folder = folder_of(graded.submission);
                std::error_code error;
                fs::create_directories(folder, error);
                remove_judged(folder);  // pictures of an earlier run are not taken for new ones
                const ToJudge work = work_on(graded.record.key, graded.submission.name, graded.submission.path, folder,
                                             grades_.reference ? reference_folder(output_.string()) : "");
                fs::remove_all(work.unpacked, error);  // of a process or run that was killed
                return judge(work);
            },
            [&](std::size_t k, const EndedProcess& ended) {
                GradedSubmission& graded = grades_.all[open[k]];
                const std::string folder = folder_of(graded.submission);
                graphics = graphics && ended.status != exit_graphics;
                graded.record = result_of(ended, folder, graded.record.key, graded.submission.id);
                std::error_code error;
                fs::remove_all(output_ / ".unpacked" / fs::path(folder).filename(), error);
                ++judged_;
                show_progress(open.size());
            });
        progress_.clear();
        std::error_code error;
        fs::remove(output_ / ".unpacked", error);
        return graphics || complain("no graphics: nothing can be drawn");
    }

    const GradeOptions& options_;
    double gigabytes_ = options_.gigabytes;  // of memory for a submission; 0: no limit
    Grades& grades_;
    fs::path output_;
    ProgressLine progress_;
    std::size_t judged_ = 0;  // submissions of this run
    std::size_t told_ = 0;    // tenths of them that were printed
    std::chrono::steady_clock::time_point next_ = std::chrono::steady_clock::now() + std::chrono::seconds(10);
};

}  // namespace

Limits limits_of_submissions() {
    Limits limits;
    limits.file_bytes = 64u << 20;
    limits.texture_bytes = 512u << 20;
    limits.texture_side = 8192;
    limits.vertices = 5'000'000;
    limits.diagnostics = 200;
    return limits;
}

std::string student_folder(const std::string& output, const Submission& submission) {
    return (fs::path(output) / "students" / submission.folder).string();
}

std::string reference_folder(const std::string& output) { return (fs::path(output) / "reference").string(); }

Exit grade(const GradeOptions& options, Grades& grades) {
    auto rubric = rubric_of(options.rubric);
    if (!rubric) return exit_input;
    grades.rubric = std::move(*rubric);
    auto found = find_submissions(options.submissions, options.output, grades.rubric);
    if (!found) return exit_usage;
    warn_of_lists(grades.rubric, found->all);
    warn_of_scenes(grades.rubric, found->all);
    for (const Submission& submission : found->all) grades.all.push_back({submission, {}, false});
    grades.left_out = std::move(found->left_out);
    return Grading(options, grades).run();
}

namespace {

struct Running {
    std::size_t index = 0;
    bool again = false;
    content::Process process;
};

// It writes no endless file, and draws on one core, because there is a process for each.
void settle_in() {
    const rlimit file{rlim_t{512} << 20, rlim_t{512} << 20}, core{0, 0};
    setrlimit(RLIMIT_FSIZE, &file);
    setrlimit(RLIMIT_CORE, &core);
    setenv("LP_NUM_THREADS", "0", 0);
}

// The first line of what it printed about itself.
std::string said(const EndedProcess& ended) {
    const std::size_t at = ended.output.find("snell: error: ");
    if (at == std::string::npos) return {};
    const std::string_view line = std::string_view(ended.output).substr(at + 14);
    return fmt::format(": {}", utf8::printable(line.substr(0, line.find('\n'))));
}

// What a submission prints may contain the mark, too: only a process that ends for want of memory has this status.
bool lacked_memory(const EndedProcess& ended) {
    return ended.status == exit_input && ended.output.find("[out-of-memory]") != std::string::npos;
}

}  // namespace

void run_apart(std::size_t count, const Apart& how, const std::function<int(std::size_t)>& work,
               const std::function<void(std::size_t, const EndedProcess&)>& done) {
    std::deque<std::pair<std::size_t, bool>> waiting;
    for (std::size_t i = 0; i < count; ++i) waiting.emplace_back(i, false);
    std::vector<Running> running;
    while (!waiting.empty() || !running.empty()) {
        if (how.stop && how.stop()) return;
        while (!waiting.empty() && running.size() < std::max<std::size_t>(how.at_once, 1)) {
            const auto [index, again] = waiting.front();
            waiting.pop_front();
            running.push_back({index, again, {}});
            const auto alone = [&work, k = index](std::string&) {
                settle_in();
                return status_of([&] { return work(k); });
            };
            content::open_image_module_as_copies_do();
            if (running.back().process.start(alone, how.limits).empty()) continue;
            running.pop_back();
            done(index, {});  // no process could be made
        }
        std::erase_if(running, [&](Running& one) {
            auto ended = one.process.poll();
            if (!ended) return false;
            if (ended->signal != 0 && !ended->too_long && !one.again)
                waiting.emplace_back(one.index, true);
            else
                done(one.index, {std::move(*ended), one.again});
            return true;
        });
        if (!running.empty()) usleep(2000);
    }
}

std::string why_ended(const EndedProcess& ended, double timeout, double gigabytes) {
    if (ended.too_long || ended.status == exit_timeout)
        return fmt::format("it takes longer than {} seconds{}", timeout, said(ended));
    if (lacked_memory(ended))
        return gigabytes > 0 ? fmt::format("it takes more than {:.3g} GB of memory", gigabytes)
                             : "it takes more memory than there is";
    if (ended.signal != 0) {
        // Drivers abort where they get no memory.
        const std::string limit =
            ended.signal == SIGABRT && gigabytes > 0
                ? fmt::format("; the cause may be the limit of {:.3g} GB of memory, which --memory changes", gigabytes)
                : "";
        return fmt::format("it ends the program that draws it, twice, by signal {} ({}){}", ended.signal,
                           strsignal(ended.signal), limit);
    }
    return ended.status == exit_fine ? "" : fmt::format("it ends the program that draws it{}", said(ended));
}

}  // namespace snell::app
