// Damaged scenes and shaders, drawn by processes of their own: each ends by itself, in time, as it is documented.
//
//   SNELL_TORTURE_MUTANTS   how many (14)
//   SNELL_TORTURE_FIRST     the number of the first (0)
//   SNELL_TORTURE_SEED      of the series (9)
//   SNELL_TORTURE_JOBS      at a time (1)
//   SNELL_TORTURE_OUT       a folder that exists, for the list of all and the files of what failed
//   SNELL_TORTURE_PROGRAM   another build of snell
#include "src/content/image/image.h"
#include "src/platform/headless.h"
#include "tests/scratch.h"
#include "tests/std.h"
#include "tests/torture/campaign/campaign.h"
#include "tests/torture/child.h"
#include "tests/torture/tree.h"

namespace snell::torture {
namespace {

namespace fs = std::filesystem;

struct Campaign {
    unsigned count = number_of("SNELL_TORTURE_MUTANTS", 14), first = number_of("SNELL_TORTURE_FIRST", 0),
             seed = number_of("SNELL_TORTURE_SEED", 9), jobs = number_of("SNELL_TORTURE_JOBS", 1);
    std::string out = setting("SNELL_TORTURE_OUT", "");
    std::string program = setting("SNELL_TORTURE_PROGRAM", SNELL_BIN "/snell");
};

// One that lies whole where it should, and can be read.
std::string wrong_with_picture(const std::string& file) {
    const std::string bytes = bytes_of(file);
    const content::ImageResult read = content::decode_image(file, bytes);
    if (read.image && read.image->width > 0 && read.image->height > 0) return {};
    return "the picture can't be read: " + (read.issues.empty() ? "" : read.issues.front().message);
}

std::size_t entries(const fs::path& folder) {
    return static_cast<std::size_t>(
        std::distance(fs::recursive_directory_iterator(folder), fs::recursive_directory_iterator()));
}

// "" or what is not as documented.
std::string judge(const End& end, const std::string& picture) {
    if (end.too_large) return "took more than 4 GB";
    if (end.too_long) return "did not end";
    if (end.signal) return "ended by signal " + std::to_string(end.signal);
    if (end.status != 0 && end.status != 1 && end.status != 4)
        return "status " + std::to_string(end.status) + " is not for what a scene does";
    if (const std::string unfit = unfit_for_terminals(end.errors); !unfit.empty()) return "prints " + unfit;
    // What has no place in a file begins with it.
    const bool error =
        ("\n" + end.errors).find("\nerror: ") != std::string::npos || end.errors.find(": error: ") != std::string::npos;
    if (error != (end.status != 0)) return "status " + std::to_string(end.status) + " does not fit what it says";
    const bool there = fs::exists(picture);
    if (end.status == 0 && !there) return "no picture";
    if (there)
        if (const std::string wrong = wrong_with_picture(picture); !wrong.empty()) return wrong;
    if (entries(fs::path(picture).parent_path()) != (there ? 1U : 0U)) return "files are left behind";
    return {};
}

// What all have taken together.
struct Totals {
    std::map<std::string, unsigned> ends;
    double seconds = 0, processor = 0, gigabytes = 0;
    unsigned slowest = 0, dearest = 0, largest = 0;
    std::string list;

    void add(unsigned number, const Mutant& mutant, const End& end, const std::string& wrong) {
        ++ends[end.signal ? "signal " + std::to_string(end.signal) : "status " + std::to_string(end.status)];
        if (end.seconds > seconds) seconds = end.seconds, slowest = number;
        if (end.processor > processor) processor = end.processor, dearest = number;
        if (end.gigabytes > gigabytes) gigabytes = end.gigabytes, largest = number;
        char numbers[100];
        std::snprintf(numbers, sizeof numbers, "%u status %d signal %d %.2f s (%.2f s) %.3f GB ", number, end.status,
                      end.signal, end.seconds, end.processor, end.gigabytes);
        list += numbers + mutant.scene + (wrong.empty() ? "" : " [" + wrong + "]") + " {" + mutant.how + "}\n";
    }
    void print() const {
        for (const auto& [end, count] : ends) std::printf("%s: %u\n", end.c_str(), count);
        std::printf(
            "longest: %.1f s (number %u); most processor time: %.1f s (number %u); largest: %.2f GB (number %u)\n",
            seconds, slowest, processor, dearest, gigabytes, largest);
    }
};

// A tree of its own, in which one mutant after the other stands.
class Stand {
public:
    Stand() {
        copy_tree(SNELL_ROOT, folder_.path("tree"));
        tree_ = read_tree(folder_.path("tree"));
        fs::create_directory(folder_.path("out"));
        files_ = entries(folder_.path("tree"));
    }

    Mutant mutant(const Campaign& campaign, unsigned number) const {
        return make_mutant(tree_, at(""), campaign.seed, number);
    }

