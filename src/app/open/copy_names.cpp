#include "src/app/open/copy_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "parser/text/ranges.h"
#include "parser/text/utf8.h"
#include "parser/text/words.h"
#include "src/content/replace.h"
#include "src/content/whole_file.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

using Folders = std::vector<std::string>;

constexpr std::size_t most_folders_up = 3;
constexpr std::string_view mark = "/./";

Folders folders_of(const fs::path& folder) {
    Folders parts;
    for (const fs::path& part : folder.lexically_normal())
        if (!part.empty() && part != "/" && part != ".") parts.push_back(part.string());
    return parts;
}

// How many of the folders around the scene may be named in a copy: none of those that lead to the user's home.
std::size_t most_up(const Folders& scene) {
    const std::size_t most = std::min(most_folders_up, scene.size());
    const char* home = std::getenv("HOME");
    if (!home || *home != '/') return most;
    const Folders around = folders_of(home);
    const bool within = scene.size() >= around.size() && std::equal(around.begin(), around.end(), scene.begin());
    return within ? std::min(most, scene.size() - around.size()) : most;
}

// A file by the way to it from the scene's folder.
struct Way {
    Folders place;       // without ".."
    std::size_t up = 0;  // the number of the scene's folders that it leaves, even if it enters them again
};

// Returns nullopt for a path that does not begin at the scene's folder.
std::optional<Way> way_to(const std::string& path, const std::string& folder, const Folders& scene) {
    if (!path.starts_with(folder)) return std::nullopt;
    Way way{scene, 0};
    for (const fs::path& part : fs::path(path.substr(folder.size()))) {
        if (part.empty() || part == ".") continue;
        if (part != "..") {
            way.place.push_back(part.string());
            continue;
        }
        if (way.place.empty()) return std::nullopt;
        way.place.pop_back();
        if (way.place.size() < scene.size()) way.up = std::max(way.up, scene.size() - way.place.size());
    }
    return way;
}

std::string lower_name(const std::string& path) {
    std::string name = fs::path(path).filename().string();
    ranges::transform(name, name.begin(), lower);
    return name;
}

// As the page sees it (web/page/archive.ts): "C:a.glib" is a drive on other systems.
bool is_plain(std::string_view name) {
    if (name.size() > 1 && name[1] == ':' && lower(name[0]) >= 'a' && lower(name[0]) <= 'z') return false;
    for (std::size_t at = 0; at < name.size();) {
        const utf8::Char c = utf8::decode(name, at);
        if (!c.valid || c.code < 32 || c.code == 127 || c.code == '\\') return false;
        at += c.length;
    }
    return true;
}

std::string shown_name(const std::string& path) { return utf8::printable(fs::path(path).lexically_normal().string()); }

std::string one_name(const std::string& a, const std::string& b, std::string_view copy) {
    return fmt::format(
        "'{}' and '{}' have one name, and {} has all files that are not near the scene in the scene's folder: rename "
        "one of them",
        shown_name(a), shown_name(b), copy);
}

// Two of the files on the disk that a copy could not tell apart; "" where there are none.
std::string confused(const std::vector<NamedFile>& files, const std::set<std::string>& moved, std::string_view copy) {
    std::map<std::string, std::string> known;
    for (const NamedFile& file : files) {
        if (!is_plain(file.name))
            return fmt::format("'{}' has a name that {} cannot hold: rename it", shown_name(file.path), copy);
        const auto [other, is_new] = known.emplace(lower_name(file.path), file.path);
        std::error_code error;
        const bool near = !moved.contains(file.path) && !moved.contains(other->second);
        if (!is_new && !near && !fs::equivalent(other->second, file.path, error))
            return one_name(other->second, file.path, copy);
    }
    return {};
}

std::string joined(const Folders& parts, std::size_t from) {
    std::string name;
    for (std::size_t i = from; i < parts.size(); ++i) name += (i > from ? "/" : "") + parts[i];
    return name;
}

}  // namespace

std::string marked_path(const std::string& scene) {
    const fs::path path(scene);
    const std::string folder = path.parent_path().string();
    return (folder.empty() ? "." : folder) + std::string(mark) + path.filename().string();
}

CopyNames copy_names(const std::string& scene, const std::vector<std::string>& paths, std::string_view copy) {
    const std::string folder = scene.substr(0, scene.rfind(mark) + mark.size());
    const Folders around = folders_of(fs::absolute(folder));
    const std::size_t most = most_up(around);
    std::vector<std::optional<Way>> ways;
    std::size_t up = 0;
    for (const std::string& path : paths) {
        ways.push_back(way_to(path, folder, around));
        if (ways.back() && ways.back()->up > most) ways.back().reset();
        if (ways.back()) up = std::max(up, ways.back()->up);
    }
    const std::size_t root = around.size() - up;
    CopyNames names{joined(way_to(scene, folder, around)->place, root), {}, {}};
    std::set<std::string> moved;
    std::map<std::string, std::string> known;
    for (std::size_t i = 0; i < paths.size(); ++i) {
        Folders place = around;
        place.push_back(fs::path(paths[i]).filename().string());
        if (ways[i]) place = ways[i]->place;
        const std::string name = joined(place, root);
        if (!ways[i]) moved.insert(paths[i]);
        const auto [other, is_new] = known.emplace(name, paths[i]);
        if (is_new)
            names.files.push_back({paths[i], name});
        else if (content::whole_file(other->second) != content::whole_file(paths[i]))
            names.error = one_name(other->second, paths[i], copy);
    }
    if (names.error.empty()) names.error = confused(names.files, moved, copy);
    return names;
}

}  // namespace snell::app
