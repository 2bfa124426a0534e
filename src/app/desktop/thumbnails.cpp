#include "src/app/desktop/thumbnails.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "parser/text/ranges.h"
#include "src/app/desktop/named_by.h"
#include "src/content/replace.h"
#include "src/content/whole_file.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

constexpr int most_pixels = 160;                // on a side
constexpr std::uintmax_t most_bytes = 1 << 20;  // of a file: far more than such a picture has

}  // namespace

std::string thumbnails_folder() {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    if (cache && *cache == '/') return std::string(cache) + "/snell/thumbnails";
    const char* home = std::getenv("HOME");
    return home && *home == '/' ? std::string(home) + "/.cache/snell/thumbnails" : std::string();
}

std::string thumbnail_file(const std::string& folder, const std::string& scene) {
    return named_by(folder, scene, "png");
}

void keep_thumbnail(const std::string& folder, const std::string& scene, const content::Image& picture,
                    const std::vector<std::string>& recent) {
    if (folder.empty()) return;
    std::error_code error;
    fs::create_directories(folder, error);
    content::replace_file(thumbnail_file(folder, scene), content::encode_png(picture));
    std::vector<fs::path> wanted{thumbnail_file(folder, scene)}, found;
    for (const std::string& path : recent) wanted.emplace_back(thumbnail_file(folder, path));
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (entry->path().extension() == ".png") found.push_back(entry->path());
    for (const fs::path& path : found)
        if (ranges::find(wanted, path) == wanted.end()) fs::remove(path, error);
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

}  // namespace snell
