#include "src/plan/files.h"

#include <sys/stat.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <system_error>

#include "parser/text/diagnostic.h"
#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/plan/locate.h"

namespace snell {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view outside_reason =
    "it is outside of the folder that reading is confined to, and only files inside may be read";

// The search in a folder stops after this many entries.
constexpr std::size_t max_entries = 100'000;

// The path without links and ".."; "" if nothing exists there.
std::string real_path(const std::string& path) {
    const std::unique_ptr<char, decltype(&std::free)> real(realpath(path.empty() ? "." : path.c_str(), nullptr),
                                                           &std::free);
    return real ? real.get() : "";
}

bool below(std::string_view path, std::string_view root) {
    return path == root || root == "/" || (path.starts_with(root) && path[root.size()] == '/');
}

std::string join(std::string_view folder, std::string_view name) {
    if (folder.empty()) return std::string(name);
    std::string result(folder);
    if (result.back() != '/') result += '/';
    return result += name;
}

// Normalises a name to a path: '/' only, no empty or "." components, no blanks or quotes around it.
std::string tidy(std::string_view name) {
    while (!name.empty() && std::isspace(static_cast<unsigned char>(name.front())) != 0) name.remove_prefix(1);
    while (!name.empty() && std::isspace(static_cast<unsigned char>(name.back())) != 0) name.remove_suffix(1);
    if (name.size() > 1 && name.front() == name.back() && (name.front() == '"' || name.front() == '\''))
        name = name.substr(1, name.size() - 2);
    std::string slashed(name);
    std::replace(slashed.begin(), slashed.end(), '\\', '/');
    std::string result = !slashed.empty() && slashed[0] == '/' ? "/" : "";
    for (std::size_t at = 0; at <= slashed.size();) {
        const std::size_t end = std::min(slashed.find('/', at), slashed.size());
        const std::string_view part(slashed.data() + at, end - at);
        if (!part.empty() && part != ".") result = join(result, part);
        at = end + 1;
    }
    return result;
}

bool has_drive(std::string_view name) {
    return name.size() > 1 && name[1] == ':' && std::isalpha(static_cast<unsigned char>(name[0])) != 0;
}

bool is_absolute(std::string_view name) { return (!name.empty() && name[0] == '/') || has_drive(name); }

std::string_view last_component(std::string_view name) { return name.substr(name.rfind('/') + 1); }

bool below_any(std::string_view path, const std::vector<std::string>& roots) {
    return std::any_of(roots.begin(), roots.end(), [&](const std::string& root) { return below(path, root); });
}

// Looks names up in folders, within bounds: what lies outside of `roots` is as if it were not there.
struct Finder {
    const std::vector<std::string>& roots;                        // real paths; empty if the search is unbounded
    const std::map<std::string, std::string>* instead = nullptr;  // Access::instead

    bool inside(const std::string& path) const { return roots.empty() || below_any(real_path(path), roots); }

    bool is_regular(const std::string& path) const {
        struct stat status {};
        if (instead && instead->contains(path)) return true;
        return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && inside(path);
    }

    bool is_folder(const std::string& path) const {
        struct stat status {};
        return stat(path.empty() ? "." : path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && inside(path);
    }

    // Lists the names in a folder, sorted so that the choice among several never depends on the file system.
    std::vector<std::string> list(const std::string& folder) const {
        std::vector<std::string> names;
        if (!inside(folder)) return names;
        std::error_code error;
        for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end;
             it.increment(error)) {
            names.push_back(it->path().filename().string());
            if (names.size() == max_entries) break;
        }
        std::sort(names.begin(), names.end());
        return names;
    }

