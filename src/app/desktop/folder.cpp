#include "src/app/desktop/folder.h"

#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/app/desktop/settings.h"
#include "src/content/files.h"
#include "src/content/replace.h"
#include "src/document/document.h"
#include "src/plan/locate.h"
#include "src/ui/panels/panels.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most = 5000;  // entries; a folder may hold millions

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string home() {
    const char* folder = std::getenv("HOME");
    return folder && *folder == '/' ? folder : "/";
}

std::string date_of(std::time_t time) {
    std::tm local{};
    if (!localtime_r(&time, &local)) return {};
    return fmt::format("{:04}-{:02}-{:02} {:02}:{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday,
                       local.tm_hour, local.tm_min);
}

// Returns the digits at `at` without leading zeros, and moves `at` behind them.
std::string_view number(std::string_view text, std::size_t& at) {
    while (at + 1 < text.size() && text[at] == '0' && is_digit(text[at + 1])) ++at;
    const std::size_t begin = at;
    while (at < text.size() && is_digit(text[at])) ++at;
    return text.substr(begin, at - begin);
}

constexpr int most_pixels = 160;                // on a side
constexpr std::uintmax_t most_bytes = 1 << 20;  // of a file: far more than such a picture has

}  // namespace

bool before(std::string_view a, std::string_view b) {
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (is_digit(a[i]) && is_digit(b[j])) {
            const std::string_view x = number(a, i), y = number(b, j);
            if (x.size() != y.size()) return x.size() < y.size();
            if (x != y) return x < y;
            continue;
        }
        const auto x = static_cast<unsigned char>(lower(a[i])), y = static_cast<unsigned char>(lower(b[j]));
        if (x != y) return x < y;
        ++i;
        ++j;
    }
    if (i < a.size() || j < b.size()) return j < b.size();
    return a < b;  // the names differ only in case
}

bool is_folder(const std::string& path) {
    std::error_code error;
    return fs::is_directory(path, error);
}

std::string without_tilde(const std::string& path) {
    return path == "~" || path.starts_with("~/") ? home() + path.substr(1) : path;
}

std::string with_tilde(const std::string& path) {
    const std::string folder = home();
    const bool within = path == folder || (folder != "/" && path.starts_with(folder + "/"));
    return within ? "~" + path.substr(folder.size()) : path;
}

std::string near_names(const std::string& text, const std::string& folder) {
    std::string result;
    const std::string here = folder.empty() || folder.ends_with('/') ? folder : folder + "/";
    const std::string at_home = home() == "/" ? "" : home() + "/";
    const auto begins_path = [&](std::size_t at) {
        return at == 0 || std::string_view(" \t\n'\"(:,=").find(text[at - 1]) != std::string_view::npos;
    };
    for (std::size_t at = 0; at < text.size();) {
        const std::string_view rest = std::string_view(text).substr(at);
        if (here.size() > 1 && rest.starts_with(here) && begins_path(at)) {
            at += here.size();
        } else if (!at_home.empty() && rest.starts_with(at_home) && begins_path(at)) {
            result += "~/";
            at += at_home.size();
        } else {
            result += text[at++];
        }
    }
    return result;
}

ui::Listing list_folder(const std::string& folder, bool all) {
    ui::Listing listing;
    listing.home = home();
    std::error_code error;
    const fs::path wanted = without_tilde(folder.empty() ? "." : folder);
    const fs::path real = fs::canonical(wanted, error);
    listing.folder = error ? fs::absolute(wanted, error).lexically_normal().string() : real.string();
    fs::directory_iterator entry(listing.folder, fs::directory_options::none, error);
    if (error) {
        listing.error = utf8::printable(listing.folder) + ": " + error.message();
        return listing;
    }
    for (; entry != fs::directory_iterator() && listing.entries.size() < most; entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        if (name.starts_with('.')) continue;
        struct stat status {};
        if (stat(entry->path().c_str(), &status) != 0) continue;
        const bool is_folder = S_ISDIR(status.st_mode);
        if (!is_folder && (!S_ISREG(status.st_mode) || (!all && !has_extension(name, "glib")))) continue;
        listing.entries.push_back(
            {utf8::printable(name), entry->path().string(), is_folder,
             is_folder ? std::string() : ui::bytes_text(static_cast<std::uint64_t>(status.st_size)),
             date_of(status.st_mtime)});
        if (error) break;
    }
    ranges::sort(listing.entries, [](const ui::Entry& a, const ui::Entry& b) {
        return a.folder != b.folder ? a.folder : before(a.name, b.name);
    });
    return listing;
}

std::string only_scene(const std::string& path) {
    if (!is_folder(path)) return path;
    const ui::Listing listing = list_folder(path, false);
    const auto scene = ranges::find(listing.entries, false, &ui::Entry::folder);  // folders come first
    if (listing.entries.end() - scene != 1) return path;
    return (fs::path(path) / fs::path(scene->path).filename()).string();
}

std::string thumbnails_folder() { return own_place("XDG_CACHE_HOME", "/.cache", "/snell/thumbnails"); }

std::string thumbnail_file(const std::string& folder, const std::string& scene) {
    return named_by(folder, scene, "png");
}

void keep_thumbnail(const std::string& folder, const std::string& scene, const content::Image& picture) {
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    content::replace_file(thumbnail_file(folder, scene), content::encode_png(picture));
    remove_oldest(folder, ".png", most_thumbnails);
}

