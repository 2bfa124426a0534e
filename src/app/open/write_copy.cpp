#include "src/app/open/write_copy.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "parser/text/utf8.h"
#include "src/app/open/copy_names.h"
#include "src/content/replace.h"
#include "src/content/whole_file.h"
#include "src/document/document.h"

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

// The files of the copy. Sets `copy.error` if the scene would not find them there.
std::vector<Target> gather(const std::string& scene, const Access& access,
                           const std::map<std::string, std::string>& texts, const fs::path& folder, WrittenCopy& copy) {
    const std::string marked = marked_path(scene);
    Files files(scene_folder(marked), access);
    const CopyNames names = names_for(marked, access);
    copy.error = names.error;
    if (names.files.empty()) copy.error = fmt::format("cannot read '{}'", shown(scene));
    copy.scene = (folder / names.scene).string();
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
        if (!bytes) copy.error = fmt::format("cannot read '{}': {}", shown(plain(named.path)), wrong);
        targets.push_back({folder / named.name, std::move(bytes).value_or("")});
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

std::string check_folder(const std::string& folder) {
    std::vector<fs::path> made;
    std::string wrong = make_folders(folder, made);
    std::error_code error;
    if (wrong.empty() && !fs::is_directory(folder, error)) wrong = fmt::format("'{}' is no folder", shown(folder));
    if (wrong.empty() && access(folder.c_str(), W_OK) != 0)
        wrong = fmt::format("cannot write into '{}': {}", shown(folder), std::strerror(errno));
    for (auto path = made.rbegin(); path != made.rend(); ++path) fs::remove(*path, error);
    return wrong;
}

WrittenCopy write_copy(const std::string& scene, const Access& access, const std::map<std::string, std::string>& texts,
                       const std::string& folder) {
    WrittenCopy copy;
    // Without a slash at its end, so that the way from a file in it ends there.
    fs::path into = fs::path(folder).lexically_normal();
    if (!into.has_filename() && into.has_relative_path()) into = into.parent_path();
    std::vector<Target> targets = gather(scene, access, texts, into, copy);
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

}  // namespace snell::app