    // The file or folder that `rest` leads to from `folder` without regard to case; empty if there is none.
    std::string match_case(const std::string& folder, std::string_view rest, bool want_folder) const {
        const std::size_t slash = rest.find('/');
        const std::string part(rest.substr(0, slash));
        const bool last = slash == std::string_view::npos;
        const auto follow = [&](const std::string& entry) -> std::string {
            const std::string path = join(folder, entry);
            if (last) return (want_folder ? is_folder(path) : is_regular(path)) ? path : "";
            return is_folder(path) ? match_case(path, rest.substr(slash + 1), want_folder) : "";
        };
        if (std::string found = follow(part); !found.empty() || part == "..") return found;
        const std::string wanted = lowered(part);
        for (const std::string& entry : list(folder)) {
            if (entry == part || lowered(entry) != wanted) continue;
            if (std::string found = follow(entry); !found.empty()) return found;
        }
        return {};
    }

    // The file that was probably meant by a name that leads nowhere, as a scene would write it; "" when there is none.
    std::string most_similar(const std::string& base, const std::string& name,
                             const std::vector<std::string_view>& extensions) const {
        const std::string_view file = last_component(name);
        std::string_view where(name.data(), name.size() - file.size());
        while (!where.empty() && where.back() == '/' && where.size() > 1) where.remove_suffix(1);
        std::string folder =
            where.empty() ? base : (is_absolute(where) ? std::string(where) : match_case(base, where, true));
        if (folder.empty() && !where.empty()) {  // no such folder: all files may have been gathered in one
            folder = base;
            where = {};
        }
        const std::vector<std::string> entries = list(folder);
        std::string elsewhere = in_folder_nearby(folder, entries, file);
        if (!elsewhere.empty()) return fs::path(join(where, elsewhere)).lexically_normal().string();
        std::vector<std::string_view> candidates;
        for (const std::string& entry : entries)
            if (same_kind(entry, file, extensions)) candidates.push_back(entry);
        while (true) {  // few are near enough to be looked at
            const std::string_view best = nearest_file(file, candidates);
            if (best.empty()) return {};
            if (is_regular(join(folder, best))) return join(where, best);
            std::erase(candidates, best);
        }
    }

    // The same name one folder down, or one up, or in the only folder beside this one that has it.
    std::string in_folder_nearby(const std::string& folder, const std::vector<std::string>& entries,
                                 std::string_view file) const {
        constexpr std::size_t most = 1000;  // of entries that are looked into
        for (std::size_t i = 0; i < std::min(entries.size(), most); ++i)
            if (const std::string path = join(entries[i], file); is_regular(join(folder, path))) return path;
        const std::string above = join("..", file);
        if (is_regular(join(folder, above))) return above;
        std::string beside;
        const std::vector<std::string> neighbours = list(join(folder, ".."));
        for (std::size_t i = 0; i < std::min(neighbours.size(), most); ++i) {
            std::string path = join("../" + neighbours[i], file);
            if (!is_regular(join(folder, path))) continue;
            if (!beside.empty()) return {};
            beside = std::move(path);
        }
        return beside;
    }

    std::string find_case(const std::string& base, const std::string& name) const {
        return is_absolute(name) ? std::string() : match_case(base, name, false);
    }
};

// Remembers a failed look-up: a scene may name the same missing file thousands of times, and each search reads whole
// folders.
template <class Look>
Resolved once(std::mutex& mutex, std::map<std::string, Resolved>& missing, std::string_view folder,
              std::string_view name, const std::vector<std::string_view>& extensions, const Look& look) {
    std::string asked = std::string(folder) + '\0' + std::string(name);
    for (const std::string_view extension : extensions) asked += '\0' + std::string(extension);
    {
        const std::scoped_lock lock(mutex);
        if (const auto known = missing.find(asked); known != missing.end()) return known->second;
    }
    Resolved found = look();
    if (!found.path.empty()) return found;
    const std::scoped_lock lock(mutex);
    return missing.try_emplace(std::move(asked), std::move(found)).first->second;
}

}  // namespace

Access Access::with(std::map<std::string, std::string> texts) const {
    Access access = *this;
    if (instead) texts.insert(instead->begin(), instead->end());
    access.instead = std::make_shared<const std::map<std::string, std::string>>(std::move(texts));
    return access;
}

