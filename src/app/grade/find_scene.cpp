#include "src/app/grade/find_scene.h"

#include <fmt/format.h>

#include <filesystem>

#include "parser/text/ranges.h"
#include "parser/text/utf8.h"
#include "parser/text/words.h"
#include "src/app/grade/unpack.h"
#include "src/content/walk.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_entries = 100'000;

struct SceneFile {
    std::string path;
    bool preferred = false;
    int depth = 0;
};

bool passed_over(const fs::path& name) {
    const std::string text = name.string();
    return text.starts_with('.') || text == "__MACOSX";
}

std::string listed(const std::vector<SceneFile>& scenes) {
    std::string text;
    for (std::size_t i = 0; i < scenes.size() && i < 8; ++i)
        text += fmt::format("{}'{}'", i == 0 ? "" : ", ", utf8::printable(scenes[i].path));
    return text;
}

}  // namespace

bool fits_pattern(std::string_view name, std::string_view pattern) {
    std::size_t n = 0, p = 0, star = pattern.npos, mark = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            mark = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || lower(pattern[p]) == lower(name[n]))) {
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

FoundScene find_scene(const std::string& folder, const std::string& pattern, const std::string& preferred) {
    FoundScene found;
    std::vector<SceneFile> scenes;
    std::size_t entries = 0;
    const std::error_code unread = content::walk(folder, [&](const fs::path& file, fs::file_status status, int depth) {
        const fs::path name = file.filename();
        if (++entries > most_entries) return content::Walk::end;
        if (passed_over(name)) return content::Walk::past;
        if (!fs::is_regular_file(status)) return content::Walk::on;
        const std::string path = file.lexically_relative(folder).string();
        if (is_archive(path)) found.archives.push_back(file.string());
        if (fits_pattern(name.string(), pattern.empty() ? "*.glib" : pattern))
            scenes.push_back({path, same_word(name.string(), preferred), depth});
        return content::Walk::on;
    });
    if (unread) {
        found.error = "it cannot be read: " + unread.message();
        return found;
    }
    ranges::sort(found.archives);
    if (scenes.empty()) {
        found.error = fmt::format("there is no scene: no file is called {}", pattern.empty() ? "*.glib" : pattern);
        return found;
    }
    found.archives.clear();
    const auto rank = [](const SceneFile& s) { return std::tuple(!s.preferred, s.depth, s.path); };
    std::sort(scenes.begin(), scenes.end(), [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    const auto same = [&](const SceneFile& s) {
        return s.preferred == scenes.front().preferred && s.depth == scenes.front().depth;
    };
    std::erase_if(scenes, [&](const SceneFile& s) { return !same(s); });
    found.several = scenes.size() > 1;
    if (found.several)
        found.error = fmt::format("it is not clear which scene is meant: {}", listed(scenes));
    else
        found.scene = scenes.front().path;
    return found;
}

}  // namespace snell::app