std::optional<content::Image> read_thumbnail(const std::string& folder, const std::string& scene) {
    if (folder.empty()) return std::nullopt;
    const std::string file = thumbnail_file(folder, scene);
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > most_bytes || error) return std::nullopt;
    content::ImageResult read = content::decode_image(file, content::whole_file(file), {.side = most_pixels});
    // A file that was cut off still gives a picture, with an issue that says so.
    if (!read.image || !read.issues.empty()) return std::nullopt;
    return content::to_rgba(content::to_bytes(*read.image));
}

namespace {

namespace fs = std::filesystem;

constexpr const char* size = "160x120";
constexpr int seconds = 20;  // of one picture

// When the file was last written, or took the place of another one, which may have been written later than it. 0 if it
// is missing.
std::chrono::nanoseconds written_at(const std::string& file) {
    struct stat now {};
    if (stat(file.c_str(), &now) != 0) return {};
    return std::chrono::seconds(now.st_ctim.tv_sec) + std::chrono::nanoseconds(now.st_ctim.tv_nsec);
}

bool current(const std::string& picture, std::chrono::nanoseconds written) {
    const std::chrono::nanoseconds made = written_at(picture);
    return made.count() > 0 && made >= written;
}

std::chrono::nanoseconds last_written(const std::vector<std::string>& files) {
    std::chrono::nanoseconds last{0};
    for (const std::string& file : files) last = std::max(last, written_at(file));
    return last;
}

// The scenes below the folder, by their paths; those in `only` of each folder in it, or all if it is empty.
std::vector<std::string> scenes_below(const fs::path& folder, std::string_view only) {
    std::vector<std::string> found;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        const fs::path& path = entry->path();
        const bool wanted = only.empty() ? path.stem() == path.parent_path().filename()  // others are variants of it
                                         : path.parent_path().filename() == only;
        if (wanted && has_extension(path.string(), "glib")) found.push_back(path.string());
    }
    ranges::sort(found, [](const std::string& a, const std::string& b) { return before(a, b); });
    return found;
}

// The first error that the program tells, with its place, or else what it says first.
std::string reason(const content::Ended& ended) {
    if (ended.too_long) return fmt::format("it takes longer than {} s", seconds);
    const std::string_view all = ended.output;
    const std::size_t error = all.find("error:"), before = error == all.npos ? all.npos : all.rfind('\n', error);
    const std::string_view from = all.substr(before == all.npos ? 0 : before + 1);
    const std::string line = utf8::printable(from.substr(0, from.find('\n')));
    return line.empty() ? "it could not be drawn" : line;
}

}  // namespace

std::string own_program() {
    std::error_code error;
    return fs::read_symlink("/proc/self/exe", error).string();
}

std::string_view ScenePictures::why(const std::string& scene) const {
    const auto found = tried_.find(scene);
    return found == tried_.end() ? std::string_view() : found->second.why;
}

std::optional<ScenePictures::Time> ScenePictures::written(const std::string& scene, bool& reads) {
    const auto known = read_.find(scene);
    if (known != read_.end() && last_written(known->second.files) == known->second.written)
        return known->second.written;
    if (!std::exchange(reads, false)) return std::nullopt;
    Read read{files_read_by(scene, {}), {}};
    read.files.push_back(scene);
    read.written = last_written(read.files);
    return (read_[scene] = std::move(read)).written;
}

std::string ScenePictures::look() {
    if (process_.running()) {
        const std::optional<content::Ended> ended = process_.poll();
        if (!ended) return {};
        std::string made = std::exchange(making_, {});
        const std::string file = thumbnail_file(folder_, made);
        if (ended->status == 0 && current(file, tried_[made].written)) return made;
        // Of a scene with errors, what was drawn is no picture.
        std::error_code error;
        fs::remove(file, error);
        tried_[made].why = reason(*ended);
        return made;
    }
    std::error_code error;
    bool reads = true;
    std::optional<Time> last;
    const auto lacks = [&](const std::string& scene) {
        const auto tried = tried_.find(scene);
        last = written(scene, reads);
        const bool again = last && (tried == tried_.end() || tried->second.written != *last);
        return again && !current(thumbnail_file(folder_, scene), *last);
    };
    const auto next = folder_.empty() ? wanted_.end() : ranges::find_if(wanted_, lacks);
    if (next == wanted_.end()) return {};
    making_ = *next;
    tried_[making_] = {*last, {}};
    fs::create_directories(folder_, error);
    // In the background, behind what the user does.
    process_.start({"nice", "-n", "10", program_, "render", making_, "-o", thumbnail_file(folder_, making_), "--size",
                    size, "--samples", "4", "--timeout", std::to_string(seconds)},
                   {.seconds = 2. * seconds, .most_output = 1 << 16, .captured = true});
    return {};
}

SampleScenes sample_scenes() {
    const fs::path folder = fs::path(own_program()).parent_path();  // PREFIX/bin, or build/KIND/bin
    for (const auto& [scenes, lessons] :
         {std::pair{folder / "../share/snell/scenes", folder / "../share/doc/snell/docs/teaching"},
          std::pair{folder / "../../../scenes", folder / "../../../docs/teaching"}}) {
        if (!is_folder(scenes.string())) continue;
        return {scenes_below(scenes.lexically_normal(), ""), scenes_below(lessons.lexically_normal(), "handout")};
    }
    return {};
}

}  // namespace snell