Files::Files(std::string folder, Access access) : folder_(std::move(folder)), access_(std::move(access)) {
    if (!access_.confine) return;
    const auto add = [&](const std::string& root) {
        const std::string real = real_path(root);
        roots_.push_back(real.empty() ? "/\n" : real);  // if the folder does not exist, no file is inside of it
    };
    add(*access_.confine);
    for (const std::string& more : access_.allow) add(more);
}

// A folder that is a link makes another file of sub/../a.frag.
Resolved Files::as_spelled_first(Resolved found) const {
    if (found.path.empty()) return found;
    const std::scoped_lock lock(mutex_);
    const auto known = spelled_.try_emplace(fs::path(found.path).lexically_normal().string(), found.path).first;
    std::error_code error;
    if (known->second != found.path && fs::equivalent(known->second, found.path, error)) found.path = known->second;
    return found;
}

Resolved Files::resolve(std::string_view written, const std::vector<std::string_view>& extensions) const {
    const Resolved found = in_folder(written, extensions);
    if (!found.path.empty() || access_.allow.empty()) return as_spelled_first(found);
    const Resolved shared = handed_out(written, extensions);
    return shared.path.empty() ? found : as_spelled_first(shared);
}

Resolved Files::in_folder(std::string_view written, const std::vector<std::string_view>& extensions) const {
    return once(mutex_, missing_, folder_, written, extensions, [&] { return look_for(written, extensions); });
}

