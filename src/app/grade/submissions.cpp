#include "src/app/grade/submissions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include <fmt/format.h>
#include <zlib.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/grade/record.h"
#include "src/app/open/complain.h"
#include "src/app/open/version.h"
#include "src/content/files.h"
#include "src/content/html_page.h"
#include "src/content/load_module.h"
#include "src/document/document.h"
#include "src/plan/locate.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

bool is_scene(const fs::path& path) { return has_extension(path.native(), "glib"); }

// What a scene may read, and what explains it: such a file next to the only scene belongs to it.
bool goes_with_scenes(const fs::path& path) {
    constexpr std::array others{"obj", "mtl", "shp", "shx", "dbf", "inc", "txt", "md"};
    const std::string name = path.filename().string();
    const auto ends = [&name](std::string_view extension) { return has_extension(name, extension); };
    return is_shader_name(name) || ranges::any_of(image_extensions(), ends) || ranges::any_of(others, ends) ||
           !path.has_extension();
}

// True if the text has the name of the file, or of the folder with a file in it, and not as a part of a longer one.
// Both are in lower case.
bool mentions(std::string_view text, std::string_view name, bool folder) {
    const auto of_a_name = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-'; };
    for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
        const char next = at + name.size() < text.size() ? text[at + name.size()] : ' ';
        if ((at == 0 || !of_a_name(text[at - 1])) && (folder ? next == '/' || next == '\\' : !of_a_name(next)))
            return true;
    }
    return false;
}

// A scene or an archive is somebody's work.
bool holds_work(const fs::path& folder) {
    const FoundScene found = find_scene({folder.string()}, {});
    return !found.scene.empty() || !found.several.empty() || !found.archives.empty();
}

// What grading made, and nobody has put work into.
bool is_only_a_report(const fs::path& folder) { return is_report(folder.string()) && !holds_work(folder); }

// What is in a folder next to its scenes.
class Neighbours {
public:
    Neighbours(const fs::path& folder, const Rubric& rubric, const fs::path& report) {
        std::error_code error;
        std::set<fs::path> own{fs::weakly_canonical(rubric.path, error)};
        own.insert(rubric.shared.begin(), rubric.shared.end());
        own.insert(rubric.templates.begin(), rubric.templates.end());
        std::vector<fs::path> paths;
        for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
            paths.push_back(entry->path());
        ranges::sort(paths);
        for (const fs::path& path : paths) {
            const bool file = fs::is_regular_file(fs::symlink_status(path, error));
            const fs::path place = fs::weakly_canonical(path, error);
            if (place == report) continue;
            if (own.contains(place))
                leave_out(path, "named by the rubric");
            else if (is_hidden(path.filename().string()))
                leave_out(path, "hidden, or of the system");
            else if (is_only_a_report(path))
                leave_out(path, "a report");
            else
                (is_scene(path) && file ? scenes : others).push_back(path);
        }
        find_parts();
    }

    std::vector<fs::path> scenes, others;
    std::vector<std::string> left_out;

    // Whether everything belongs to one scene.
    bool one_submission() const {
        return scenes.size() == 1 && ranges::all_of(others, [](const fs::path& path) {
                   std::error_code error;
                   return goes_with_scenes(path) && fs::is_regular_file(fs::symlink_status(path, error));
               });
    }

private:
    void leave_out(const fs::path& path, std::string_view why) {
        left_out.push_back(fmt::format("'{}' ({})", utf8::printable(path.filename().string()), why));
    }

    // Files and folders that a scene names, or a shader that a scene names, are theirs.
    void find_parts() {
        constexpr std::uint64_t most = 1 << 20;
        std::vector<fs::path> texts = scenes;
        for (std::size_t i = 0; i < texts.size(); ++i) {
            std::string wrong;
            const std::string text =
                lowered(content::read_regular_file(texts[i].string(), most, nullptr, wrong).value_or(""));
            std::erase_if(others, [&](const fs::path& path) {
                std::error_code error;
                const fs::file_status status = fs::symlink_status(path, error);
                const std::string name = lowered(path.filename().string());
                const bool is_folder = fs::is_directory(status);
                if (!mentions(text, name, is_folder) || (is_folder && holds_work(path))) return false;
                if (!is_folder && (!fs::is_regular_file(status) || is_archive(name))) return false;
                if (is_shader_name(name)) texts.push_back(path);
                leave_out(path, fmt::format("named by '{}'", utf8::printable(texts[i].filename().string())));
                return true;
            });
        }
    }
};

