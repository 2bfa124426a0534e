#include "src/app/grade/find_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/grade/unpack.h"
#include "src/content/files.h"
#include "src/plan/locate.h"

namespace snell::app {

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