// Of several files of that name, the one with most of the folders that were written ahead of it, then the first.
Resolved Files::handed_out(std::string_view written, const std::vector<std::string_view>& extensions) const {
    const std::scoped_lock lock(mutex_);
    if (!handed_out_) {
        handed_out_.emplace();
        for (const std::string& folder : access_.allow)
            content::walk(folder, [&](const fs::path& path, fs::file_status status, int) {
                if (fs::is_regular_file(status)) handed_out_->emplace(lowered(path.filename().string()), path.string());
                return handed_out_->size() < max_entries ? content::Walk::on : content::Walk::end;
            });
    }
    const std::string wanted = lowered(tidy(written));
    const auto common = [](std::string_view a, std::string_view b) {
        std::size_t n = 0;
        while (n < a.size() && n < b.size() && a[a.size() - 1 - n] == b[b.size() - 1 - n]) ++n;
        return n;
    };
    std::vector<std::string> names{wanted};
    for (const std::string_view extension : extensions)
        names.push_back(wanted + (wanted.ends_with('.') ? "" : ".") + std::string(extension));
    for (const std::string& name : names) {
        const auto [begin, end] = handed_out_->equal_range(std::string(last_component(name)));
        const auto rank = [&](const auto& entry) {
            return std::pair(~common(lowered(entry.second), name), std::string_view(entry.second));
        };
        const auto best = std::min_element(begin, end, [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
        if (best != end) return {best->second, last_component(best->second) != last_component(tidy(written))};
    }
    return {};
}

Resolved Files::look_for(std::string_view written, const std::vector<std::string_view>& extensions) const {
    Resolved found = look_up(written, extensions);
    const std::string name = tidy(written);
    const bool sought = !name.empty() && name.find('\0') == std::string::npos;
    if (found.path.empty() && found.refused.empty() && sought)
        found.nearest = Finder{roots_}.most_similar(folder_, name, extensions);
    return found;
}

Resolved Files::find(std::string_view name) const {
    const Resolved found = look_up(name, {});
    if (!found.path.empty() || access_.allow.empty()) return as_spelled_first(found);
    const Resolved shared = handed_out(name, {});
    return shared.path.empty() ? found : as_spelled_first(shared);
}

Resolved Files::look_up(std::string_view written, const std::vector<std::string_view>& extensions) const {
    const std::string name = tidy(written);
    if (name.empty() || name.find('\0') != std::string::npos) return {};
    const Finder finder{roots_, access_.instead.get()};
    const auto at = [&](const std::string& relative) {
        return is_absolute(relative) && !has_drive(relative) ? relative : join(folder_, relative);
    };
    if (std::string path = at(name); finder.is_regular(path)) return {std::move(path), false};
    if (std::string path = finder.find_case(folder_, name); !path.empty()) return {std::move(path), true};
    for (const std::string_view extension : extensions) {
        const std::string longer = name + (name.back() == '.' ? "" : ".") + std::string(extension);
        if (std::string path = at(longer); finder.is_regular(path)) return {std::move(path), true};
        if (std::string path = finder.find_case(folder_, longer); !path.empty()) return {std::move(path), true};
    }
    // The scene was written on another machine, or before its files were gathered in one folder.
    if (const std::string file(last_component(name)); file != name && file != ".." && !has_drive(file)) {
        if (Resolved here = look_up(file, extensions); !here.path.empty()) return {here.path, true};
    }
    struct stat status {};
    if (stat(at(name).c_str(), &status) != 0) return {};
    if (!finder.inside(at(name))) return {{}, false, {}, outside_reason};
    const bool odd = !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    return {{}, false, {}, odd ? "it is a pipe or a device, not a file" : ""};
}

Resolved Files::resolve_beside(std::string_view from, std::string_view name,
                               const std::vector<std::string_view>& extensions) const {
    const std::size_t slash = from.rfind('/');
    const std::string folder(slash == std::string_view::npos ? "" : from.substr(0, slash + 1));
    const Resolved beside = once(mutex_, missing_, folder, name, extensions,
                                 [&] { return Files(folder, access_).in_folder(name, extensions); });
    Resolved found = beside.path.empty() ? resolve(name, extensions) : as_spelled_first(beside);
    // Only the last component led there.
    const std::string written = tidy(name);
    if (found.inexact && found.path == from && last_component(written) != written) {
        std::error_code unknown;
        const bool there = fs::exists(is_absolute(written) ? written : join(folder, written), unknown);
        return {{}, false, {}, there ? outside_reason : ""};
    }
    if (found.path.empty() && found.refused.empty()) found.refused = beside.refused;
    return found;
}

const std::string* Files::instead_of(const std::string& path) const {
    if (!access_.instead) return nullptr;
    auto found = access_.instead->find(path);
    if (found == access_.instead->end()) found = access_.instead->find(real_path(path));
    return found == access_.instead->end() ? nullptr : &found->second;
}

std::optional<std::string> Files::read(const std::string& path, std::string& error) {
    const auto inside = [&](const std::string& real) {
        if (below_any(real, roots_)) return true;
        error = "it is outside of the folder '" + *access_.confine + "', and only files inside may be read";
        return false;
    };
    const bool confined = !roots_.empty();
    std::optional<std::string> bytes;
    if (const auto* text = instead_of(path))
        bytes = *text;
    else
        bytes = content::read_regular_file(path, access_.limits.file_bytes,
                                           confined ? inside : std::function<bool(const std::string&)>(), error);
    if (!bytes) return std::nullopt;
    keep(path);
    const std::scoped_lock lock(mutex_);
    ++counters_.opened;
    counters_.bytes += bytes->size();
    return bytes;
}

std::shared_ptr<const std::string> Files::read_once(const std::string& path, std::string& error) {
    {
        const std::scoped_lock lock(mutex_);
        if (const auto known = texts_.find(path); known != texts_.end()) return known->second;
    }
    auto text = read(path, error);
    if (!text) return nullptr;
    const std::scoped_lock lock(mutex_);
    return texts_.try_emplace(path, std::make_shared<const std::string>(std::move(*text))).first->second;
}

void Files::keep(const std::string& path) {
    const std::scoped_lock lock(mutex_);
    if (std::find(read_paths_.begin(), read_paths_.end(), path) == read_paths_.end()) read_paths_.push_back(path);
}

FileCounters Files::counters() const {
    const std::scoped_lock lock(mutex_);
    return counters_;
}

std::vector<std::string> Files::read_paths() const {
    const std::scoped_lock lock(mutex_);
    return read_paths_;
}

}  // namespace snell
