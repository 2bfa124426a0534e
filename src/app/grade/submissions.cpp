#include "src/app/grade/submissions.h"

#include <fmt/format.h>
#include <zlib.h>

#include <cstdio>
#include <filesystem>
#include <map>
#include <set>

#include "parser/text/ranges.h"
#include "parser/text/tidy.h"
#include "parser/text/utf8.h"
#include "parser/text/words.h"
#include "src/app/grade/find_scene.h"
#include "src/app/grade/report_folder.h"
#include "src/app/grade/unpack.h"
#include "src/app/open/complain.h"
#include "src/app/open/version.h"
#include "src/app/picture/sha256.h"
#include "src/content/load_module.h"
#include "src/content/regular_file.h"
#include "src/content/walk.h"
#include "src/content/whole_file.h"
#include "src/document/document.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& path) { return has_extension(path.native(), "glib"); }

bool may_be_submission(const fs::path& path) {
    std::error_code error;
    const std::string name = path.filename().string();
    if (name.starts_with('.') || name == "__MACOSX") return false;
    return fs::is_directory(path, error) ||
           (fs::is_regular_file(path, error) && (is_scene(path) || is_archive(path.string())));
}

bool holds_work(const fs::path& path, const Rubric& rubric) {
    std::error_code error;
    if (!fs::is_directory(path, error)) return is_archive(path.string());
    const FoundScene found = find_scene(path.string(), rubric.scene, {});
    return !found.scene.empty() || !found.archives.empty() || found.several;
}

// What a folder holds if it is not a submission itself. Where scenes are next to folders, the choice is not certain,
// so it is printed.
std::vector<fs::path> submissions_of(const fs::path& folder, const Rubric& rubric) {
    std::error_code error;
    std::vector<fs::path> scenes, others, working;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (may_be_submission(entry->path()))
            (is_scene(entry->path()) && !fs::is_directory(entry->path(), error) ? scenes : others)
                .push_back(entry->path());
    if (scenes.empty()) return others;
    for (const fs::path& other : others)
        if (holds_work(other, rubric)) working.push_back(other);
    const std::string preferred = fs::path(rubric.reference).filename().string();
    if (working.empty() && !find_scene(folder.string(), rubric.scene, preferred).scene.empty()) return {folder};
    fmt::print(stderr,
               "snell: warning: '{}' holds {} scene{} and {} folders or archives with scenes: each is a submission "
               "[several-submissions]\n   help: to grade one scene with the files next to it, name the scene\n",
               utf8::printable(folder.string()), scenes.size(), scenes.size() == 1 ? "" : "s", working.size());
    working.insert(working.end(), scenes.begin(), scenes.end());
    return working;
}

std::string shown_name(const fs::path& path) {
    std::error_code error;
    const fs::path last = path.has_filename() ? path.filename() : path.parent_path().filename();
    if (fs::is_directory(path, error)) return utf8::printable(last.string());
    const bool tar = is_archive(path.string()) && same_word(last.stem().extension().string(), ".tar");
    return utf8::printable((tar ? last.stem() : last).stem().string());
}