// Why an entry cannot be judged, as far as it is known without reading it; or "". `known`: submissions by their paths.
std::string problem_of(const fs::path& path, const std::map<std::string, std::string>& known) {
    std::error_code error;
    if (fs::is_symlink(path, error)) {
        const std::string target = utf8::printable(fs::read_symlink(path, error).string());
        const auto same = known.find(fs::weakly_canonical(path, error).string());
        if (same != known.end())
            return fmt::format("it is a link to '{}', which is judged as '{}'", target, same->second);
        if (!fs::exists(path, error)) return fmt::format("it is a link to '{}', which is not there", target);
    }
    if (fs::is_directory(path, error)) {
        const std::string why = unusable(path.string());
        return why.empty() ? "" : "it " + why;
    }
    if (!fs::is_regular_file(path, error) || !(is_scene(path) || is_archive(path.string())))
        return "it is neither a folder, nor an archive, nor a scene (.glib)";
    return fs::file_size(path, error) == 0 && !error ? "it is an empty file" : "";
}

std::string shown_name(const fs::path& path) {
    std::error_code error;
    const fs::path last = path.has_filename() ? path.filename() : path.parent_path().filename();
    if (fs::is_directory(path, error) || !(is_scene(last) || is_archive(path.string())))
        return utf8::printable(last.string());
    const bool tar = is_archive(path.string()) && same_word(last.stem().extension().string(), ".tar");
    return utf8::printable((tar ? last.stem() : last).stem().string());
}

// Names of folders, archives and scenes that are equal get their endings; those that are only printed alike, their ids.
// What has one name in several folders keeps it: another of that name renames nobody.
void name_apart(std::vector<Submission>& submissions) {
    const auto file_of = [](const Submission& submission) { return fs::path(submission.path).filename().string(); };
    std::map<std::string, std::size_t> names;
    for (const Submission& submission : submissions) ++names[submission.name];
    for (Submission& submission : submissions)
        if (names[submission.name] > 1) submission.name = utf8::printable(file_of(submission));
    std::map<std::string, std::set<std::string>> files;
    for (const Submission& submission : submissions) files[submission.name].insert(file_of(submission));
    for (Submission& submission : submissions)
        if (files[submission.name].size() > 1) submission.name += " (" + submission.id + ")";
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
        return fs::is_directory(status) && is_only_a_report(entry) ? content::Walk::past : content::Walk::on;
    });
    ranges::sort(files);
    for (const std::string& file : files) {
        std::string wrong;
        const auto bytes = content::read_regular_file(file, most, nullptr, wrong);
        // Of larger files the size and the time of the last change stand for the bytes.
        const std::string hash = bytes ? content::sha256(*bytes)
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
        std::ifstream program(file, std::ios::binary);
        std::array<char, 1 << 16> part{};
        std::size_t size = 0;
        uLong sum = 0;
        while (program.read(part.data(), part.size()), program.gcount() > 0) {
            const auto more = static_cast<std::size_t>(program.gcount());
            sum = crc32_z(sum, reinterpret_cast<const Bytef*>(part.data()), more);
            size += more;
        }
        build += fmt::format("{}-{:x} ", size, sum);
    }
    return build;
}

}  // namespace

