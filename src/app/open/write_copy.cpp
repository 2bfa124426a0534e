#include "src/app/open/write_copy.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/content/replace.h"

namespace snell::app {

namespace {

namespace fs = std::filesystem;

struct Target {
    fs::path path;
    std::string bytes;
    bool there = false;  // with the same bytes
};

// Without the mark of marked_path().
std::string plain(const std::string& path) { return fs::path(path).lexically_normal().string(); }

std::string shown(const fs::path& path) { return utf8::printable(path.string()); }

CopyNames names_for(const std::string& marked, const Access& access) {
    return copy_names(marked, files_read_by(marked, access), "the new folder");
}

std::string renamed(const CopyNames& names, const fs::path& folder, const std::string& name) {
    fs::path scene = folder / names.scene;
    if (!name.empty()) scene.replace_filename(name);
    return scene.string();
}

// The files of the copy. Sets `copy.error` if the scene would not find them there.
std::vector<Target> gather(const std::string& scene, const Access& access,
                           const std::map<std::string, std::string>& texts, const fs::path& folder,
                           const std::string& name, WrittenCopy& copy) {
    const std::string marked = marked_path(scene);
    Files files(scene_folder(marked), access);
    const CopyNames names = names_for(marked, access);
    copy.error = names.error;
    if (names.files.empty()) copy.error = fmt::format("cannot read '{}'", shown(scene));
    copy.scene = renamed(names, folder, name);
    std::map<std::string, const std::string*> changed;
    for (const auto& [path, text] : texts) changed.emplace(plain(path), &text);
    std::vector<Target> targets;
    for (const NamedFile& named : names.files) {
        if (!copy.error.empty()) return {};
        const auto text = changed.extract(plain(named.path));
        if (text && !named.path.starts_with(scene_folder(marked)))
            copy.error =
                fmt::format("'{}' changes, but its absolute name leads to the old text: name it relative to the scene",
                            shown(named.path));
        std::string wrong;
        std::optional<std::string> bytes = text ? *text.mapped() : files.read(named.path, wrong);
        if (!bytes) copy.error = fmt::format("cannot read '{}': {}", shown_path(named.path), wrong);
        targets.push_back(
            {named.name == names.scene ? fs::path(copy.scene) : folder / named.name, std::move(bytes).value_or("")});
    }
    if (!changed.empty() && copy.error.empty())
        copy.error = fmt::format("the scene does not read '{}'", shown(changed.begin()->first));
    return targets;
}

// Whether there is something that would be replaced, or written to by a link. `target.there` is set if not even that
// is necessary.
std::string obstacle(Target& target, const fs::path& folder) {
    std::error_code error;
    for (fs::path on_way = target.path.parent_path(); on_way != folder && on_way.has_relative_path();
         on_way = on_way.parent_path()) {
        const fs::file_status status = fs::symlink_status(on_way, error);
        if (fs::exists(status) && !fs::is_directory(status))
            return fmt::format("'{}' is {}, where a folder is needed: choose another folder", shown(on_way),
                               fs::is_symlink(status) ? "a link" : "a file");
    }
    const fs::file_status status = fs::symlink_status(target.path, error);
    if (!fs::exists(status)) return {};
    target.there = fs::is_regular_file(fs::status(target.path, error)) &&
                   fs::file_size(target.path, error) == target.bytes.size() &&
                   content::whole_file(target.path.string()) == target.bytes;
    if (target.there) return {};
    return fmt::format("'{}' exists with another content, which is not replaced: choose another folder",
                       shown(target.path));
}

// Makes the folder and those above it. Appends those that were not there.
std::string make_folders(const fs::path& folder, std::vector<fs::path>& made) {
    std::error_code error;
    std::vector<fs::path> missing;
    for (fs::path at = folder; !at.empty() && !fs::exists(at, error); at = at.parent_path()) missing.push_back(at);
    std::reverse(missing.begin(), missing.end());
    for (const fs::path& path : missing) {
        if (fs::create_directory(path, error)) made.push_back(path);
        if (error) return fmt::format("cannot make the folder '{}': {}", shown(path), error.message());
    }
    return {};
}

std::string write_all(const std::vector<Target>& targets, const fs::path& folder) {
    std::vector<fs::path> made;
    std::string wrong = make_folders(folder, made);
    for (const Target& target : targets) {
        if (!wrong.empty()) break;
        if (target.there) continue;
        wrong = make_folders(target.path.parent_path(), made);
        if (wrong.empty()) wrong = content::replace_file(target.path.string(), target.bytes);
        if (wrong.empty()) made.push_back(target.path);
    }
    std::error_code unheard;
    if (!wrong.empty())
        for (auto path = made.rbegin(); path != made.rend(); ++path) fs::remove(*path, unheard);
    return wrong;
}

}  // namespace

std::string place_in_copy(const std::string& scene, const Access& access, const std::string& folder,
                          const std::string& name) {
    const CopyNames names = names_for(marked_path(scene), access);
    return names.error.empty() && !names.files.empty() ? renamed(names, fs::path(folder).lexically_normal(), name) : "";
}

WrittenCopy write_copy(const std::string& scene, const Access& access, const std::map<std::string, std::string>& texts,
                       const std::string& folder, const std::string& name) {
    WrittenCopy copy;
    // Without a slash at its end, so that the way from a file in it ends there.
    fs::path into = fs::path(folder).lexically_normal();
    if (!into.has_filename() && into.has_relative_path()) into = into.parent_path();
    std::vector<Target> targets = gather(scene, access, texts, into, name, copy);
    std::error_code error;
    if (copy.error.empty() && fs::exists(into, error) && !fs::is_directory(into, error))
        copy.error = fmt::format("'{}' is not a folder", shown(into));
    if (copy.error.empty() && fs::equivalent(copy.scene, scene, error))
        copy.error =
            fmt::format("'{}' has the scene itself, which is not replaced: choose another folder", shown(into));
    for (Target& target : targets) {
        if (!copy.error.empty()) return copy;
        copy.error = obstacle(target, into);
        copy.files.push_back(target.path.string());
    }
    if (copy.error.empty()) copy.error = write_all(targets, into);
    return copy;
}

namespace {

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

std::string one_name(const std::string& a, const std::string& b, std::string_view copy) {
    return fmt::format(
        "'{}' and '{}' have one name, and {} has all files that are not near the scene in the scene's folder: rename "
        "one of them",
        shown_path(a), shown_path(b), copy);
}

// Two of the files on the disk that a copy could not tell apart; "" where there are none.
std::string confused(const std::vector<NamedFile>& files, const std::set<std::string>& moved, std::string_view copy) {
    std::map<std::string, std::string> known;
    for (const NamedFile& file : files) {
        if (!is_plain(file.name))
            return fmt::format("'{}' has a name that {} cannot hold: rename it", shown_path(file.path), copy);
        const auto [other, is_new] = known.emplace(lowered(fs::path(file.path).filename().string()), file.path);
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

std::string shown_path(const std::string& path) { return shown(plain(path)); }

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

namespace snell {

namespace {

// Replaces `now` by `next` in all files or in none.
std::string exchange(const std::vector<SavedFile>& files, std::string SavedFile::*now, std::string SavedFile::*next) {
    std::error_code unknown;
    for (const SavedFile& file : files)
        if (content::whole_file(file.path) != file.*now)
            return utf8::printable(file.path) +
                   (fs::exists(file.path, unknown) ? " was changed meanwhile: it is left as it is" : " is gone");
    for (std::size_t i = 0; i < files.size(); ++i) {
        std::string error = content::rewrite_file(files[i].path, files[i].*next);
        if (error.empty()) continue;
        if (!error.starts_with(files[i].path)) error = files[i].path + ": " + error;
        while (i-- > 0)
            if (!content::rewrite_file(files[i].path, files[i].*now).empty())
                error += fmt::format("; {} could not get its previous text back", files[i].path);
        return error;
    }
    return {};
}

}  // namespace

std::string write_saved(const std::vector<SavedFile>& files) {
    return exchange(files, &SavedFile::before, &SavedFile::after);
}

std::string revert_saved(const std::vector<SavedFile>& files) {
    return exchange(files, &SavedFile::after, &SavedFile::before);
}

std::string exchange_saved(const std::vector<SavedFile>& files, bool forward) {
    if (forward) return write_saved(files);
    std::string error = revert_saved(files);
    std::error_code none;
    for (const SavedFile& file : files)
        if (error.empty() && file.before.empty()) std::filesystem::remove(file.path, none);
    return error;
}

}  // namespace snell