// Letters, digits and some signs, so that it is a name on every file system and in every address.
std::string safe_name(const std::string& name) {
    std::string safe;
    for (const char c : name) {
        const bool plain = (lower(c) >= 'a' && lower(c) <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '.';
        if (plain)
            safe += c;
        else if (!safe.ends_with('_'))
            safe += '_';
        if (safe.size() >= 80) break;
    }
    while (safe.starts_with('.')) safe.erase(0, 1);
    return safe.empty() ? "_" : safe;
}

// Of names that are equal, each gets its id. A folder of an earlier run keeps its name: another submission more or less
// does not change it. Names that differ only in case would be one folder on some systems.
void name_folders(std::vector<Submission>& submissions, const fs::path& students) {
    std::map<std::string, std::size_t> names;
    for (const Submission& submission : submissions) ++names[lowered(safe_name(submission.name))];
    for (Submission& submission : submissions) {
        submission.folder = safe_name(submission.name);
        const std::string longer = submission.folder + "-" + submission.id;
        const bool several = names[lowered(submission.folder)] > 1 &&
                             submission_in((students / submission.folder).string()) != submission.id;
        if (several || submission.folder != submission.name ||
            submission_in((students / longer).string()) == submission.id)
            submission.folder = longer;
    }
}

// Adds the names and hashes of all files below a folder, or of a file.
void add_files(const fs::path& path, std::string& all) {
    constexpr std::uint64_t most = std::uint64_t{1} << 30;
    std::error_code error;
    std::vector<std::string> files;
    if (!fs::is_directory(path, error)) files.push_back(path.string());
    content::walk(path, [&files](const fs::path& entry, fs::file_status status, int) {
        if (fs::is_regular_file(status)) files.push_back(entry.string());
        return content::Walk::on;
    });
    ranges::sort(files);
    for (const std::string& file : files) {
        std::string wrong;
        const auto bytes = content::read_regular_file(file, most, nullptr, wrong);
        // Of larger files the size and the time of the last change stand for the bytes.
        const std::string hash = bytes ? sha256(*bytes)
                                       : fmt::format("{} {}", fs::file_size(file, error),
                                                     fs::last_write_time(file, error).time_since_epoch().count());
        all += fs::path(file).lexically_relative(path).string() + '\0' + hash + '\0';
    }
}

// Tells this program and the modules that read submissions from those that were built again.
std::string build_of_program() {
    std::string build;
    for (const std::string& file : {std::string("/proc/self/exe"), content::module_path("snell_oiio.so"),
                                    content::module_path("snell_archive.so")}) {
        const std::string program = content::whole_file(file);
        const auto* bytes = reinterpret_cast<const Bytef*>(program.data());
        build += fmt::format("{}-{:x} ", program.size(), crc32_z(0, bytes, program.size()));
    }
    return build;
}

}  // namespace

std::optional<std::vector<Submission>> find_submissions(const std::vector<std::string>& arguments,
                                                        const std::string& output, const Rubric& rubric) {
    std::vector<fs::path> paths;
    std::error_code error;
    for (const std::string& argument : arguments) {
        if (!fs::exists(argument, error)) {
            complain(fmt::format("there is no submission '{}'", argument));
            return std::nullopt;
        }
        paths.emplace_back(argument);
    }
    if (paths.size() == 1 && fs::is_directory(paths.front(), error)) paths = submissions_of(paths.front(), rubric);
    std::vector<Submission> submissions;
    const fs::path report = fs::weakly_canonical(fs::absolute(output, error), error);
    for (const fs::path& path : paths) {
        const fs::path absolute = fs::weakly_canonical(fs::absolute(path, error), error);
        if (absolute == report) continue;
        submissions.push_back({absolute.string(), shown_name(path), {}, sha256(absolute.string()).substr(0, 6)});
    }
    if (submissions.empty()) {
        complain("there is nothing to grade", "name folders, archives or scenes, or one folder that holds them");
        return std::nullopt;
    }
    std::sort(submissions.begin(), submissions.end(), [](const Submission& a, const Submission& b) {
        return std::tie(a.name, a.path) < std::tie(b.name, b.path);
    });
    std::set<std::string> known;  // one that is named twice, or by a link, too, is one
    std::erase_if(submissions, [&known](const Submission& one) { return !known.insert(one.path).second; });
    name_folders(submissions, report / "students");
    return submissions;
}

std::string key_of(const Submission& submission, const std::string& rest) {
    std::string all = rest;
    const fs::path path = submission.path;
    if (is_scene(path)) all += path.filename().string() + '\0';
    add_files(is_scene(path) && fs::is_regular_file(path) ? path.parent_path() : path, all);
    return sha256(all);
}

std::string common_key(const Rubric& rubric, const std::string& limits) {
    std::string all = fmt::format("{} {} {}", version(), build_of_program(), limits) + '\0' + rubric.text + '\0';
    if (!rubric.reference.empty())
        for (const std::string& file : files_read_by(rubric.reference, {})) add_files(file, all);
    for (const std::string& path : rubric.shared) add_files(path, all);
    return sha256(all);
}

}  // namespace snell::app