std::optional<Submissions> find_submissions(const std::vector<std::string>& arguments, const std::string& output,
                                            const Rubric& rubric) {
    std::error_code error;
    const fs::path report = fs::weakly_canonical(fs::absolute(output, error), error);
    std::set<fs::path> paths;  // by the names that were given, without what is before them: one named twice is one
    for (const std::string& argument : arguments) {
        if (!fs::exists(fs::symlink_status(argument, error))) {
            complain(fmt::format("there is no submission '{}'", argument));
            return std::nullopt;
        }
        fs::path path = fs::absolute(argument, error).lexically_normal();
        if (!path.has_filename()) path = path.parent_path();
        paths.insert(fs::weakly_canonical(path.parent_path(), error) / path.filename());
    }
    Submissions found;
    if (arguments.size() == 1 && fs::is_directory(arguments.front(), error)) {
        const fs::path folder = fs::weakly_canonical(*paths.begin(), error);
        Neighbours inside(folder, rubric, report);
        if (!inside.one_submission() && !rubric.scenes.contains(shown_name(folder))) {
            if (!inside.scenes.empty())
                fmt::print(
                    stderr,
                    "snell: warning: '{}' holds {} next to other entries: each is a submission [several-submissions]\n "
                    "  help: to grade one scene with the files next to it, name the scene\n",
                    utf8::printable(arguments.front()), counted(inside.scenes.size(), "scene"));
            found.left_out = std::move(inside.left_out);
            paths = {inside.scenes.begin(), inside.scenes.end()};
            paths.insert(inside.others.begin(), inside.others.end());
        }
    }
    std::erase_if(paths, [&](const fs::path& path) { return fs::weakly_canonical(path, error) == report; });
    std::map<std::string, std::string> known;
    for (const bool links : {false, true})
        for (const fs::path& path : paths) {
            if (fs::is_symlink(path, error) != links) continue;
            const std::string problem = problem_of(path, known), name = shown_name(path);
            const std::string judged = problem.empty() ? fs::weakly_canonical(path, error).string() : path.string();
            known.emplace(judged, name);
            found.all.push_back({judged, name, {}, content::sha256(judged).substr(0, 6), problem});
        }
    if (found.all.empty()) {
        complain("there is nothing to grade", "name folders, archives or scenes, or one folder that holds them");
        return std::nullopt;
    }
    name_apart(found.all);
    std::sort(found.all.begin(), found.all.end(), [](const Submission& a, const Submission& b) {
        return std::tie(a.name, a.path) < std::tie(b.name, b.path);
    });
    name_folders(found.all, report / "students");
    return found;
}

std::string key_of(const Submission& submission, const std::string& rest, FolderHashes& known) {
    std::string all = rest + submission.problem;
    const fs::path path = submission.path;
    if (!submission.problem.empty()) return content::sha256(all);
    const bool loose = is_scene(path) && fs::is_regular_file(path);
    if (is_scene(path)) all += path.filename().string() + '\0';
    const fs::path read = loose ? path.parent_path() : path;
    const auto [hash, fresh] = known.try_emplace(read.string());
    if (fresh) {
        std::string files;
        const bool whole = !loose || unusable(read.string()).empty();
        if (whole) add_files(read, files);
        hash->second = whole ? content::sha256(files) : "";
    }
    return hash->second.empty() ? "" : content::sha256(all + hash->second);
}

std::string common_key(const Rubric& rubric, const std::string& limits) {
    std::string all = fmt::format("{} {} {}", version(), build_of_program(), limits) + '\0' + rubric.text + '\0';
    if (!rubric.reference.empty())
        for (const std::string& file : files_read_by(rubric.reference, {})) add_files(file, all);
    for (const std::string& path : rubric.shared) add_files(path, all);
    return content::sha256(all);
}

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 100'000;

struct SceneFile {
    std::string folder, path;  // path: relative to the folder
    bool preferred = false;
    int depth = 0;
    std::set<std::string> uniforms = {};
};

std::string listed(const std::vector<SceneFile>& scenes) {
    std::string text;
    for (std::size_t i = 0; i < scenes.size() && i < 8; ++i)
        text += fmt::format("{}'{}'", i == 0 ? "" : ", ", utf8::printable(scenes[i].path));
    return text + (scenes.size() > 8 ? ", …" : "");
}

// True for "a/b.glib" and "b.glib". Messages have printable names, and rubrics what messages have.
bool ends_with_path(std::string_view path, std::string_view end) {
    if (path.size() < end.size() || !same_word(path.substr(path.size() - end.size()), end)) return false;
    return path.size() == end.size() || path[path.size() - end.size() - 1] == '/';
}

// Keeps those that are the least by `rank`.
void keep_first(std::vector<SceneFile>& scenes, const auto& rank) {
    const auto first = *std::min_element(scenes.begin(), scenes.end(),
                                         [&](const SceneFile& a, const SceneFile& b) { return rank(a) < rank(b); });
    std::erase_if(scenes, [&, least = rank(first)](const SceneFile& scene) { return least < rank(scene); });
}

}  // namespace