    std::string try_out(const Campaign& campaign, const Mutant& mutant, End& end) {
        std::vector<std::string> before;
        for (const Change& change : mutant.changes) {
            before.push_back(bytes_of(at(change.file)));
            write_file(at(change.file), change.text);
        }
        const std::string picture = folder_.path("out/" + mutant.output);
        std::vector<std::string> words{campaign.program, "render", mutant.scene, "-o", picture};
        words.insert(words.end(), mutant.options.begin(), mutant.options.end());
        // Each of starting, reading and drawing has its time.
        end = run_child(words, at(""), folder_.path("errors"), {.seconds = 4 * mutant.timeout + 30});
        std::string wrong = judge(end, picture);
        if (wrong.empty() && entries(at("")) != files_) wrong = "files are written where none were asked for";
        for (std::size_t i = 0; i < before.size(); ++i) write_file(at(mutant.changes[i].file), before[i]);
        for (const auto& left : fs::directory_iterator(folder_.path("out"))) fs::remove_all(left.path());
        return wrong;
    }

private:
    std::string at(const std::string& file) const { return folder_.path("tree/" + file); }

    Scratch folder_;
    Tree tree_;
    std::size_t files_ = 0;
};

std::string command(const Campaign& campaign, const Mutant& mutant, unsigned number) {
    std::string text = "\n  in a copy of the tree: snell render " + mutant.scene + " -o " + mutant.output;
    for (const std::string& option : mutant.options) text += " " + option;
    return text + "\n  again: SNELL_TORTURE_SEED=" + std::to_string(campaign.seed) +
           " SNELL_TORTURE_FIRST=" + std::to_string(number) +
           " SNELL_TORTURE_MUTANTS=1 SNELL_TORTURE_OUT=FOLDER torture_tests --gtest_filter='Mutants.*'\n";
}

TEST(Mutants, EndAsDocumented) {
    std::string error;
    if (!HeadlessContext::make({}, error)) GTEST_SKIP() << "no graphics: " << error;
    const Campaign campaign;
    std::atomic<unsigned> next = 0;
    std::mutex mutex;
    Totals totals;
    const auto work = [&] {
        Stand stand;
        for (unsigned i; (i = next++) < campaign.count;) {
            const unsigned number = campaign.first + i;
            const Mutant mutant = stand.mutant(campaign, number);
            End end;
            const std::string wrong = stand.try_out(campaign, mutant, end);
            const std::lock_guard lock(mutex);
            totals.add(number, mutant, end, wrong);
            if (!wrong.empty())
                ADD_FAILURE() << "mutant " << number << " (" << mutant.how << "): " << wrong
                              << command(campaign, mutant, number) << end.errors.substr(0, 3000);
            if (campaign.out.empty() || (wrong.empty() && campaign.count > 1)) continue;
            for (const Change& change : mutant.changes) {
                const fs::path kept = fs::path(campaign.out) / std::to_string(number) / change.file;
                fs::create_directories(kept.parent_path());
                write_file(kept, change.text);
            }
        }
    };
    std::vector<std::thread> workers;
    for (unsigned i = 0; i < campaign.jobs; ++i) workers.emplace_back(work);
    for (std::thread& worker : workers) worker.join();
    totals.print();
    if (!campaign.out.empty()) write_file(campaign.out + "/mutants.txt", totals.list);
    EXPECT_GT(totals.ends["status 0"], 0U) << "all were refused: nothing was drawn";
    EXPECT_TRUE(totals.ends["status 1"] > 0 || campaign.count == 1) << "none was refused: nothing was damaged";
}

// The same everywhere: a number is enough to tell of one.
TEST(Mutants, AreMadeByTheirNumbers) {
    const Scratch folder;
    copy_tree(SNELL_ROOT, folder.path("tree"));
    const Tree tree = read_tree(folder.path("tree"));
    for (const auto& kind : tree.kinds) EXPECT_GT(kind.size(), 10U);
    unsigned changed = 0;
    for (unsigned number = 0; number < 60; ++number) {
        const Mutant one = make_mutant(tree, folder.path("tree"), 9, number),
                     other = make_mutant(tree, folder.path("tree"), 9, number);
        EXPECT_EQ(one.how, other.how);
        EXPECT_EQ(one.options, other.options);
        ASSERT_EQ(one.changes.size(), other.changes.size());
        for (std::size_t i = 0; i < one.changes.size(); ++i) {
            EXPECT_EQ(one.changes[i].text, other.changes[i].text);
            changed += one.changes[i].text != bytes_of(folder.path("tree/" + one.changes[i].file)) ? 1U : 0U;
        }
    }
    EXPECT_GT(changed, 45U);
}

TEST(Children, AreWatched) {
    const Scratch folder;
    const auto shell = [&](const std::string& command, const Bounds& bounds) {
        return run_child({"/bin/sh", "-c", command}, folder.path(), folder.path("errors"), bounds);
    };
    const End fine = shell("echo here: $PWD $DISPLAY >&2; exit 7", {});
    EXPECT_EQ(fine.status, 7);
    EXPECT_EQ(fine.errors, "here: " + folder.path() + "\n");
    EXPECT_EQ(shell("kill -SEGV $$", {}).signal, SIGSEGV);
    const End endless = shell("exec sleep 60", {.seconds = .2});
    EXPECT_TRUE(endless.too_long);
    EXPECT_LT(endless.seconds, 5);
    const End large = shell("a=0123456789; while :; do a=$a$a; done", {.gigabytes = .05});
    EXPECT_TRUE(large.too_large);
    EXPECT_EQ(unfit_for_terminals("a \\x1B\n\u00e9"), "");
    for (const char* text : {"\x1b[m", "\r", "\xff", "\u202e", "\u009b", "\x7f"})
        EXPECT_NE(unfit_for_terminals(text), "") << text;
}

}  // namespace
}  // namespace snell::torture
