#include "src/app/desktop/kept_scenes.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "parser/text/ranges.h"
#include "parser/text/words.h"
#include "src/content/files.h"
#include "src/content/replace.h"

namespace snell {

namespace {

namespace fs = std::filesystem;

// The file has the whole path.
std::string kept_file(const std::string& folder, const std::string& name) { return named_by(folder, name, "txt"); }

// Its own first line, what was chosen, an empty line, and what the text said.
std::string text_of(const std::string& name, const Remembered& kept) {
    return fmt::format("scene {}\n{}\n{}", utf8::printable(name), setup_text(kept.chosen), setup_text(kept.written));
}

}  // namespace

std::string kept_folder(const std::string& settings) {
    return settings.empty() ? settings : (fs::path(settings).parent_path() / "scenes").string();
}

std::string kept_name(const std::string& scene) {
    std::error_code error;
    const fs::path whole = fs::canonical(scene, error);
    return error ? fs::absolute(scene, error).lexically_normal().string() : whole.string();
}

Remembered read_kept(const std::string& folder, const std::string& scene) {
    if (folder.empty()) return {};
    const std::string name = kept_name(scene), file = kept_file(folder, name);
    std::error_code error;
    if (!fs::is_regular_file(file, error) || fs::file_size(file, error) > most_kept_bytes || error) return {};
    const std::string text = content::whole_file(file), begin = fmt::format("scene {}\n", utf8::printable(name));
    const std::size_t middle = text.find("\n\n", begin.size() - 1);
    if (!text.starts_with(begin) || middle == text.npos) return {};
    // An error is ignored: the file may only be removed earlier than others.
    fs::last_write_time(file, fs::file_time_type::clock::now(), error);
    return {read_setup(std::string_view(text).substr(0, middle)), read_setup(std::string_view(text).substr(middle))};
}

std::string write_kept(const std::string& folder, const std::string& scene, const Remembered& kept) {
    if (folder.empty()) return {};
    const std::string name = kept_name(scene), file = kept_file(folder, name);
    std::error_code error;
    // A pipe would wait for a reader.
    if (fs::exists(file, error) && !fs::is_regular_file(file, error)) return file + " is not a file";
    const std::string text = text_of(name, kept);
    if (kept == Remembered{} || text.size() > most_kept_bytes) {
        fs::remove(file, error);
        return {};
    }
    fs::create_directories(folder, error);
    const bool fresh = !fs::exists(file, error);
    std::string wrong = content::replace_file(file, text);
    if (fresh && wrong.empty()) remove_oldest(folder, ".txt", most_kept_scenes);
    return wrong;
}

std::string own_place(const char* variable, const std::string& at_home, const std::string& name) {
    const char* folder = std::getenv(variable);
    if (folder && *folder == '/') return std::string(folder) + name;
    const char* home = std::getenv("HOME");
    return home && *home == '/' ? home + at_home + name : std::string();
}

void remove_oldest(const std::string& folder, std::string_view extension, std::size_t most) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code gone;  // other windows may remove files at the same time
        const fs::file_time_type time = entry->last_write_time(gone);
        if (!gone && entry->path().extension() == extension) files.emplace_back(time, entry->path());
    }
    if (files.size() <= most) return;
    ranges::sort(files);
    files.resize(files.size() - most);
    for (const auto& [time, path] : files) fs::remove(path, error);
}

std::string named_by(const std::string& folder, std::string_view path, std::string_view extension) {
    std::uint64_t hash = 14695981039346656037U;  // FNV-1a
    for (const char byte : path) hash = (hash ^ static_cast<unsigned char>(byte)) * 1099511628211U;
    return fmt::format("{}/{:016x}.{}", folder, hash, extension);
}

}  // namespace snell