bool is_hidden(std::string_view name) {
    return name.starts_with('.') || name.starts_with("~$") || name == "__MACOSX" || same_word(name, "thumbs.db") ||
           same_word(name, "desktop.ini");
}

bool fits_pattern(std::string_view name, std::string_view pattern, bool exact) {
    const auto alike = [exact](char a, char b) { return exact ? a == b : lower(a) == lower(b); };
    std::size_t n = 0, p = 0, star = pattern.npos, mark = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            mark = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || alike(pattern[p], name[n]))) {
            ++p;
            ++n;
        } else if (star != pattern.npos) {
            p = star + 1;
            n = ++mark;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

FoundScene find_scene(const std::vector<std::string>& folders, const WantedScene& wanted) {
    FoundScene found;
    std::vector<SceneFile> scenes, others;  // others: with names that do not fit
    std::size_t entries = 0;
    std::error_code unread;
    std::string folder;
    const auto visit = [&](const fs::path& file, fs::file_status status, int depth) {
        const std::string name = file.filename().string();
        if (++entries > most_entries) return content::Walk::end;
        if (is_hidden(name)) return content::Walk::past;
        if (!fs::is_regular_file(status)) return content::Walk::on;
        const std::string path = file.lexically_relative(folder).string();
        if (is_archive(path)) found.archives.push_back(file.string());
        const bool fits = wanted.named.empty() ? fits_pattern(name, wanted.pattern.empty() ? "*.glib" : wanted.pattern)
                                               : ends_with_path(path, wanted.named) ||
                                                     ends_with_path(utf8::printable(path), wanted.named);
        if (fits || lowered(name).find(".glib") != name.npos)  // also a.glib.txt, whose ending Windows hides
            (fits ? scenes : others).push_back({folder, path, same_word(name, wanted.preferred), depth});
        return content::Walk::on;
    };
    for (const std::string& one : folders) {
        folder = one;
        if (const std::error_code error = content::walk(folder, visit); error) unread = error;
    }
    ranges::sort(found.archives);
    const auto by_path = [](const SceneFile& a, const SceneFile& b) { return a.path < b.path; };
    std::sort(scenes.begin(), scenes.end(), by_path);
    std::sort(others.begin(), others.end(), by_path);
    if (unread) found.error = "it cannot be read: " + unread.message();
    if (scenes.empty() && !unread) {
        found.error = !wanted.named.empty()
                          ? fmt::format("there is no scene '{}', which the rubric's [scenes] names", wanted.named)
                          : fmt::format("there is no scene: no file is called {}",
                                        wanted.pattern.empty() ? "*.glib" : wanted.pattern);
        if (!others.empty()) found.error += fmt::format("; there is {}", listed(others));
    }
    if (scenes.empty()) {
        for (const SceneFile& other : others) found.several.push_back(other.path);
        return found;
    }
    const auto place = [](const SceneFile& scene) { return std::pair(!scene.preferred, scene.depth); };
    const std::vector<SceneFile> all = scenes;
    if (scenes.size() > 1 && wanted.uniforms && wanted.named.empty()) {
        for (SceneFile& scene : scenes) scene.uniforms = wanted.uniforms(scene.folder, scene.path);
        keep_first(scenes, [](const SceneFile& scene) { return scene.uniforms.empty(); });
        keep_first(scenes, place);
        keep_first(scenes, [](const SceneFile& scene) { return -static_cast<std::ptrdiff_t>(scene.uniforms.size()); });
        std::vector<SceneFile> plain = all;
        keep_first(plain, place);
        if (scenes.size() == 1 && (plain.size() > 1 || plain.front().path != scenes.front().path))
            found.reason = fmt::format(
                "of the scenes {}, '{}' is judged: it has the most of the rubric's uniforms ({})", listed(all),
                utf8::printable(scenes.front().path), fmt::join(scenes.front().uniforms, ", "));
    }
    keep_first(scenes, place);
    if (scenes.size() == 1) {
        found.folder = scenes.front().folder;
        found.scene = scenes.front().path;
        return found;
    }
    found.error = fmt::format("it is not clear which scene is meant: {}", listed(scenes));
    for (const SceneFile& scene : scenes) found.several.push_back(scene.path);
    return found;
}

}  // namespace snell::app
